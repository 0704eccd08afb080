// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/private/measure_stretch.h"
#include "palpate/sim/model/load.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// [s] For so long a link is stretched too far before it tears, and in so long its force fades
/// then.
inline constexpr double kTearTime = 5e-3, kTearFade = 50e-3;

/// What tears as one: a spring, a bond that no triangle carries, a triangle with its shares of
/// bonds, or a prism with both of its triangles. A bond without its part of an angle would leave a
/// triangle that nothing holds in shape.
struct TearPart {
  int link = -1;                         ///< springs before bonds
  std::array<int, 2> triangles{-1, -1};  ///< rows of Angles
  int prism = -1;                        ///< row of Prisms
  std::array<int, 6> corners{};          ///< particles
  int corner_count = 0;
};

/// The numbers of a Tear.
class TearMembers {
 protected:
  struct Rows {
    int link = 0, triangle = 0, prism = 0;  // first of each in the tables below
  };

  double limit_ = 0.0;  // [-] of the length at rest; 0: nothing tears
  long tick_ = -1;
  std::vector<TearPart> parts_;
  std::vector<int> first_around_, around_;  // parts around each particle, and the end
  std::vector<unsigned char> held_;         // per particle
  std::vector<unsigned char> is_torn_;      // per part
  std::vector<double> stretched_;           // [s] per part, for how long it has been
  std::vector<long> seen_at_;               // per part: the last tick in which it was watched
  std::vector<int> watched_;                // parts, in this tick

  std::vector<int> torn_;  // parts
  std::vector<double> damage_;
  std::vector<Rows> rows_;
  Links links_;  // of what has torn, with constants times its damage
  Angles angles_;
  Prisms prisms_;
  std::vector<unsigned char> torn_triangles_;          // per row of Angles
  std::vector<std::array<double, 3>> side_stiffness_;  // [N/m] per row of Angles
  std::vector<std::array<int, 3>> side_bond_;          // likewise; -1 of none
  std::vector<int> sides_left_;                        // per bond
  std::vector<ParticleForce> forces_;  // of the particles of what has torn that move
  std::vector<unsigned char> pulled_;  // per particle: is among them
  Vec3Array scratch_;                  // [N] per particle
};

/// What of a body may tear and what has [contact: tear]. The tissue's model stays whole: forces
/// that are opposite to those of torn parts, by their own laws with their stiffness times the
/// damage at the same positions, cancel these in each substep. Damping stays.
class Tear : private TearMembers {
 public:
  Tear() = default;  ///< nothing tears
  /// What is longer than `stretch` [-] times its length at rest tears; nothing for 0.
  Tear(const TissueModel& tissue, double stretch);
  /// With the room of the other: neither allocates later.
  Tear(const Tear& other) : TearMembers(other) { reserve(); }
  Tear(Tear&&) noexcept = default;
  Tear& operator=(const Tear& other) { return *this = Tear(other); }
  Tear& operator=(Tear&&) noexcept = default;
  ~Tear() = default;

  bool may_tear() const noexcept { return limit_ > 0.0; }
  bool has_torn() const noexcept { return !torn_.empty(); }
  int torn_count() const noexcept { return static_cast<int>(torn_.size()); }
  /// [-] Of each that has torn, in the order in which they did: 0 to 1, of what it does not bear.
  std::span<const double> damage() const noexcept { return damage_; }
  const TearPart& torn_part(std::size_t which) const noexcept {
    return parts_[static_cast<std::size_t>(torn_[which])];
  }
  std::span<const unsigned char> torn_triangles() const noexcept { return torn_triangles_; }

  /// [-] Of each particle, of the part around it that bears least: 0 of what is whole, 1 of what
  /// bears nothing.
  void write_damage(std::span<float> damage) const noexcept;

  /// Begins a tick, in which nothing is watched yet but what is around what has torn.
  void begin_watch(long tick) noexcept;
  /// All that has this particle is measured at the end of the tick.
  void watch(int particle) noexcept;
  /// Calls take(particle) for all whose positions must be up to date; some come twice.
  template <class Take>
  void for_each_particle(Take take) const noexcept {
    for (const int p : watched_) {
      const TearPart& part = parts_[static_cast<std::size_t>(p)];
      for (int c = 0; c < part.corner_count; ++c) take(part.corners[static_cast<std::size_t>(c)]);
    }
  }

  /// [N] On the particles that move, in a substep that begins with the tissue at x [m].
  std::span<const ParticleForce> cancel(const TissueModel& tissue,
                                        std::span<const Vec3> x) noexcept;
  /// [J] That the model has at x and the tissue has not.
  double compute_energy(std::span<const Vec3> x) const noexcept;

  /// Ends a tick of dt [s] in which nothing was wrong: what was watched tears where it has been
  /// stretched for long enough, and what has torn fades. Marks the links in guard.torn_links.
  void grow(const TissueModel& tissue, std::span<const Vec3> x, double dt, Guard& guard) noexcept;

 private:
  void reserve();
  double measure(const TissueModel& tissue, const TearPart& part,
                 std::span<const Vec3> x) const noexcept;
  void tear(const TissueModel& tissue, int part, Guard& guard) noexcept;
  void fade(const TissueModel& tissue, std::size_t which) noexcept;
  void add_triangle(const TissueModel& tissue, int row, Guard& guard) noexcept;
};

/// Throws std::invalid_argument, naming `field`, where a tissue cannot tear at this stretch.
void check_tear(const TissueModel& tissue, double stretch, const std::string& field);

}  // namespace palpate
