// SPDX-License-Identifier: BSD-3-Clause
#include "border.h"

#include <algorithm>
#include <cmath>

namespace palpate::bindings {

namespace {

std::string text(double value) { return py::str(py::float_(value)).cast<std::string>(); }

}  // namespace

template <std::size_t N>
void require_below(std::span<const std::array<int, N>> rows, std::size_t count, const char* name) {
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const int i : rows[r]) {
      if (i < 0 || static_cast<std::size_t>(i) >= count) {
        refuse(std::string(name) + " " + std::to_string(r), "index " + std::to_string(i),
               "below " + std::to_string(count));
      }
    }
  }
}

void require_triangles(std::span<const Triangle> triangles, std::size_t particles) {
  require_below(triangles, particles, "triangles");
}

void require_links(const Links& links, std::size_t particles) {
  require_below(std::span<const std::array<int, 2>>(links.ends), particles, "links.ends");
  require_count("links.rest_length", links.rest_length.size(), links.ends.size());
  require_count("links.stiffness", links.stiffness.size(), links.ends.size());
  require_count("links.damping", links.damping.size(), links.ends.size());
}

void require_angles(const Angles& angles, std::size_t particles) {
  const std::size_t count = angles.corners.size();
  require_below(std::span<const Triangle>(angles.corners), particles, "angles.corners");
  require_count("angles.rest_cosine", angles.rest_cosine.size(), count);
  require_count("angles.rest_length", angles.rest_length.size(), count);
  require_count("angles.bend_stiffness", angles.bend_stiffness.size(), count);
  require_count("angles.stretch_coupling", angles.stretch_coupling.size(), count);
  require_count("angles.bond_share", angles.bond_share.size(), count);
}

namespace {

/// Whatever else the tables of a solid may have been built from, no list of what lies around
/// particles goes beyond the particles there are.
template <class Table>
void require_around(const char* name, const Table& table, std::size_t particles) {
  if (table.corners.empty() || table.first_around.size() <= particles + 1) return;
  refuse(name, std::to_string(table.first_around.size()) + " entries",
         std::to_string(particles + 1));
}

}  // namespace

void require_volumes(const Volumes& volumes, std::size_t particles) {
  const std::size_t count = volumes.corners.size();
  require_below(std::span<const std::array<int, 4>>(volumes.corners), particles, "volumes.corners");
  require_count("volumes.rest_volume", volumes.rest_volume.size(), count);
  require_count("volumes.bulk", volumes.bulk.size(), count);
  require_around("volumes.first_around", volumes, particles);
}

void require_elastic(const Elastic& elastic, std::size_t particles) {
  const std::size_t count = elastic.corners.size();
  require_below(std::span<const std::array<int, 4>>(elastic.corners), particles, "elastic.corners");
  require_count("elastic.lame", elastic.lame.size(), count);
  require_count("elastic.shear", elastic.shear.size(), count);
  require_around("elastic.first_around", elastic, particles);
}

void require_hyperelastic(const Hyperelastic& table, std::size_t particles) {
  const std::size_t count = table.corners.size();
  require_below(std::span<const std::array<int, 4>>(table.corners), particles, "table.corners");
  require_count("table.lame", table.lame.size(), count);
  require_count("table.shear", table.shear.size(), count);
  require_count("table.viscosity", table.viscosity.size(), count);
  require_around("table.first_around", table, particles);
}

void require_positive(const char* name, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) refuse(name, text(value), "a positive number");
}

void require_finite(const char* name, const Vec3& value) {
  if (!value.allFinite()) refuse(name, "a number that is not finite", "three finite numbers");
}

void require_pushes(std::span<const Push> pushes, std::size_t triangles) {
  for (const Push& push : pushes) {
    if (push.triangle < 0 || static_cast<std::size_t>(push.triangle) >= triangles) {
      refuse("push", "triangle " + std::to_string(push.triangle),
             "below " + std::to_string(triangles));
    }
  }
}

