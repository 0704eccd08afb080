// SPDX-License-Identifier: BSD-3-Clause
// The plain loop that every engine is measured against: springs over a list of edges, a force for
// each vertex inside the ball, symplectic Euler, double. Flags as when the quoted engines were
// measured (-O3 -march=native -ffast-math), which flatter it.
//
//     anchor BODY DT_MS [faces]     BODY of write_body.py; one line of JSON
//
// With `faces` the ball pushes triangles, not vertices: slower, and what it converges to is the
// measure for engines that touch surfaces or edges.
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "palpate/sim/tree/queries.h"

namespace {

struct Point {
  double x = 0.0, y = 0.0, z = 0.0;
};

/// Numbers of the file, in its order.
struct Body {
  double mass = 0.0, stiffness = 0.0, damping = 0.0, home = 0.0;
  double radius = 0.0, top = 0.0, depth = 0.0, press_time = 0.0, window = 0.0;
  int vertices = 0;
  std::vector<Point> rest;
  std::vector<int> edges, fixed, triangles;
};

/// [N/m] of the ball, per vertex.
constexpr double kContact = 1e3;
/// [m] of the coarsest shell, stretched.
constexpr double kLongestSide = 0.02;
/// [m] A displacement beyond it is a wreck.
constexpr double kLimit = 0.05;

template <class T>
std::vector<T> read_list(std::ifstream& file, std::size_t count) {
  std::vector<T> list(count);
  for (T& item : list) file >> item;
  return list;
}

Body read_body(const char* path) {
  std::ifstream file(path);
  Body b;
  std::size_t points = 0, edges = 0, fixed = 0, triangles = 0;
  file >> b.vertices >> points >> edges >> fixed >> triangles;
  file >> b.mass >> b.stiffness >> b.damping >> b.home >> b.radius >> b.top >> b.depth;
  file >> b.press_time >> b.window;
  const std::vector<double> x = read_list<double>(file, 3 * points);
  for (std::size_t i = 0; i < points; ++i) b.rest.push_back({x[3 * i], x[3 * i + 1], x[3 * i + 2]});
  b.edges = read_list<int>(file, 2 * edges);
  b.fixed = read_list<int>(file, fixed);
  b.triangles = read_list<int>(file, 3 * triangles);
  if (!file) {
    std::fprintf(stderr, "anchor: %s: no body\n", path);
    std::exit(1);
  }
  return b;
}

double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

class Loop {
 public:
  Loop(const Body& body, bool faces)
      : b_(body),
        faces_(faces),
        x(body.rest),
        v_(x.size()),
        f_(x.size()),
        inverse_(x.size(), 1.0 / body.mass) {
    for (const int i : b_.fixed) inverse_[static_cast<std::size_t>(i)] = 0.0;
    for (std::size_t e = 0; e < b_.edges.size(); e += 2) {
      const Point &p = end(e), &q = end(e + 1);
      length_.push_back(std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y) +
                                  (q.z - p.z) * (q.z - p.z)));
    }
  }

  /// Returns the force on the ball [N], downwards on the body.
  double step(double height, double dt) {
    std::fill(f_.begin(), f_.end(), Point());
    add_springs();
    const double pushed = faces_ ? push_faces(height) : push_vertices(height);
    move(dt);
    return pushed;
  }

 private:
  const Point& end(std::size_t e) const { return x[static_cast<std::size_t>(b_.edges[e])]; }

  void add_springs() {
    for (std::size_t e = 0; e < b_.edges.size(); e += 2) {
      const auto i = static_cast<std::size_t>(b_.edges[e]);
      const auto j = static_cast<std::size_t>(b_.edges[e + 1]);
      const double dx = x[j].x - x[i].x, dy = x[j].y - x[i].y, dz = x[j].z - x[i].z;
      const double l = std::sqrt(dx * dx + dy * dy + dz * dz), inverse = 1.0 / l;
      const double rate =
          ((v_[j].x - v_[i].x) * dx + (v_[j].y - v_[i].y) * dy + (v_[j].z - v_[i].z) * dz) *
          inverse;
      const double g = (b_.stiffness * (l - length_[e / 2]) + b_.damping * rate) * inverse;
      f_[i].x += g * dx, f_[i].y += g * dy, f_[i].z += g * dz;
      f_[j].x -= g * dx, f_[j].y -= g * dy, f_[j].z -= g * dz;
    }
  }

  double push_vertices(double height) {
    double pushed = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Point& p = x[i];
      const double dz = p.z - height, square = p.x * p.x + p.y * p.y + dz * dz;
      if (square >= b_.radius * b_.radius) continue;
      const double r = std::sqrt(square), g = kContact * (b_.radius - r) / r;
      f_[i].x += g * p.x, f_[i].y += g * p.y, f_[i].z += g * dz;
      pushed -= g * dz * (inverse_[i] > 0.0);
    }
    return pushed;
  }

  double push_faces(double height) {
    const palpate::Vec3 centre(0.0, 0.0, height);
    double pushed = 0.0;
    for (std::size_t t = 0; t < b_.triangles.size(); t += 3) {
      const std::array<std::size_t, 3> corners = {static_cast<std::size_t>(b_.triangles[t]),
                                                  static_cast<std::size_t>(b_.triangles[t + 1]),
                                                  static_cast<std::size_t>(b_.triangles[t + 2])};
      const auto at = [&](std::size_t c) {
        const Point& p = x[corners[c]];
        return palpate::Vec3(p.x, p.y, p.z);
      };
      if ((at(0) - centre).norm() > b_.radius + kLongestSide) continue;
      const auto found = palpate::find_closest_on_triangle(centre, at(0), at(1), at(2));
      if (found.distance >= b_.radius) continue;
      const palpate::Vec3 push =
          kContact * (b_.radius / found.distance - 1.0) * (found.point - centre);
      for (std::size_t c = 0; c < 3; ++c) {
        const double share = found.weights[static_cast<Eigen::Index>(c)];
        Point& f = f_[corners[c]];
        f.x += share * push.x(), f.y += share * push.y(), f.z += share * push.z();
        pushed -= share * push.z() * (inverse_[corners[c]] > 0.0);
      }
    }
    return pushed;
  }

  void move(double dt) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      Point& p = x[i];
      const Point& rest = b_.rest[i];
      const double q = dt * inverse_[i], move = inverse_[i] > 0.0 ? dt : 0.0;
      v_[i].x += q * (f_[i].x - b_.home * (p.x - rest.x));
      v_[i].y += q * (f_[i].y - b_.home * (p.y - rest.y));
      v_[i].z += q * (f_[i].z - b_.home * (p.z - rest.z));
      p.x += move * v_[i].x, p.y += move * v_[i].y, p.z += move * v_[i].z;
    }
  }

  const Body& b_;
  bool faces_;

 public:
  std::vector<Point> x;

 private:
  std::vector<Point> v_, f_;
  std::vector<double> inverse_, length_;
};

