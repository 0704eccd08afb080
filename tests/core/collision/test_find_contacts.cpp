// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/collision/moved_surface.h"
#include "palpate/sim/collision/private/held_kernels.h"
#include "palpate/sim/collision/private/nearest.h"
#include "palpate/sim/collision/private/surface_contacts.h"

using namespace palpate;

namespace {

constexpr Barrier kBarrier{4e-4, 5e6, 0.3};

/// The nearest of a list and where, one triangle after the other.
int find_plainly(const Vec3& p, std::span<const int> list, std::span<const Triangle> triangles,
                 std::span<const Vec3> x, NearPoint& nearest) {
  int best = -1;
  for (const int t : list) {
    const auto& [a, b, c] = triangles[static_cast<std::size_t>(t)];
    const NearPoint point =
        find_near_point(p, x[static_cast<std::size_t>(a)], x[static_cast<std::size_t>(b)],
                        x[static_cast<std::size_t>(c)]);
    if (best < 0 || is_nearer(point.square, point.height, nearest.square, nearest.height)) {
      best = t;
      nearest = point;
    }
  }
  return best;
}

/// Two balls, the upper one's lowest vertices `apart` [m] over the lower one.
struct Facing {
  explicit Facing(double apart, const Barrier& barrier = kBarrier)
      : lower(make_ball(3)),
        upper(make_ball(3)),
        x_lower(lower.rest_position),
        x_upper(upper.rest_position),
        tree(x_lower, lower.triangles),
        contacts(surface_of(upper), surface_of(lower), barrier) {
    for (Vec3& x : x_upper) x.z() += 0.04 + apart;
    renew_lists(x_upper, tree, x_lower, 0.0, contacts);
    find_near(x_upper, lower.triangles, x_lower, contacts);
  }
  void find(double travel) { find_contacts(x_upper, lower.triangles, x_lower, travel, contacts); }
  VertexContact find_alone(std::size_t k) const {
    const int vertex = contacts.active[k];
    return find_contact(contacts, vertex, x_upper[static_cast<std::size_t>(vertex)],
                        lower.triangles, x_lower, std::numeric_limits<double>::infinity());
  }

  TissueModel lower, upper;
  Vec3Array x_lower, x_upper;
  AabbTree tree;
  SurfaceContacts contacts;
};

constexpr double kUnknown = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("vector code finds the nearest of lists that plain code does, to the bit") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> spread(-1.0, 1.0);
  const auto draw = [&] { return Vec3(spread(random), spread(random), spread(random)); };
  for (const tree_kernels::Kernels* kernels : tree_kernels::available()) {
    CAPTURE(std::string(kernels->target));
    int slivers = 0;
    for (int round = 0; round < 500; ++round) {
      // a fan around one vertex, whose triangles share it and their edges
      Vec3Array x = {1e-4 * draw()};
      for (int k = 0; k < 6; ++k) {
        const double angle = k * 1.047;
        x.push_back(4e-3 * Vec3(std::cos(angle), std::sin(angle), 0.3 * spread(random)));
      }
      if (round % 10 == 0) x[2] = 0.5 * (x[0] + x[1]);
      std::vector<Triangle> triangles;
      for (int k = 0; k < 6; ++k) triangles.push_back({0, k + 1, (k + 1) % 6 + 1});
      const std::vector<int> order = {3, 1, 0, 5, 2, 4};
      std::array<Vec3, 4> points;
      tree_kernels::FourLists lists;
      for (std::size_t k = 0; k < 4; ++k) {
        points[k] = k == 3 ? Vec3(x[0] + Vec3(0.0, 0.0, 3e-4)) : Vec3(4e-3 * draw());
        lists.points[k] = &points[k];
        lists.triangles[k] = std::span(order).first(6 - k);
      }
      tree_kernels::FourNearest found;

      const unsigned healthy = kernels->find_nearest_listed(triangles, x, lists, found);

      for (std::size_t k = 0; k < 4; ++k) {
        if ((healthy >> k & 1U) == 0) {
          ++slivers;
          continue;
        }
        NearPoint point;
        const int nearest = find_plainly(points[k], lists.triangles[k], triangles, x, point);
        REQUIRE(found.triangle[k] == nearest);
        REQUIRE(found.square[k] == point.square);
        REQUIRE(found.height[k] == point.height);
        for (std::size_t c = 0; c < 3; ++c) {
          const auto i = static_cast<Eigen::Index>(c);
          REQUIRE(found.weights[c][k] == point.weights[i]);
          REQUIRE(found.offset[c][k] == point.offset[i]);
          REQUIRE(found.normal[c][k] == point.normal[i]);
        }
      }
    }
    CHECK(slivers > 0);
    CHECK(slivers < 400);
  }
}

