// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/multirate/slow_tissue.h"

#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/multirate/private/exchange.h"

namespace palpate {
namespace {

/// [-] By which an interval may miss a whole number of ticks: rounding.
constexpr double kRounding = 1e-6;

double check_rate(double rate) {
  if (rate > 0.0 && std::isfinite(rate)) return rate;
  refuse("slow tissue: hand_rate", write_text(rate, " Hz"), "a positive number");
}

int check_ticks(int ticks) {
  if (ticks > 0) return ticks;
  refuse("slow tissue: ticks", write_text(ticks), "at least 1");
}

/// As build_scene refuses Scene::exchange_rate for.
const Scene& check_scene(const Scene& scene) {
  for (std::size_t i = 0; i < scene.instruments.size(); ++i) {
    const std::size_t count = scene.instruments[i].tool.capsules.size();
    if (count == 0) continue;
    refuse(write_text("slow tissue: instruments[", i, "].tool.capsules"), write_text(count),
           "none: between two exchanges a ball is felt");
  }
  const auto expect_none = [](const char* where, std::size_t count, const char* what) {
    if (count > 0) refuse(where, write_text(count), what);
  };
  const char* felt = "none: between two exchanges nothing but tissue is felt";
  expect_none("slow tissue: rigid", scene.rigid.size(), felt);
  expect_none("slow tissue: scenery", scene.scenery.size(), felt);
  expect_none("slow tissue: body_pairs", scene.body_pairs.size(),
              "none: between two exchanges bodies do not touch each other");
  return scene;
}

int count_tissue_ticks(double interval, double rate) {
  const double count = interval * rate;
  const double whole = std::round(count);
  if (whole >= 1.0 && std::abs(count - whole) <= kRounding * whole) return static_cast<int>(whole);
  refuse("slow tissue: interval",
         write_text(count, " ticks of the tissue, which has ", rate, " a second"),
         "a whole number of them");
}

}  // namespace

struct SlowTissue::Run {
  Run(const Scene& scene, double hand_rate, int ticks, LocalForceMode mode)
      : fast(check_scene(scene), mode, 1.0 / check_rate(hand_rate), check_ticks(ticks)),
        tissue_ticks(count_tissue_ticks(fast.ticks() * fast.step(), scene.rate)),
        slow(scene, tissue_ticks),
        exchange(slow.world()) {}

  FastSide fast;
  int tissue_ticks;  // in an interval
  SlowSide slow;
  Exchange exchange;
};

SlowTissue::SlowTissue(const Scene& scene, double hand_rate, int ticks, LocalForceMode mode)
    : run_(std::make_unique<Run>(scene, hand_rate, ticks, mode)) {}
SlowTissue::SlowTissue(SlowTissue&&) noexcept = default;
SlowTissue::~SlowTissue() = default;

std::vector<HapticCommand> SlowTissue::tick(std::span<const HapticSample> samples) {
  auto& [fast, tissue_ticks, slow, exchange] = *run_;
  const std::size_t count = fast.forces().size();
  if (samples.size() != count) {
    refuse("slow tissue: samples", write_text(samples.size()),
           write_text(count, ", one for each instrument"));
  }
  fast.follow(samples);
  if (fast.is_due()) {
    if (fast.has_told()) fast.take(exchange);
    fast.tell(exchange);
    slow.follow(exchange);
  }
  std::vector<HapticCommand> commands(count);
  fast.render(commands);
  return commands;
}

HapticCommand SlowTissue::tick(const HapticSample& sample) { return tick({&sample, 1}).front(); }

const LocalModel& SlowTissue::model(std::size_t instrument) const {
  return run_->fast.forces().at(instrument).model();
}
const Alarm& SlowTissue::alarm() const noexcept { return run_->slow.world().alarm; }
double SlowTissue::interval() const noexcept { return run_->fast.ticks() * run_->fast.step(); }
int SlowTissue::tissue_ticks() const noexcept { return run_->tissue_ticks; }

}  // namespace palpate
