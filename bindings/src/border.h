// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "array.h"
#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/contact/tool.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/load.h"
#include "palpate/sim/tick/world.h"
#include "palpate/sim/tree/aabb_tree.h"

/// What must fit together before a kernel may run: kernels check nothing themselves.
/// Each throws std::invalid_argument naming the argument, what was found and what was expected.
namespace palpate::bindings {

/// Every index of a table below `count`.
template <std::size_t N>
void require_below(std::span<const std::array<int, N>> rows, std::size_t count, const char* name);
void require_triangles(std::span<const Triangle> triangles, std::size_t particles);
void require_links(const Links& links, std::size_t particles);
void require_angles(const Angles& angles, std::size_t particles);
void require_volumes(const Volumes& volumes, std::size_t particles);
void require_elastic(const Elastic& elastic, std::size_t particles);
void require_hyperelastic(const Hyperelastic& table, std::size_t particles);

void require_positive(const char* name, double value);
void require_finite(const char* name, const Vec3& value);
/// Barycentric pushes on triangles that exist.
void require_pushes(std::span<const Push> pushes, std::size_t triangles);
void require_fit(const TissueModel& model, const State& state);
void require_fit(const TissueModel& model, const Guard& guard);
/// Positions for every particle that the triangles of the tree name.
void require_fit(const AabbTree& tree, std::span<const Vec3> x);
void require_fit(const Candidates& candidates, std::size_t triangles);
void require_fit(const ToolState& tool, std::size_t triangles);
/// 0 to below `count`.
void require_index(const char* name, int index, std::size_t count);
bool is_built(const Scene& scene);
/// A scene that build_scene has filled in.
void require_built(const Scene& scene);
void require_fit(const SoftBody& body, const SoftState& state);
void require_fit(const Scene& scene, const World& world);

}  // namespace palpate::bindings
