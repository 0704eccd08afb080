// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/container.h"
#include "palpate/sim/haptics/scene.h"

namespace palpate::scenario {

inline constexpr std::size_t kMostTitleBytes = 200;
inline constexpr std::size_t kMostTaskBytes = 20000;

// The largest tissue that a file may hold: more than ticks 1000 times a second, and little enough
// that the longest search for its eigenvalues ends within 5 s.
inline constexpr std::size_t kMostParticles = 20'000;
inline constexpr std::size_t kMostTriangles =
    2 * kMostParticles;  ///< of the surface, angles, or prisms
inline constexpr std::size_t kMostLinks = 3 * kMostParticles;  ///< springs, or bonds
inline constexpr std::size_t kMostTetrahedra = 2 * kMostParticles;
/// Of linear solids, whose response is solved for.
inline constexpr std::size_t kMostElastic = 6000;

/// What a trainee opens: a scene that ticks, what to do with it, and what it was made from.
struct Scenario {
  std::string title;            ///< UTF-8
  std::string task;             ///< what the trainee is asked to do, in words, UTF-8
  Scene scene;                  ///< as build_scene made it
  std::string authored = "{}";  ///< JSON: the designer's document, which only the editor looks into
  Arrays authored_arrays;       ///< what belongs to it
  int version = 0;              ///< filled by the reader: of the format, as the file had it
  std::string written_by;       ///< filled by the reader: which program and version wrote the file
};

}  // namespace palpate::scenario
