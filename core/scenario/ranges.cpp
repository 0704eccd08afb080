// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/ranges.h"

#include <algorithm>
#include <string>

#include "palpate/scenario/table_array.h"
#include "palpate/scenario/tables.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate::scenario {
namespace {

void append_numbers(std::vector<Range>& ranges) {
  laws::for_each_table([&]<class Table>(const Table& table) {
    laws::for_each_column(
        table,
        laws::Overloaded{[&](const laws::Scalar<typename Table::Rows>& number) {
                           ranges.push_back({write_text("scene.bodies[i].tissue.", number.field),
                                             number.unit, number.least, number.most});
                         },
                         [](const auto&) {}});
  });
}

void append_columns(std::vector<Range>& ranges) {
  laws::for_each_table([&]<class Table>(const Table& table) {
    using T = typename Table::Rows;
    laws::for_each_column(
        table, laws::Overloaded{[&]<class Row>(const laws::Numbers<T, Row>& column) {
                                  ranges.push_back({write_text("scene/bodies/i/tissue/", table.name,
                                                               "/", column.name),
                                                    column.unit, column.least, column.most});
                                },
                                [](const auto&) {}});
  });
}

void append_hard_parts(std::vector<Range>& ranges) {
  ranges.push_back({"scene.rigid[i].mass", "kg", 1e-12, 1e3});
  ranges.push_back({"scene.rigid[i].inertia", "kg·m²", 1e-24, 1e4});
  ranges.push_back({"scene.rigid[i].position", "m", -10.0, 10.0});
  // a unit one, but for rounding
  ranges.push_back({"scene.rigid[i].orientation", "-", -1.001, 1.001});
  ranges.push_back({"scene.rigid[i].friction", "-", 0.0, 2.0});
  ranges.push_back({"scene.rigid[i].stiffness", "N/m³", 1e3, 1e12});
  ranges.push_back({"scene.rigid[i].contact_stiffness", "N/m", 0.1, 1e6});
  ranges.push_back({"scene.scenery[i].friction", "-", 0.0, 2.0});
  ranges.push_back({"scene.fluid.density", "kg/m³", 0.0, 2e4});
  ranges.push_back({"scene.fluid.viscosity", "Pa·s", 0.0, 1e3});
  ranges.push_back({"scene/rigid/i/mesh/vertices", "m", -1.0, 1.0});
  ranges.push_back({"scene/rigid/i/sphere_centres", "m", -1.0, 1.0});
  ranges.push_back({"scene/rigid/i/sphere_radii", "m", 1e-5, 0.5});
  ranges.push_back({"scene/scenery/i/mesh/vertices", "m", -10.0, 10.0});
}

// CONTAINER.md has the same table
std::vector<Range> build_ranges() {
  std::vector<Range> ranges;
  ranges.push_back({"scene.instruments[i].tool.radius", "m", 1e-5, 0.2});
  ranges.push_back({"scene.instruments[i].tool.stiffness", "N/m³", 1e3, 1e12});
  ranges.push_back({"scene.instruments[i].tool.friction", "-", 0.0, 2.0});
  ranges.push_back({"scene.instruments[i].tool.capsules", "m", -0.5, 0.5});
  ranges.push_back({"scene.instruments[i].tool.jaws.hinge", "m", -0.5, 0.5});
  ranges.push_back({"scene.instruments[i].tool.jaws.axis", "-", -1.0, 1.0});
  ranges.push_back({"scene.instruments[i].tool.jaws.open", "rad", 1e-3, 1.57});
  ranges.push_back({"scene.instruments[i].tool.jaws.grip", "N", 1e-3, 100.0});
  ranges.push_back({"scene.instruments[i].tool.jaws.pad_area", "m²", 1e-8, 1e-2});
  ranges.push_back({"scene.instruments[i].coupling.stiffness", "N/m", 0.1, 1e6});
  ranges.push_back({"scene.instruments[i].coupling.force_max", "N", 1e-3, 1e3});
  ranges.push_back({"scene.instruments[i].hold_stiffness", "N/m", 1e-3, 1e6});
  ranges.push_back({"scene.instruments[i].trocar", "m", -10.0, 10.0});
  ranges.push_back({"scene.instruments[i].pair_friction", "-", 0.0, 2.0});
  ranges.push_back({"scene.gravity", "m/s²", -1e3, 1e3});
  ranges.push_back({"scene.rate", "Hz", 1.0, 2e4});
  ranges.push_back({"scene.exchange_rate", "Hz", 10.0, 2e4});
  ranges.push_back({"scene.bodies[i].force_error", "N", 0.0, 10.0});
  ranges.push_back({"scene.bodies[i].contact.modulus", "Pa", 1.0, 1e9});
  ranges.push_back({"scene.body_pairs[i].thickness", "m", 1e-5, 5e-3});
  ranges.push_back({"scene.body_pairs[i].stiffness", "N/m³", 1e3, 1e13});
  ranges.push_back({"scene.body_pairs[i].damping", "-", 0.0, 1.0});
  ranges.push_back({"scene.body_pairs[i].friction", "-", 0.0, 2.0});
  append_hard_parts(ranges);
  append_numbers(ranges);
  ranges.push_back({"scene.bodies[i].tissue.pressure", "Pa", -1e6, 1e6});
  ranges.push_back({"scene.bodies[i].tissue.drag", "1/s", 0.0, 1e6});
  ranges.push_back({"scene/bodies/i/tissue/rest_position", "m", -10.0, 10.0});
  ranges.push_back({"scene/bodies/i/tissue/mass", "kg", 1e-15, 1e3});
  append_columns(ranges);
  ranges.push_back({"scene/bodies/i/tissue/home", "N/m", 0.0, 1e12});
  ranges.push_back({"scene/bodies/i/rest_areas", "m²", 0.0, 100.0});
  ranges.push_back({"scene/bodies/i/contact/far_compliance", "m/N", -1e4, 1e4});
  return ranges;
}

const Range& find_range(std::string_view name) {
  return *std::ranges::find(list_ranges(), name, &Range::name);
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

void check_number(const std::string& name, double value, std::size_t index = 0) {
  const Range& range = find_range(name);
  if (!holds(range, value)) refuse_number(range, write_place(name, index), value);
}

template <class Row>
void check_table(const char* name, const std::vector<Row>& table, std::size_t index) {
  const Range& range = find_range(name);
  for (std::size_t at = 0; at < table.size(); ++at) {
    const auto check = [&](double value) {
      if (holds(range, value)) return;
      refuse_number(range, write_text(write_place(name, index), ": row ", at), value);
    };
    if constexpr (RowOf<Row>::columns == 0) {
      check(table[at]);
    } else {
      for (const double value : table[at]) check(value);
    }
  }
}

/// Every table of numbers of what has this number.
struct TableCheck {
  std::size_t index;

  template <class Row>
  void operator()(const std::string& name, const std::vector<Row>& table) const {
    if constexpr (std::is_same_v<typename RowOf<Row>::Number, double>) {
      check_table(name.c_str(), table, index);
    }
  }
};

void check_jaws(const Tool& tool, std::size_t i) {
  if (!tool.jaws) return;
  const Jaws& jaws = *tool.jaws;
  for (const double at : jaws.hinge) check_number("scene.instruments[i].tool.jaws.hinge", at, i);
  for (const double at : jaws.axis) check_number("scene.instruments[i].tool.jaws.axis", at, i);
  check_number("scene.instruments[i].tool.jaws.open", jaws.open, i);
  check_number("scene.instruments[i].tool.jaws.grip", jaws.grip, i);
  check_number("scene.instruments[i].tool.jaws.pad_area", jaws.pad_area, i);
}

void check_instrument(const Instrument& instrument, std::size_t i) {
  check_number("scene.instruments[i].tool.radius", instrument.tool.radius, i);
  check_number("scene.instruments[i].tool.stiffness", instrument.tool.stiffness, i);
  check_number("scene.instruments[i].tool.friction", instrument.tool.friction, i);
  for (const Capsule& capsule : instrument.tool.capsules) {
    for (const Vec3& end : {capsule.from, capsule.to}) {
      for (const double at : end) check_number("scene.instruments[i].tool.capsules", at, i);
    }
  }
  check_jaws(instrument.tool, i);
  check_number("scene.instruments[i].coupling.stiffness", instrument.coupling.stiffness, i);
  check_number("scene.instruments[i].coupling.force_max", instrument.coupling.force_max, i);
  check_number("scene.instruments[i].hold_stiffness", instrument.hold_stiffness, i);
  for (const double mu : instrument.pair_friction) {
    check_number("scene.instruments[i].pair_friction", mu, i);
  }
  if (!instrument.trocar) return;
  for (const double at : *instrument.trocar) check_number("scene.instruments[i].trocar", at, i);
}

void check_body(const SoftBody& body, std::size_t b) {
  const TissueModel& tissue = body.tissue;
  check_number("scene.bodies[i].force_error", body.force_error, b);
  if (body.contact_modulus != 0.0) {
    check_number("scene.bodies[i].contact.modulus", body.contact_modulus, b);
  }
  visit_law_numbers(tissue, [b](const char* field, double number) {
    check_number(write_text("scene.bodies[i].tissue.", field), number, b);
  });
  check_number("scene.bodies[i].tissue.pressure", tissue.pressure, b);
  check_number("scene.bodies[i].tissue.drag", tissue.drag, b);
  const TableCheck check{b};
  visit_body("scene/bodies/i/", body, check);
  check("scene/bodies/i/contact/far_compliance", body.far_compliance);
}

void check_rigid(const RigidBody& body, std::size_t r) {
  check_number("scene.rigid[i].mass", body.mass, r);
  for (const double about : body.inertia) check_number("scene.rigid[i].inertia", about, r);
  for (const double at : body.position) check_number("scene.rigid[i].position", at, r);
  for (const double part : body.orientation.coeffs()) {
    check_number("scene.rigid[i].orientation", part, r);
  }
  check_number("scene.rigid[i].friction", body.friction, r);
  check_number("scene.rigid[i].stiffness", body.stiffness, r);
  check_number("scene.rigid[i].contact_stiffness", body.contact_stiffness, r);
  visit_rigid("scene/rigid/i/", body, TableCheck{r});
}

void check_scenery(const Scenery& part, std::size_t s) {
  check_number("scene.scenery[i].friction", part.friction, s);
  visit_scenery("scene/scenery/i/", part, TableCheck{s});
}

}  // namespace

const std::vector<Range>& list_ranges() {
  static const std::vector<Range> ranges = build_ranges();
  return ranges;
}

void check_ranges(const Scene& scene) {
  for (std::size_t i = 0; i < scene.instruments.size(); ++i) {
    check_instrument(scene.instruments[i], i);
  }
  for (const double g : scene.gravity) check_number("scene.gravity", g);
  check_number("scene.rate", scene.rate);
  if (scene.exchange_rate != 0.0) check_number("scene.exchange_rate", scene.exchange_rate);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    check_body(scene.bodies[b], b);
  }
  for (std::size_t r = 0; r < scene.rigid.size(); ++r) check_rigid(scene.rigid[r], r);
  for (std::size_t s = 0; s < scene.scenery.size(); ++s) check_scenery(scene.scenery[s], s);
  check_number("scene.fluid.density", scene.fluid.density);
  check_number("scene.fluid.viscosity", scene.fluid.viscosity);
  for (std::size_t p = 0; p < scene.body_pairs.size(); ++p) {
    const BodyPair& pair = scene.body_pairs[p];
    check_number("scene.body_pairs[i].thickness", pair.thickness, p);
    check_number("scene.body_pairs[i].stiffness", pair.stiffness, p);
    check_number("scene.body_pairs[i].damping", pair.damping, p);
    check_number("scene.body_pairs[i].friction", pair.friction, p);
  }
}

}  // namespace palpate::scenario
