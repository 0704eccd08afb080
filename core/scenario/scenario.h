// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "palpate/scenario/container.h"
#include "palpate/sim/tick/scene.h"

namespace palpate::scenario {

inline constexpr std::size_t kMostTitleBytes = 200;
inline constexpr std::size_t kMostTaskBytes = 20000;
inline constexpr std::size_t kMostLanguages = 50;  ///< beside the one of title and task

// No limit of a machine: what one table in an operating theatre has room for.
inline constexpr std::size_t kMostBodies = 16;
inline constexpr std::size_t kMostBodyPairs =
    kMostBodies * (kMostBodies + 1) / 2;             ///< each two, and each with itself
inline constexpr std::size_t kMostInstruments = 16;  ///< as many as a record has room for
inline constexpr std::size_t kMostRigid = 16;        ///< stones and the like
inline constexpr std::size_t kMostScenery = 16;
// The meshes of all rigid bodies and scenery together: a table and a bone as a scan has them.
inline constexpr std::size_t kMostHardVertices = 20'000;
inline constexpr std::size_t kMostHardTriangles = 2 * kMostHardVertices;

// The largest tissue that a file may hold, all its bodies together: more than ticks 1000 times a
// second, and little enough that the longest search for its eigenvalues ends within 5 s.
inline constexpr std::size_t kMostParticles = 20'000;
inline constexpr std::size_t kMostTriangles =
    2 * kMostParticles;  ///< of the surface, angles, or prisms
inline constexpr std::size_t kMostLinks = 3 * kMostParticles;  ///< springs, or bonds
inline constexpr std::size_t kMostTetrahedra = 2 * kMostParticles;
/// Of linear solids, whose response is solved for.
inline constexpr std::size_t kMostElastic = 6000;

/// Title and task in one language, UTF-8.
struct Words {
  std::string title;
  std::string task;
};

/// What a trainee opens: a scene that ticks, what to do with it, and what it was made from.
struct Scenario {
  std::string title;            ///< UTF-8
  std::string task;             ///< what the trainee is asked to do, in words, UTF-8
  Scene scene;                  ///< as build_scene made it
  std::string authored = "{}";  ///< JSON: the designer's document, which only the editor reads
  Arrays authored_arrays;       ///< what belongs to it
  /// JSON: what is asked of a trainee and judged (assessment.h); empty where nothing is
  std::string assessment;
  Arrays assessment_arrays;  ///< of it: places/ID, the vertices of a region, (n,)
  int version = 0;           ///< filled by the reader: of the format, as the file had it
  std::string written_by;    ///< filled by the reader: which program and version wrote the file
  /// Title and task in further languages, by code ("tr", "pt-BR"); an empty one is not translated.
  std::map<std::string, Words, std::less<>> languages;
};

/// Title and task in a language: those of its code, else of the same language elsewhere ("tr" for
/// "tr-TR"), else those of the scenario itself, each by itself.
Words find_words(const Scenario& scenario, std::string_view language);

/// What is wrong with the code of a language, or none: two or three small letters, then parts of 1
/// to 8 letters or digits behind hyphens [BCP 47].
std::optional<std::string> find_language_problem(std::string_view code);

}  // namespace palpate::scenario
