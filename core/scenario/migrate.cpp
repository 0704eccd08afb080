// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/migrate.h"

#include <array>

#include "palpate/scenario/json_fields.h"
#include "palpate/scenario/scenario.h"
#include "palpate/scenario/table_array.h"
#include "palpate/scenario/tables.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/model/private/law_tables.h"

namespace palpate::scenario {
namespace {

/// Gives the tissue of one body, arrays of which lie in `folder`, the tables and numbers that files
/// of an earlier version could not hold: empty tables, and numbers as a new tissue has them. `body`
/// holds its numbers, or does not where the file is damaged.
template <int version>
void add_laws(const std::string& folder, Json& body, Arrays& arrays) {
  const bool has_tissue = body.is_object() && body.contains("tissue") && body["tissue"].is_object();
  laws::for_each_table([&]<class Table>(const Table& table) {
    if (table.version != version) return;
    using T = typename Table::Rows;
    const T usual;
    laws::for_each_column(table, laws::Overloaded{[&](const laws::Scalar<T>& number) {
                                                    if (has_tissue)
                                                      body["tissue"][number.field] =
                                                          usual.*number.value;
                                                  },
                                                  [](const laws::Derived<T>&) {},
                                                  [&](const auto& column) {
                                                    arrays.emplace(folder + "tissue/" + table.name +
                                                                       "/" + column.name,
                                                                   to_array(usual.*column.rows));
                                                  }});
  });
}

/// Of files that had one body, and no list of them.
template <int version>
void add_laws(Container& container) {
  Json content = parse_object(container.content, "", "content");
  Json none;
  add_laws<version>("scene/", content.contains("scene") ? content["scene"] : none,
                    container.arrays);
  container.content = content.dump();
}

/// Of files with a list of bodies.
template <int version>
void add_laws_to_bodies(Container& container) {
  Json content = parse_object(container.content, "", "content");
  const bool has_scene = content.contains("scene") && content["scene"].is_object();
  if (!has_scene || !content["scene"].contains("bodies")) return;
  Json& bodies = content["scene"]["bodies"];
  if (!bodies.is_array() || bodies.size() > kMostBodies) return;  // refused by the reader
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    add_laws<version>(name_folder(b), bodies[b], container.arrays);
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
  add_laws<4>(container);
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

/// Refuses a member that a file says to have had before there was such a thing.
void refuse_new(const Container& container, const Json& scene, const char* member, int version) {
  if (!scene.contains(member)) return;
  throw FileError("", "manifest.json: content.scene." + std::string(member),
                  "one in a file of version " + std::to_string(container.version),
                  "none, which came with version " + std::to_string(version));
}

/// Version 6 has pairs of bodies that touch; none of a file of before do.
void add_body_pairs(Container& container) {
  Json content = parse_object(container.content, "", "content");
  if (!content.contains("scene") || !content["scene"].is_object()) return;
  Json& scene = content["scene"];
  refuse_new(container, scene, "body_pairs", 6);
  scene["body_pairs"] = Json::array();
  container.content = content.dump();
}

/// Version 7 has rigid bodies, scenery and a fluid; scenes of a file of before have none.
void add_hard_parts(Container& container) {
  Json content = parse_object(container.content, "", "content");
  if (!content.contains("scene") || !content["scene"].is_object()) return;
  Json& scene = content["scene"];
  for (const char* member : {"rigid", "scenery", "fluid"}) refuse_new(container, scene, member, 7);
  scene["rigid"] = Json::array();
  scene["scenery"] = Json::array();
  scene["fluid"] = {{"density", 0.0}, {"viscosity", 0.0}};
  container.content = content.dump();
}

/// Version 2 has walls of prisms, and solids; version 3 linear solids; version 5 corotated and
/// neo-Hookean ones.
constexpr std::array<Migration, 6> kMigrations = {
    add_laws<2>,           add_laws<3>,    add_bodies_and_instruments,
    add_laws_to_bodies<5>, add_body_pairs, add_hard_parts};

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
