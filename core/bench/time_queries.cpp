// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/time_queries.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include "palpate/bench/limits.h"
#include "palpate/bench/naive_tree.h"
#include "palpate/bench/time_steps.h"
#include "palpate/bench/timing.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tree/queries.h"

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

/// The same question to our tree and to the textbook one: a distance [m], or how many.
class Asker {
 public:
  Asker(const std::string& work, const TissueModel& model)
      : work_(work),
        x_(model.rest_position),
        tree_(x_, model.triangles),
        naive_(x_, model.triangles),
        queries_(scatter_queries(model)),
        found_(model.triangles.size()) {}

  double ask(std::size_t q) {
    if (work_ == "segment") {
      return value(palpate::find_segment_hit(tree_, x_, queries_.from[q], queries_.to[q]));
    }
    const Vec3& p = queries_.beside[q];
    if (work_ == "closest") return value(palpate::find_closest_point(tree_, x_, p));
    return palpate::find_in_sphere(tree_, x_, p, kRadius, found_);
  }
  double ask_naively(std::size_t q) {
    if (work_ == "segment") {
      return value(naive_.find_segment_hit(x_, queries_.from[q], queries_.to[q]));
    }
    const Vec3& p = queries_.beside[q];
    if (work_ == "closest") return value(naive_.find_closest_point(x_, p));
    return naive_.find_in_sphere(x_, p, kRadius, found_);
  }

 private:
  static double value(const std::optional<SurfacePoint>& hit) { return hit ? hit->distance : -1.0; }

  std::string work_;
  std::span<const Vec3> x_;
  AabbTree tree_;
  NaiveTree naive_;
  Queries queries_;
  std::vector<int> found_;
};

std::string describe(const std::string& work) {
  const std::string naive = "; naive asks a textbook tree of two boxes a node";
  if (work == "segment") return "0.5 mm across the surface" + naive;
  if (work == "closest") return "0-5 mm outside" + naive;
  return "ball of 1.5 mm, 0-5 mm outside" + naive;
}

/// [s] that following the surface takes at least: corners read, boxes compared and written.
double bound_refit(const AabbTree& tree) {
  if (simd_targets().empty()) return 0.0;
  const auto triangles = static_cast<double>(tree.triangles().size());
  const auto boxes = static_cast<double>(AabbTree::kWidth * tree.nodes().size());
  // a corner: least and most of three coordinates; a box within a box the same. Each is in double,
  // so one counts as two float operations
  const double operations = 2.0 * (18.0 * triangles + 6.0 * boxes);
  const double bytes = 12.0 * triangles + 12.0 * triangles + 24.0 * boxes;
  const Limits limits = measure_limits(simd_targets().front(), static_cast<std::size_t>(bytes));
  return compute_bound(limits, operations, bytes);
}

}  // namespace

BenchRow time_query(const std::string& work, const TissueModel& model,
                    const BenchOptions& options) {
  Asker asker(work, model);
  for (std::size_t q = 0; q < kQueryCount; ++q) {
    require_agreement(work, std::abs(asker.ask(q) - asker.ask_naively(q)), kAgreement);
  }
  double sink = 0.0;  // results are used, so no call can be left out
  std::size_t next = 0;
  const auto batch = [&](double (Asker::*ask)(std::size_t)) {
    return [&, ask] {
      for (int i = 0; i < kBatch; ++i) {
        next = (next + 1) % kQueryCount;
        sink += (asker.*ask)(next);
      }
    };
  };
  BenchRow row = time_against(options, kBatch, batch(&Asker::ask), batch(&Asker::ask_naively));
  row.work = work;
  row.physics = describe(work);
  if (!simd_targets().empty()) row.simd_target = simd_targets().front();
  if (!std::isfinite(sink)) throw std::logic_error("bench: " + work + ": returned no number");
  return row;
}

BenchRow time_refit(const TissueModel& model, const BenchOptions& options) {
  const State moved = shake(model);
  AabbTree tree(model.rest_position, model.triangles);
  NaiveTree naive(model.rest_position, model.triangles);
  tree.refit(moved.position);
  naive.refit(moved.position);
  require_agreement("refit",
                    (tree.low() - naive.low()).norm() + (tree.high() - naive.high()).norm(), 0.0);
  BenchRow row = time_against(
      options, 1, [&] { tree.refit(moved.position); }, [&] { naive.refit(moved.position); });
  row.work = "refit";
  row.elements = static_cast<double>(model.triangles.size());
  row.share_of_bound = bound_refit(tree) / row.median;
  if (!simd_targets().empty()) row.simd_target = simd_targets().front();
  row.physics = "boxes of all triangles after a step; naive follows with a textbook tree";
  return row;
}

}  // namespace palpate::bench