TEST_CASE("contacts that are found together are those found one by one, to the bit") {
  Facing facing(-8e-4);
  facing.find(kUnknown);
  REQUIRE(facing.contacts.active_count > 4);
  for (std::size_t k = 0; k < facing.contacts.active_in_use().size(); ++k) {
    const VertexContact &together = facing.contacts.contact[k], alone = facing.find_alone(k);
    CHECK(together.triangle == alone.triangle);
    CHECK(together.gap == alone.gap);
    CHECK(together.weights == alone.weights);
    CHECK(together.normal == alone.normal);
  }
}

TEST_CASE("what cannot have come within the thickness is not looked at until it may have") {
  Facing facing(kBarrier.thickness + 1.5e-5);
  facing.find(kUnknown);
  const std::span<const int> active = facing.contacts.active_in_use();
  REQUIRE(!active.empty());
  constexpr double kStep = 1e-6;  // [m]
  int left_out = 0, within = 0;
  for (int step = 0; step < 40; ++step) {
    for (Vec3& x : facing.x_upper) x.z() -= kStep;
    facing.find(kStep);
    for (std::size_t k = 0; k < active.size(); ++k) {
      const VertexContact alone = facing.find_alone(k);
      const VertexContact& kept = facing.contacts.contact[k];
      if (alone.gap < kBarrier.thickness) {
        ++within;
        CHECK(kept.triangle >= 0);
        CHECK(kept.gap == doctest::Approx(alone.gap).epsilon(kHeldPart * kHeldPart));
      } else {
        left_out += kept.triangle < 0 ? 1 : 0;
      }
    }
  }
  CHECK(left_out > 0);
  CHECK(within > 0);

  // nothing is left out where they went fast, or nobody knows how far
  for (const double travel : {kBarrier.thickness, kUnknown}) {
    facing.find(travel);
    for (std::size_t k = 0; k < active.size(); ++k) {
      CHECK(facing.contacts.contact[k].gap == facing.find_alone(k).gap);
    }
  }
}

TEST_CASE("a contact that is held is the nearest to the square of how far it has slid") {
  Facing facing(-1.5e-5 + kBarrier.thickness);
  facing.find(kUnknown);
  const std::span<const int> active = facing.contacts.active_in_use();
  REQUIRE(!active.empty());
  const std::vector<VertexContact> first = facing.contacts.contact;
  const Vec3 step(1.5e-6, -1e-6, -1e-6);  // [m]
  int held = 0, found_again = 0;
  for (int k = 0; k < 60; ++k) {
    for (Vec3& x : facing.x_upper) x += step;
    facing.find(step.norm());
    for (std::size_t i = 0; i < active.size(); ++i) {
      const VertexContact alone = facing.find_alone(i);
      const VertexContact& kept = facing.contacts.contact[i];
      if (!(alone.gap < kBarrier.thickness) || first[i].triangle < 0) continue;
      REQUIRE(kept.triangle >= 0);
      // the point that was nearest is farther than the one that is by half the square of the angle
      CHECK(kept.gap <= alone.gap * (1.0 + 1e-9));
      CHECK(kept.gap >= alone.gap * (1.0 - kHeldPart * kHeldPart));
      CHECK((kept.normal - alone.normal).norm() < 1.5 * kHeldPart);
      (kept.normal == first[i].normal ? held : found_again) += 1;
    }
  }
  CHECK(held > 0);
  CHECK(found_again > 0);
}