void require_fit(const TissueModel& model, const State& state) {
  require_count("state", state.position.size(), model.rest_position.size());
  require_count("state.internal", state.internal.size(), count_internal(model));
}

void require_fit(const TissueModel& model, const Guard& guard) {
  require_count("guard", guard.last_position.size(), model.rest_position.size());
  if (guard.torn_links.empty()) return;
  require_count("guard.torn_links", guard.torn_links.size(),
                model.springs.ends.size() + model.bonds.ends.size());
}

void require_fit(const AabbTree& tree, std::span<const Vec3> x) {
  if (tree.nodes().empty()) refuse("tree", "no triangles", "a tree built over a surface");
  require_triangles(tree.triangles(), x.size());
}

void require_fit(const Candidates& candidates, std::size_t triangles) {
  // the first `count` are in ascending order
  const int count = candidates.count;
  if (count > 0 && static_cast<std::size_t>(candidates.triangles[count - 1]) >= triangles) {
    refuse("candidates", "triangle " + std::to_string(candidates.triangles[count - 1]),
           "below " + std::to_string(triangles));
  }
}

void require_fit(const ToolState& tool, std::size_t triangles) {
  if (tool.carrier.triangle >= static_cast<int>(triangles)) {
    refuse("tool state", "a carrier on triangle " + std::to_string(tool.carrier.triangle),
           "below " + std::to_string(triangles));
  }
  for (int h = 0; h < tool.hold_count; ++h) {
    const int triangle = tool.holds[static_cast<std::size_t>(h)].triangle;
    if (triangle < 0 || static_cast<std::size_t>(triangle) >= triangles) {
      refuse("tool state", "a hold on triangle " + std::to_string(triangle),
             "below " + std::to_string(triangles));
    }
  }
  for (int k = 0; k < tool.patch_count; ++k) {
    const ToolState::PatchPoint& point = tool.patch[static_cast<std::size_t>(k)];
    if (point.body != 0 || static_cast<std::size_t>(point.triangle) >= triangles) {
      refuse("tool state",
             write_text("a patch on triangle ", point.triangle, " of surface ", point.body),
             write_text("below ", triangles, " of surface 0"));
    }
  }
}

bool is_built(const Scene& scene) {
  bool built = !scene.bodies.empty() && !scene.instruments.empty();
  for (const SoftBody& body : scene.bodies) {
    built = built && body.substeps >= 1 && body.rest_areas.size() == body.tissue.triangles.size();
  }
  return built;
}

void require_built(const Scene& scene) {
  if (!is_built(scene)) {
    refuse("scene", "one whose derived fields are empty", "the result of build_scene(scene)");
  }
}

void require_index(const char* name, int index, std::size_t count) {
  if (index < 0 || static_cast<std::size_t>(index) >= count) {
    refuse(name, std::to_string(index), "0 to " + std::to_string(count - 1));
  }
}

void require_fit(const SoftBody& body, const SoftState& state) {
  require_fit(body.tissue, state.tissue);
  require_count("world.tree", state.tree.triangles().size(), body.tissue.triangles.size());
  require_count("world.skin", state.skin.size(), body.tissue.skin.corners.size());
  require_fit(body.tissue, state.guard);
  require_pushes(state.load.pushes(), body.tissue.triangles.size());
}

void require_fit(const Scene& scene, const World& world) {
  require_built(scene);
  require_count("world.bodies", world.bodies.size(), scene.bodies.size());
  require_count("world.instruments", world.instruments.size(), scene.instruments.size());
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    require_fit(scene.bodies[b], world.bodies[b]);
    for (std::size_t i = 0; i < world.instruments.size(); ++i) {
      require_fit(world.pair(i, b).candidates, scene.bodies[b].tissue.triangles.size());
    }
  }
}

// used by more files than this
template void require_below<4>(std::span<const std::array<int, 4>>, std::size_t, const char*);

}  // namespace palpate::bindings
