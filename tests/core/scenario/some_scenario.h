// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "palpate/scenario/read.h"
#include "palpate/scenario/write.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/stones.h"
#include "scenes/tissues.h"

namespace palpate::testing {

using scenario::Array;
using scenario::Bytes;
using scenario::Container;
using scenario::Dtype;
using scenario::Scenario;

/// A prism between two triangles of a tissue, at rest as they lie.
inline Prisms make_prism(const TissueModel& tissue) {
  const std::array<int, 6> corners = {0, 1, 2, 3, 4, 5};
  const auto distance = [&](int a, int b) {
    return (tissue.rest_position[b] - tissue.rest_position[a]).norm();
  };
  std::array<double, 3> difference;
  for (int c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    difference[c] = distance(corners[i], corners[j + 3]) - distance(corners[j], corners[i + 3]);
  }
  return {{corners}, {difference}, {{1.0, 2.0, 3.0}}, {{0.1, 0.2, 0.3}}};
}

/// An organ with every table in use: springs and bonds, angles, prisms, home springs, held
/// particles, a tetrahedron, and a skin whose every vertex rides on the particle of its number.
inline Scene make_full_scene() {
  Scene scene;
  scene.bodies[0].tissue = scenes::make_molecular_organ(1, {.damping_ratio = 0.2, .drag = 2.0});
  scene.bodies[0].tissue.springs = scenes::make_spring_organ(1).springs;
  scene.bodies[0].tissue.prisms = make_prism(scene.bodies[0].tissue);
  scene.bodies[0].tissue.home.assign(scene.bodies[0].tissue.mass.size(), 20.0);
  const Vec3Array& x = scene.bodies[0].tissue.rest_position;
  std::array<int, 4> corners = {0, 1, 2, 4};
  double volume = compute_volume(x[0], x[1], x[2], x[4]);
  if (volume < 0.0) std::swap(corners[2], corners[3]);
  const int n = particle_count(scene.bodies[0].tissue);
  scene.bodies[0].tissue.volumes = build_volumes(n, {corners}, {std::abs(volume)}, {50.0}, 0.25);
  for (int i = 0; i < n; ++i) {
    scene.bodies[0].tissue.skin.corners.push_back({i, (i + 1) % n, (i + 2) % n, (i + 3) % n});
    scene.bodies[0].tissue.skin.weights.push_back({1.0, 0.0, 0.0, 0.0});
  }
  scene.bodies[0].tissue.damping_law = DampingLaw::isotropic;
  scene.instruments[0].tool = {.radius = 0.004, .stiffness = 2.5e7};
  scene.instruments[0].coupling = {.stiffness = 700.0, .force_max = 3.0};
  scene.instruments[0].hold_stiffness = 450.0;
  scene.gravity = {0.1, -0.2, -9.81};
  scene.rate = 800.0;
  return build_scene(std::move(scene));
}

/// make_full_scene() with a shell of springs 0.2 m beside its organ, and a finer instrument.
inline Scene make_pair_scene() {
  Scene scene = make_full_scene();
  SoftBody beside;
  beside.tissue = scenes::make_spring_organ(1);
  for (Vec3& x : beside.tissue.rest_position) x.x() += 0.2;
  beside.tissue.home.assign(beside.tissue.mass.size(), 50.0);
  beside.force_error = 1e-3;
  scene.bodies.push_back(std::move(beside));
  scene.instruments.push_back({.tool = {.radius = 0.002, .stiffness = 3e7, .friction = 0.25},
                               .coupling = {.stiffness = 600.0, .force_max = 2.0},
                               .hold_stiffness = 300.0});
  return build_scene(std::move(scene));
}

/// Two organs above each other that touch, the lower of which may fold as well.
inline Scene make_touching_scene() {
  Scene scene = make_pair_scene();
  SoftBody& lower = scene.bodies[1];
  for (Vec3& x : lower.tissue.rest_position) x += Vec3(-0.2, 0.0, -0.0604);
  lower.force_error = 0.0;
  lower.may_fold = true;
  scene.gravity = Vec3::Zero();  // under which the lower one sinks out of touch
  scene.body_pairs = {
      {.first = 1, .second = 0, .stiffness = 2e7, .damping = 0.2, .friction = 0.0625}};
  return build_scene(std::move(scene));
}

/// The same over a table that the lower one stops at, and beside them a stone in water that sinks
/// onto it.
inline Scene make_stone_scene() {
  constexpr double kTable = -0.0935;  // [m] 3 mm below the lower organ
  Scene scene = make_touching_scene();
  scene.gravity = {0.0, 0.0, -1.0};
  Scenery table;
  for (const double z : {kTable - 0.01, kTable}) {
    for (const auto& [x, y] : {std::pair{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}) {
      table.mesh.vertices.emplace_back(x, y, z);
    }
  }
  table.mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                          {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  table.bodies = {1};
  table.friction = 0.2;
  scene.scenery = {std::move(table)};
  RigidBody stone = scenes::make_stone(0.011);
  stone.position = {0.07, 0.01, kTable + 0.006};
  stone.orientation = Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, 3.0).normalized());
  stone.friction = 0.35;
  stone.stiffness = 2e7;
  stone.contact_stiffness = 800.0;
  scene.rigid = {std::move(stone)};
  scene.fluid = {.density = 1000.0, .viscosity = 1e-3};
  return build_scene(std::move(scene));
}

inline Scenario make_scenario() {
  Scenario made;
  made.title = "Böbrek";
  made.task = "Touch the organ and pull.";
  made.scene = make_full_scene();
  made.authored = R"({"name":"kidney","stages":[1,2.5,null]})";
  made.authored_arrays["mesh/vertices"] = {Dtype::f8, {1, 3}, Bytes(24, 0)};
  made.authored_arrays["notes"] = {Dtype::u1, {4}, {'n', 'o', 't', 'e'}};
  return made;
}

/// A folder of its own that is gone when the test is.
class Folder {
 public:
  explicit Folder(const char* name)
      : path_(std::filesystem::temp_directory_path() /
              ("palpate-" + std::string(name) + "-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

inline Bytes read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::string& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

/// The sentence with which `work` refuses a file.
template <class Work>
std::string refusal(Work work) {
  try {
    work();
  } catch (const FileError& problem) {
    return problem.what();
  }
  return "not refused";
}

/// The sentence with which `work` refuses an argument.
template <class Work>
std::string bad_argument(Work work) {
  try {
    work();
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "not refused";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace palpate::testing
