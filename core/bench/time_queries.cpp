// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/time_queries.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include "palpate/bench/naive.h"
#include "palpate/bench/time_steps.h"
#include "palpate/bench/timing.h"

namespace palpate::bench {
namespace {

/// [m] The naive and the real form run different operations, so only rounding may differ.
constexpr double kAgreement = 1e-9;
constexpr double kRadius = 1.5e-3;
constexpr int kQueryCount = 256;
/// Queries of one kind are timed in batches: one takes less than the clock can tell.
constexpr int kBatch = 32;

struct Queries {
  Vec3Array from, to, beside;
};

/// Short segments across the surface and points up to 5 mm outside it, at random places.
Queries scatter_queries(const TissueModel& model) {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<std::size_t> pick(0, model.triangles.size() - 1);
  std::uniform_real_distribution<double> reach(0.0, 5e-3);
  Queries queries;
  for (int q = 0; q < kQueryCount; ++q) {
    const Triangle& t = model.triangles[pick(random)];
    const Vec3& a = model.rest_position[static_cast<std::size_t>(t[0])];
    const Vec3& b = model.rest_position[static_cast<std::size_t>(t[1])];
    const Vec3& c = model.rest_position[static_cast<std::size_t>(t[2])];
    const Vec3 middle = (a + b + c) / 3.0;
    const Vec3 normal = (b - a).cross(c - a).normalized();
    queries.from.push_back(middle + 2.5e-4 * normal);
    queries.to.push_back(middle - 2.5e-4 * normal);
    queries.beside.push_back(middle + reach(random) * normal);
  }
  return queries;
}

void compare_answers(const AabbTree& tree, std::span<const Vec3> x, const Queries& queries) {
  const auto triangles = tree.triangles();
  std::vector<int> found(triangles.size()), found_naively(triangles.size());
  for (std::size_t q = 0; q < kQueryCount; ++q) {
    const auto hit = find_segment_hit(tree, x, queries.from[q], queries.to[q]);
    const auto naive_hit = find_segment_hit_naively(triangles, x, queries.from[q], queries.to[q]);
    require_agreement("segment",
                      hit && naive_hit ? (hit->point - naive_hit->point).norm()
                                       : (hit.has_value() != naive_hit.has_value()),
                      kAgreement);
    require_agreement(
        "closest",
        std::abs(find_closest_point(tree, x, queries.beside[q])->distance -
                 find_closest_point_naively(triangles, x, queries.beside[q])->distance),
        kAgreement);
    const int count = find_in_sphere(tree, x, queries.beside[q], kRadius, found);
    const int naive_count =
        find_in_sphere_naively(triangles, x, queries.beside[q], kRadius, found_naively);
    require_agreement("sphere", std::abs(count - naive_count), 0.0);
  }
}

}  // namespace

std::vector<BenchRow> time_queries(const TissueModel& model, const BenchOptions& options) {
  const auto& x = model.rest_position;
  const auto& triangles = model.triangles;
  const AabbTree tree(x, triangles);
  const Queries queries = scatter_queries(model);
  std::vector<int> found(triangles.size()), found_naively(triangles.size());

  compare_answers(tree, x, queries);
  double sink = 0.0;  // results are used, so no call can be left out
  std::size_t next = 0;
  const auto batch = [&](auto&& one) {
    return [&, one] {
      for (int i = 0; i < kBatch; ++i) {
        next = (next + 1) % kQueryCount;
        sink += one(next);
      }
    };
  };
  const auto value = [](const auto& hit) { return hit ? hit->distance : 0.0; };

  std::vector<BenchRow> rows;
  rows.push_back(time_against(
      options, kBatch, batch([&](std::size_t q) {
        return value(find_segment_hit(tree, x, queries.from[q], queries.to[q]));
      }),
      batch([&](std::size_t q) {
        return value(find_segment_hit_naively(triangles, x, queries.from[q], queries.to[q]));
      })));
  rows.back().work = "segment";
  rows.back().physics = "0.5 mm across the surface; naive looks at every triangle";
  rows.push_back(time_against(
      options, kBatch,
      batch([&](std::size_t q) { return value(find_closest_point(tree, x, queries.beside[q])); }),
      batch([&](std::size_t q) {
        return value(find_closest_point_naively(triangles, x, queries.beside[q]));
      })));
  rows.back().work = "closest";
  rows.back().physics = "0-5 mm outside; naive looks at every triangle";
  rows.push_back(time_against(options, kBatch, batch([&](std::size_t q) {
                                return static_cast<double>(
                                    find_in_sphere(tree, x, queries.beside[q], kRadius, found));
                              }),
                              batch([&](std::size_t q) {
                                return static_cast<double>(find_in_sphere_naively(
                                    triangles, x, queries.beside[q], kRadius, found_naively));
                              })));
  rows.back().work = "sphere";
  rows.back().physics = "ball of 1.5 mm, 0-5 mm outside; naive looks at every triangle";
  if (!std::isfinite(sink)) throw std::logic_error("bench: a query returned no number");
  return rows;
}

BenchRow time_refit(const TissueModel& model, const BenchOptions& options) {
  const State moved = shake(model);
  AabbTree tree(model.rest_position, model.triangles);
  BenchRow row = time_against(
      options, 1, [&] { tree.refit(moved.position); },
      [&] { AabbTree(moved.position, model.triangles); });
  row.work = "refit";
  row.elements = static_cast<double>(model.triangles.size());
  row.physics = "boxes of all triangles after a step; naive builds the tree anew";
  return row;
}

}  // namespace palpate::bench