double percentile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1))];
}

/// [m] The largest displacement along z.
double measure_move(const Body& body, const Loop& loop) {
  double moved = 0.0;
  for (std::size_t i = 0; i < body.rest.size(); ++i) {
    moved = std::max(moved, std::abs(loop.x[i].z - body.rest[i].z));
  }
  return moved;
}

void press(const Body& body, double dt, bool faces) {
  std::printf("{\"engine\": \"plain loop\", \"vertices\": %d, \"dt_ms\": %g, ", body.vertices,
              1e3 * dt);
  Loop loop(body, faces);
  const int count = static_cast<int>(std::lround(body.press_time / dt));
  std::vector<double> costs;
  double force = 0.0;
  for (int i = 0; i < count; ++i) {
    const double height = body.top - body.depth * std::min((i + 1) * dt / body.press_time, 1.0);
    const double start = cpu_time();
    const double pushed = loop.step(height, dt);
    const double cost = cpu_time() - start;
    // often, for what blows up is soon no number, which these flags do not know
    if (i % 20 == 0 && measure_move(body, loop) > kLimit) {
      std::printf("\"why\": \"blew up at %.3f s\"}\n", i * dt);
      return;
    }
    if (i * dt < body.window) continue;
    costs.push_back(1e6 * cost);
    force += pushed;
  }
  force /= static_cast<double>(costs.size());
  std::printf("\"force\": %.6g, \"median_us\": %.6g, \"p99_us\": %.6g, \"steps\": %zu}\n", force,
              percentile(costs, 0.5), percentile(costs, 0.99), costs.size());
}

}  // namespace

int main(int count, char** words) {
  const double dt = count >= 3 ? 1e-3 * std::atof(words[2]) : 0.0;
  const bool faces = count == 4 && std::string(words[3]) == "faces";
  if (!(dt > 0.0 && dt < 0.02) || count > 3 + faces) {
    std::fprintf(stderr, "usage: anchor BODY DT_MS [faces]\n");
    return 2;
  }
  press(read_body(words[1]), dt, faces);
  return 0;
}
