// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/migrate.h"

#include <array>

#include "palpate/scenario/json_fields.h"
#include "palpate/scenario/table_array.h"
#include "palpate/sim/model/private/law_tables.h"

namespace palpate::scenario {
namespace {

/// The tables and numbers that files of an earlier version could not hold: empty tables, and
/// numbers as a new tissue has them.
template <int version>
void add_laws(Container& container) {
  Json content = parse_object(container.content, "", "content");
  const bool has_tissue = content.contains("scene") && content["scene"].contains("tissue");
  laws::for_each_table([&]<class Table>(const Table& table) {
    if (table.version != version) return;
    using T = typename Table::Rows;
    const auto add = [&]<class Row>(const char* column, const std::vector<Row>& rows) {
      container.arrays.emplace(std::string("scene/tissue/") + table.name + "/" + column,
                               to_array(rows));
    };
    const T usual;
    laws::for_each_column(
        table, laws::Overloaded{[&](const laws::Scalar<T>& number) {
                                  if (!has_tissue) return;
                                  content["scene"]["tissue"][number.field] = usual.*number.value;
                                },
                                [](const laws::Derived<T>&) {},
                                [&](const auto& column) { add(column.name, usual.*column.rows); }});
  });
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

/// Version 2 has walls of prisms, and solids; version 3 linear solids.
constexpr std::array<Migration, 3> kMigrations = {add_laws<2>, add_laws<3>,
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