TEST_CASE("a contact that is held pushes with minus the gradient of its energy") {
  Facing facing(0.5 * kBarrier.thickness);
  facing.find(kUnknown);
  const std::span<const int> active = facing.contacts.active_in_use();
  const auto add_up = [&](double way, bool force) {
    Facing moved = facing;
    for (Vec3& x : moved.x_upper) x.z() += way;
    moved.find(std::abs(way));
    double sum = 0.0;
    for (std::size_t k = 0; k < active.size(); ++k) {
      const VertexContact& contact = moved.contacts.contact[k];
      if (contact.triangle < 0) continue;
      const double area = moved.contacts.area[static_cast<std::size_t>(active[k])];
      sum += area * (force ? compute_pressure(kBarrier, contact.gap) * contact.normal.z()
                           : compute_barrier_energy(kBarrier, contact.gap));
    }
    return sum;
  };
  constexpr double kWay = 2e-7;  // [m]
  const double slope = (add_up(kWay, false) - add_up(-kWay, false)) / (2.0 * kWay);
  CHECK(add_up(1e-9, true) > 0.0);
  CHECK(-slope == doctest::Approx(add_up(1e-9, true)).epsilon(1e-4));
}

TEST_CASE("vector code follows and pushes held contacts as plain code does, to the bit") {
  Facing facing(1e-3, {2e-3, 5e6, 0.3});  // so thick that many vertices are within
  facing.find(kUnknown);
  Moved lower(facing.lower), upper(facing.upper);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> spread(-1.0, 1.0);
  for (Moved* moved : {&lower, &upper}) {
    for (Vec3& v : moved->velocity) v = Vec3(spread(random), spread(random), spread(random));
    for (Vec3& v : moved->touch.impulse) v = 0.1 * Vec3(spread(random), 0.0, spread(random));
  }
  std::vector<int> places;
  for (int k = 0; k < facing.contacts.active_count; ++k) {
    if (facing.contacts.contact[static_cast<std::size_t>(k)].triangle >= 0) places.push_back(k);
  }
  REQUIRE(places.size() > 4);
  REQUIRE(places.size() % 4 != 0);
  std::ranges::fill(facing.contacts.resistance, 2e-3);
  // some slide too far, and some come below the floor
  for (std::size_t v = 0; v < facing.x_upper.size(); ++v) {
    facing.x_upper[v] += (v % 3 == 0 ? 1e-4 : 1e-6) * Vec3(1.0, 1.0, 0.0);
    if (v % 5 == 0) facing.x_upper[v].z() -= 8.5e-4;
  }
  const TouchingSurface above{upper.tissue, facing.x_upper, upper.velocity, upper.touch};
  const TouchingSurface below{lower.tissue, facing.x_lower, lower.velocity, lower.touch};
  constexpr double kStep = 1e-3;  // [s]

  Facing plainly = facing;
  std::vector<int> lapsed(places.size(), 0);
  const std::size_t slid = held_kernels::plain().follow(
      facing.x_upper, facing.lower.triangles, facing.x_lower, places, plainly.contacts, lapsed);
  CHECK(slid > 0);
  CHECK(slid < places.size());
  unsigned stopped = 0;
  for (const held_kernels::Kernels* kernels : held_kernels::available()) {
    CAPTURE(std::string(kernels->target));
    Facing followed = facing;
    std::vector<int> also(places.size(), 0);
    REQUIRE(kernels->follow(facing.x_upper, facing.lower.triangles, facing.x_lower, places,
                            followed.contacts, also) == slid);
    CHECK(also == lapsed);
    for (std::size_t n = 0; n < places.size(); ++n) {
      const auto k = static_cast<std::size_t>(places[n]);
      REQUIRE(followed.contacts.contact[k].gap == plainly.contacts.contact[k].gap);
    }
    for (const bool has_impulse : {false, true}) {
      upper.touch.has_impulse = lower.touch.has_impulse = has_impulse;
      for (std::size_t n = 0; n < places.size(); ++n) {
        std::array<int, 4> four;
        for (std::size_t lane = 0; lane < four.size(); ++lane) {
          four[lane] = places[(n + lane) % places.size()];
        }
        const auto push = [&](const held_kernels::Kernels& of) {
          return of.push(kStep, above, below, plainly.contacts, four);
        };
        const held_kernels::FourForces expected = push(held_kernels::plain());
        const held_kernels::FourForces forces = push(*kernels);
        for (std::size_t lane = 0; lane < 4; ++lane) {
          REQUIRE(forces.force[lane] == expected.force[lane]);
        }
        REQUIRE(forces.stopped == expected.stopped);
        stopped |= forces.stopped;
      }
    }
  }
  CHECK(stopped != 0);
}
