// SPDX-License-Identifier: BSD-3-Clause
#include "workload.h"

#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>

namespace palpate::bench {
namespace {

void read_surface(const std::string& obj, Workload& work) {
  std::ifstream file(obj);
  std::string line, kind;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    words >> kind;
    if (kind == "v") {
      Vec3 p;
      words >> p.x() >> p.y() >> p.z();
      work.x.push_back(p);
    } else if (kind == "f") {
      Triangle t{};
      std::string corner;
      for (int& i : t) {
        words >> corner;
        i = std::stoi(corner) - 1;  // what stands behind a slash is not a position
      }
      work.triangles.push_back(t);
    }
    kind.clear();
  }
  if (work.triangles.empty()) throw std::runtime_error(obj + ": no triangles could be read");
}

/// Numbers that are the same everywhere, unlike those of the library's distributions.
class Dice {
 public:
  double number(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3 vector(double size) {
    const double a = number(-size, size), b = number(-size, size), c = number(-size, size);
    return {a, b, c};
  }

 private:
  std::mt19937 engine_{7};
};

/// A dent of some millimetres and a little noise, as pressing leaves it.
Vec3Array press(const Vec3Array& x, Dice& dice) {
  Vec3Array moved;
  for (const Vec3& p : x) {
    const double share = std::exp(-(p - x.front()).squaredNorm() / (0.008 * 0.008));
    moved.push_back(p - 3e-3 * share * Vec3::UnitZ() + dice.vector(1e-5));
  }
  return moved;
}

}  // namespace

Workload read_workload(const std::string& obj, int questions) {
  Workload work;
  read_surface(obj, work);
  Dice dice;
  work.moved = press(work.x, dice);
  for (int q = 0; q < questions; ++q) {
    const auto pick = dice.number(0.0, static_cast<double>(work.triangles.size()));
    const Triangle& t = work.triangles[static_cast<std::size_t>(pick)];
    const Vec3 &a = work.x[static_cast<std::size_t>(t[0])],
               &b = work.x[static_cast<std::size_t>(t[1])],
               &c = work.x[static_cast<std::size_t>(t[2])];
    double v = dice.number(0.0, 1.0), w = dice.number(0.0, 1.0);
    if (v + w > 1.0) {
      v = 1.0 - v;
      w = 1.0 - w;
    }
    const Vec3 on = a + v * (b - a) + w * (c - a), normal = (b - a).cross(c - a).normalized();
    const double middle = dice.number(-5e-4, 5e-4);
    work.from.push_back(on + (middle + 2.5e-4) * normal + dice.vector(5e-5));
    work.to.push_back(on + (middle - 2.5e-4) * normal + dice.vector(5e-5));
    work.beside.push_back(on + dice.number(0.0, 5e-3) * normal);
  }
  return work;
}

}  // namespace palpate::bench
