// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/ranges.h"

#include <algorithm>
#include <array>
#include <string>

#include "palpate/scenario/table_array.h"
#include "palpate/scenario/tables.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate::scenario {
namespace {

// CONTAINER.md has the same table
constexpr std::array kRanges = {
    Range{"scene.instruments[i].tool.radius", "m", 1e-5, 0.2},
    Range{"scene.instruments[i].tool.stiffness", "N/m³", 1e3, 1e12},
    Range{"scene.instruments[i].coupling.stiffness", "N/m", 0.1, 1e6},
    Range{"scene.instruments[i].coupling.force_max", "N", 1e-3, 1e3},
    Range{"scene.instruments[i].hold_stiffness", "N/m", 1e-3, 1e6},
    Range{"scene.gravity", "m/s²", -1e3, 1e3},
    Range{"scene.rate", "Hz", 1.0, 2e4},
    Range{"scene.bodies[i].force_error", "N", 0.0, 10.0},
    Range{"scene.bodies[i].tissue.nodal_share", "-", 0.0, 1.0},
    Range{"scene.bodies[i].tissue.elastic_nodal_share", "-", 0.0, 1.0},
    Range{"scene.bodies[i].tissue.elastic_damping_time", "s", 0.0, 100.0},
    Range{"scene.bodies[i].tissue.pressure", "Pa", -1e6, 1e6},
    Range{"scene.bodies[i].tissue.drag", "1/s", 0.0, 1e6},
    Range{"scene/bodies/i/tissue/rest_position", "m", -10.0, 10.0},
    Range{"scene/bodies/i/tissue/mass", "kg", 1e-15, 1e3},
    Range{"scene/bodies/i/tissue/springs/rest_length", "m", 1e-9, 10.0},
    Range{"scene/bodies/i/tissue/springs/stiffness", "N/m", -1e12, 1e12},
    Range{"scene/bodies/i/tissue/springs/damping", "N s/m", -1e9, 1e9},
    Range{"scene/bodies/i/tissue/bonds/rest_length", "m", 1e-9, 10.0},
    Range{"scene/bodies/i/tissue/bonds/stiffness", "N/m", -1e12, 1e12},
    Range{"scene/bodies/i/tissue/bonds/damping", "N s/m", -1e9, 1e9},
    Range{"scene/bodies/i/tissue/angles/rest_cosine", "-", -1.0, 1.0},
    Range{"scene/bodies/i/tissue/angles/rest_length", "m", 1e-9, 10.0},
    Range{"scene/bodies/i/tissue/angles/bend_stiffness", "J or N", -1e9, 1e9},
    Range{"scene/bodies/i/tissue/angles/stretch_coupling", "N", -1e9, 1e9},
    Range{"scene/bodies/i/tissue/angles/bond_share", "N/m", -1e12, 1e12},
    Range{"scene/bodies/i/tissue/prisms/rest_difference", "m", -10.0, 10.0},
    Range{"scene/bodies/i/tissue/prisms/shear_stiffness", "N/m", -1e12, 1e12},
    Range{"scene/bodies/i/tissue/prisms/shear_damping", "N s/m", -1e9, 1e9},
    Range{"scene/bodies/i/tissue/volumes/rest_volume", "m³", 1e-20, 10.0},
    Range{"scene/bodies/i/tissue/volumes/bulk", "Pa", -1e13, 1e13},
    Range{"scene/bodies/i/tissue/elastic/lame", "Pa", -1e13, 1e13},
    Range{"scene/bodies/i/tissue/elastic/shear", "Pa", 1e-6, 1e13},
    Range{"scene/bodies/i/tissue/skin/weights", "-", -1e3, 1e3},
    Range{"scene/bodies/i/tissue/home", "N/m", 0.0, 1e12},
    Range{"scene/bodies/i/rest_areas", "m²", 0.0, 100.0},
};

const Range& find_range(std::string_view name) {
  return *std::find_if(kRanges.begin(), kRanges.end(),
                       [&](const Range& range) { return range.name == name; });
}

bool holds(const Range& range, double value) noexcept {
  return value >= range.least && value <= range.most;  // never true of NaN
}

[[noreturn]] void refuse_number(const Range& range, const std::string& where, double value) {
  refuse(where, write_text(value), write_text(range.least, " to ", range.most, " ", range.unit));
}

/// The name of a range with the number of a body or an instrument in place of its i.
std::string write_place(std::string_view name, std::size_t index) {
  const std::size_t at = std::min(name.find("[i]"), name.find("/i/"));
  if (at == std::string_view::npos) return std::string(name);
  return write_text(name.substr(0, at + 1), index, name.substr(at + 2));
}

void check_empty(const char* name, std::size_t count) {
  if (count != 0) refuse(name, write_text(count), "0, which is what a file holds");
}

void check_number(const char* name, double value, std::size_t index = 0) {
  const Range& range = find_range(name);
  if (!holds(range, value)) refuse_number(range, write_place(name, index), value);
}

template <class Row>
void check_table(const char* name, const std::vector<Row>& table, std::size_t body) {
  const Range& range = find_range(name);
  for (std::size_t at = 0; at < table.size(); ++at) {
    const auto check = [&](double value) {
      if (holds(range, value)) return;
      refuse_number(range, write_text(write_place(name, body), ": row ", at), value);
    };
    if constexpr (RowOf<Row>::columns == 0) {
      check(table[at]);
    } else {
      for (const double value : table[at]) check(value);
    }
  }
}

void check_instrument(const Instrument& instrument, std::size_t i) {
  check_number("scene.instruments[i].tool.radius", instrument.tool.radius, i);
  check_number("scene.instruments[i].tool.stiffness", instrument.tool.stiffness, i);
  check_number("scene.instruments[i].coupling.stiffness", instrument.coupling.stiffness, i);
  check_number("scene.instruments[i].coupling.force_max", instrument.coupling.force_max, i);
  check_number("scene.instruments[i].hold_stiffness", instrument.hold_stiffness, i);
}

void check_body(const SoftBody& body, std::size_t b) {
  const TissueModel& tissue = body.tissue;
  check_number("scene.bodies[i].force_error", body.force_error, b);
  check_number("scene.bodies[i].tissue.nodal_share", tissue.volumes.nodal_share, b);
  check_number("scene.bodies[i].tissue.elastic_nodal_share", tissue.elastic.nodal_share, b);
  check_number("scene.bodies[i].tissue.elastic_damping_time", tissue.elastic.damping_time, b);
  check_number("scene.bodies[i].tissue.pressure", tissue.pressure, b);
  check_number("scene.bodies[i].tissue.drag", tissue.drag, b);
  const auto check = [b](const std::string& name, const auto& table) {
    using Row = typename std::decay_t<decltype(table)>::value_type;
    if constexpr (std::is_same_v<typename RowOf<Row>::Number, double>) {
      check_table(name.c_str(), table, b);
    }
  };
  visit_body("scene/bodies/i/", body, check);
}

}  // namespace

std::span<const Range> list_ranges() noexcept { return kRanges; }

void check_ranges(const Scene& scene) {
  check_empty("scene.rigid", scene.rigid.size());
  check_empty("scene.scenery", scene.scenery.size());
  for (std::size_t i = 0; i < scene.instruments.size(); ++i) {
    check_instrument(scene.instruments[i], i);
  }
  for (const double g : scene.gravity) check_number("scene.gravity", g);
  check_number("scene.rate", scene.rate);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) check_body(scene.bodies[b], b);
}

}  // namespace palpate::scenario
