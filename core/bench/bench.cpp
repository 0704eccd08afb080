// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/bench.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include "palpate/bench/naive.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/haptics/tick.h"
#include "palpate/sim/mesh/measure.h"

namespace palpate::bench {
namespace {

/// [m] The naive and the real form run different operations, so only rounding may differ.
constexpr double kAgreement = 1e-9;
constexpr int kQueryCount = 256;
constexpr int kAgreementSteps = 20;
/// Queries of one kind are timed in batches: one takes less than the clock can tell.
constexpr int kBatch = 32;

double thread_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double percentile(std::vector<double>& sorted, double p) {
  return sorted[std::min(sorted.size() - 1,
                         static_cast<std::size_t>(p * static_cast<double>(sorted.size())))];
}

/// Ours and the naive form in turns until the budget is used up; times are per `batch`-th part.
BenchRow time_against(const BenchOptions& options, int batch, const std::function<void()>& ours,
                      const std::function<void()>& naive) {
  std::vector<double> our_times, naive_times;
  double spent = 0.0;
  ours();
  naive();
  while (spent < options.budget || static_cast<int>(our_times.size()) < options.least_runs) {
    const double start = thread_time();
    ours();
    const double middle = thread_time();
    our_times.push_back((middle - start) / batch);
    spent += middle - start;
    // a naive form may be a hundred times dearer: a tenth as many runs still give a median
    if (our_times.size() % 10 == 1 || middle - start > 1e-3) {
      naive();
      naive_times.push_back((thread_time() - middle) / batch);
    }
  }
  std::sort(our_times.begin(), our_times.end());
  std::sort(naive_times.begin(), naive_times.end());
  BenchRow row;
  row.median = percentile(our_times, 0.5);
  row.p99 = percentile(our_times, 0.99);
  row.naive_median = percentile(naive_times, 0.5);
  row.ratio_to_naive = row.naive_median / row.median;
  return row;
}

double largest_difference(std::span<const Vec3> a, std::span<const Vec3> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = (a[i] - b[i]).norm();
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

void require_agreement(const std::string& work, double difference) {
  if (difference <= kAgreement) return;
  throw std::logic_error("bench: " + work + ": naive and real form end " +
                         std::to_string(difference) + " m apart, expected at most 1e-9 m");
}

TissueModel without_dashpots(TissueModel model) {
  std::fill(model.springs.damping.begin(), model.springs.damping.end(), 0.0);
  std::fill(model.bonds.damping.begin(), model.bonds.damping.end(), 0.0);
  return model;
}

/// A body in motion: every particle off its rest by a thousandth of the diagonal.
State shake(const TissueModel& model) {
  State state(model);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> offset(-1.0, 1.0);
  const double size = 1e-3 * compute_diagonal(model.rest_position);
  for (Vec3& x : state.position) x += size * Vec3(offset(random), offset(random), offset(random));
  for (const int i : model.fixed) {
    state.position[static_cast<std::size_t>(i)] = model.rest_position[static_cast<std::size_t>(i)];
  }
  return state;
}

BenchRow time_step(const std::string& work, const std::string& terms, const TissueModel& model,
                   double dt, const BenchOptions& options) {
  Load load;
  load.gravity = {0.0, 0.0, -9.81};
  State ours = shake(model);
  State naive = ours;
  for (int s = 0; s < kAgreementSteps; ++s) {
    step(model, load, dt, ours);
    step_naively(model, load, dt, naive);
  }
  require_agreement(work, largest_difference(ours.position, naive.position));

  BenchRow row = time_against(
      options, 1, [&] { step(model, load, dt, ours); },
      [&] { step_naively(model, load, dt, naive); });
  row.work = work;
  row.physics = terms + ", home, drag, gravity; symplectic Euler, reference kernel in double";
  return row;
}

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

std::vector<BenchRow> time_queries(const TissueModel& model, const BenchOptions& options) {
  const auto& x = model.rest_position;
  const auto& triangles = model.triangles;
  const AabbTree tree(x, triangles);
  const Queries queries = scatter_queries(model);
  std::vector<int> found(triangles.size()), found_naively(triangles.size());
  constexpr double kRadius = 1.5e-3;

  for (std::size_t q = 0; q < kQueryCount; ++q) {
    const auto hit = find_segment_hit(tree, x, queries.from[q], queries.to[q]);
    const auto naive_hit = find_segment_hit_naively(triangles, x, queries.from[q], queries.to[q]);
    require_agreement("segment", hit && naive_hit ? (hit->point - naive_hit->point).norm()
                                                  : (hit.has_value() != naive_hit.has_value()));
    require_agreement(
        "closest", std::abs(find_closest_point(tree, x, queries.beside[q])->distance -
                            find_closest_point_naively(triangles, x, queries.beside[q])->distance));
    const int count = find_in_sphere(tree, x, queries.beside[q], kRadius, found);
    const int naive_count =
        find_in_sphere_naively(triangles, x, queries.beside[q], kRadius, found_naively);
    require_agreement("sphere", std::abs(count - naive_count));
  }

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
  row.physics = "boxes of all triangles after a step; naive builds the tree anew";
  return row;
}

/// A tip 3 mm inside the highest vertex, as in the middle of a press.
HapticSample press_sample(const Scene& scene) {
  const auto& x = scene.tissue.rest_position;
  const auto highest = std::max_element(x.begin(), x.end(),
                                        [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  HapticSample sample;
  sample.position = *highest + Vec3(0.0, 0.0, scene.tool.radius - 3e-3);
  return sample;
}

/// The tick of a first program: every triangle a candidate, plain steps, nothing guarded.
void tick_naively(const Scene& scene, const HapticSample& sample, double dt, World& world) {
  world.candidates.count = find_in_sphere_naively(
      scene.tissue.triangles, world.tissue.position, world.tool.position,
      scene.tool.radius + kCandidateMargin + (sample.position - world.tool.position).norm(),
      world.candidates.triangles);
  for (int i = 0; i < world.candidates.count; ++i) {
    const auto slot = static_cast<std::size_t>(i);
    world.candidates.areas[slot] =
        scene.rest_areas[static_cast<std::size_t>(world.candidates.triangles[slot])];
  }
  for (int s = 0; s < world.substeps; ++s) {
    balance_tool(scene.tool, scene.coupling, sample.position, world.candidates,
                 scene.tissue.triangles, world.tissue.position, world.tool, world.load);
    step_naively(scene.tissue, world.load, dt / world.substeps, world.tissue);
  }
}

BenchRow time_tick(const std::string& work, const Scene& scene, const BenchOptions& options) {
  const double dt = 1.0 / scene.rate;
  HapticSample sample = press_sample(scene);
  World world(scene);
  // come from above and settle, then time the held press
  const Vec3 inside = sample.position;
  for (int i = 0; i <= 300; ++i) {
    sample.time = i * dt;
    sample.position = inside + Vec3(0.0, 0.0, std::max(0.0, 6e-3 * (1.0 - i / 200.0)));
    tick(scene, sample, dt, world);
  }
  if (world.alarm) throw std::logic_error("bench: " + work + ": the held press blew up");
  World naive_world = world;
  BenchRow row = time_against(
      options, 1, [&] { tick(scene, sample, dt, world); },
      [&] { tick_naively(scene, sample, dt, naive_world); });
  row.work = work;
  row.physics = "3 mm press held, " + std::to_string(world.substeps) + " substeps, " +
                std::to_string(world.load.push_count) +
                " contacts; naive searches every triangle and steps naively";
  return row;
}

}  // namespace

std::vector<BenchRow> run_bench(const Scene& mass_spring, const Scene& molecular,
                                const BenchOptions& options) {
  if (mass_spring.tissue.springs.ends.empty() || molecular.tissue.bonds.ends.empty() ||
      mass_spring.tissue.triangles != molecular.tissue.triangles) {
    throw std::invalid_argument(
        "run_bench: expected a mass-spring and a molecular scene on the same surface");
  }
  const double mss_dt = 1.0 / mass_spring.rate / mass_spring.substeps;
  const double mms_dt = 1.0 / molecular.rate / molecular.substeps;
  std::vector<BenchRow> rows;
  rows.push_back(
      time_step("mss_step", "springs", without_dashpots(mass_spring.tissue), mss_dt, options));
  rows.push_back(
      time_step("mss_dashpot_step", "springs with dashpots", mass_spring.tissue, mss_dt, options));
  rows.push_back(time_step("mms_step", "bonds, angles, stretch-bend",
                           without_dashpots(molecular.tissue), mms_dt, options));
  rows.push_back(time_step("mms_dashpot_step", "bonds with dashpots, angles, stretch-bend",
                           molecular.tissue, mms_dt, options));
  rows.push_back(time_refit(mass_spring.tissue, options));
  for (BenchRow& row : time_queries(mass_spring.tissue, options)) rows.push_back(std::move(row));
  rows.push_back(time_tick("mss_tick", mass_spring, options));
  rows.push_back(time_tick("mms_tick", molecular, options));
  for (BenchRow& row : rows) row.vertices = particle_count(mass_spring.tissue);
  return rows;
}

}  // namespace palpate::bench
