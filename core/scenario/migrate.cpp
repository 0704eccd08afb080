// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/migrate.h"

#include <array>

#include "palpate/scenario/json_fields.h"
#include "palpate/scenario/table_array.h"

namespace palpate::scenario {
namespace {

/// A table that files of an earlier version could not hold, empty.
template <class Row>
void add_empty(const std::string& name, Container& container) {
  container.arrays.emplace("scene/tissue/" + name, to_array(std::vector<Row>()));
}

/// Version 2 has walls of prisms, and solids: their volumes, and the skin that rides on them.
void add_prisms_and_solids(Container& container) {
  add_empty<std::array<int, 6>>("prisms/corners", container);
  add_empty<std::array<double, 3>>("prisms/rest_difference", container);
  add_empty<std::array<double, 3>>("prisms/shear_stiffness", container);
  add_empty<std::array<double, 3>>("prisms/shear_damping", container);
  add_empty<std::array<int, 4>>("volumes/corners", container);
  add_empty<double>("volumes/rest_volume", container);
  add_empty<double>("volumes/bulk", container);
  add_empty<std::array<int, 4>>("skin/corners", container);
  add_empty<std::array<double, 4>>("skin/weights", container);
  Json content = parse_object(container.content, "", "content");
  if (content.contains("scene") && content["scene"].contains("tissue")) {
    content["scene"]["tissue"]["nodal_share"] = 0.0;
  }
  container.content = content.dump();
}

/// Version 3 has linear solids.
void add_linear_solids(Container& container) {
  add_empty<std::array<int, 4>>("elastic/corners", container);
  add_empty<double>("elastic/lame", container);
  add_empty<double>("elastic/shear", container);
  add_empty<int>("elastic/reach", container);
  Json content = parse_object(container.content, "", "content");
  if (content.contains("scene") && content["scene"].contains("tissue")) {
    content["scene"]["tissue"]["elastic_nodal_share"] = 0.0;
    content["scene"]["tissue"]["elastic_damping_time"] = 0.0;
  }
  container.content = content.dump();
}

/// Moves members of one JSON object into another, those that it has.
void move_members(std::initializer_list<const char*> names, Json& from, Json& to) {
  for (const char* name : names) {
    const auto at = from.find(name);
    if (at == from.end()) continue;  // missed by the reader
    to[name] = std::move(*at);
    from.erase(at);
  }
}

/// Version 4 has any number of bodies and instruments: what there was of each is the first.
void add_bodies_and_instruments(Container& container) {
  const std::string old_tissue = "scene/tissue/", old_areas = "scene/rest_areas";
  Arrays arrays;
  for (auto& [name, array] : container.arrays) {
    const bool of_body = name.starts_with(old_tissue) || name == old_areas;
    arrays.emplace(of_body ? "scene/bodies/0/" + name.substr(6) : name, std::move(array));
  }
  container.arrays = std::move(arrays);
  Json content = parse_object(container.content, "", "content");
  if (!content.contains("scene") || !content["scene"].is_object()) return;
  // no file of a version before has these: the reader refuses what stands beside them
  if (content["scene"].contains("bodies") || content["scene"].contains("instruments")) return;
  Json &scene = content["scene"], body = Json::object(), instrument = Json::object();
  move_members({"tissue", "substeps", "substeps_max", "force_error", "spectrum_stiffness",
                "spectrum_damping"},
               scene, body);
  move_members({"tool", "coupling", "hold_stiffness"}, scene, instrument);
  scene["bodies"] = Json::array({std::move(body)});
  scene["instruments"] = Json::array({std::move(instrument)});
  container.content = content.dump();
}

constexpr std::array<Migration, 3> kMigrations = {add_prisms_and_solids, add_linear_solids,
                                                  add_bodies_and_instruments};

}  // namespace

void migrate(std::span<const Migration> steps, Container& container) {
  const int newest = static_cast<int>(steps.size()) + 1;
  for (; container.version < newest; ++container.version) {
    steps[static_cast<std::size_t>(container.version) - 1](container);
  }
}

std::span<const Migration> migrations() noexcept { return kMigrations; }

int newest_version() noexcept { return static_cast<int>(migrations().size()) + 1; }

}  // namespace palpate::scenario
