// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <optional>

#include "palpate/scenario/assessment_parts.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate::scenario {
namespace {

/// [m] Of the one capsule of a tool, or of each of its jaws; 0 of a ball.
double measure_length(const Tool& tool) {
  double length = 0.0;
  if (tool.jaws) return (tool.capsules[0].to - tool.capsules[0].from).norm();
  for (const Capsule& capsule : tool.capsules) length += (capsule.to - capsule.from).norm();
  return length;
}

/// What a tool may be called: a probe or a grasper may have any shape, the others their own.
constexpr std::initializer_list<const char*> kKinds = {"probe", "grasper", "ball", "laparoscope",
                                                       "syringe"};
constexpr int kGrasper = 1, kBall = 2, kLaparoscope = 3;

void check_kind(Fields& members, int kind, const Tool& tool) {
  if (kind == kBall && !tool.capsules.empty()) {
    members.refuse("kind", "a ball", "another kind: the instrument has a shaft or jaws");
  }
  if (kind > kBall && (tool.capsules.empty() || tool.jaws)) {
    members.refuse("kind", kKinds.begin()[kind],
                   tool.jaws ? "a grasper: the instrument has jaws"
                             : "a ball, a probe or a grasper: the instrument is a ball");
  }
}

/// Where an assessment says that the trocar is, is where the scene has it.
void check_trocar(Fields& members, const std::optional<Vec3>& trocar) {
  constexpr double kRounding = 1e-9;
  if (!members.has("trocar_m")) return;
  for (const char* other : {"trocar_height_m", "trocar_side_m"}) {
    if (members.has(other)) members.refuse(other, "one", "none of it beside trocar_m");
  }
  const Json& list = members.any("trocar_m");
  bool same = trocar && list.is_array() && list.size() == 3;
  for (int axis = 0; same && axis < 3; ++axis) {
    const Json& at = list[static_cast<std::size_t>(axis)];
    same = at.is_number() && std::abs(at.get<double>() - (*trocar)[axis]) <= kRounding;
  }
  if (same) return;
  members.refuse("trocar_m", describe(list),
                 trocar ? write_text("[", (*trocar)[0], ", ", (*trocar)[1], ", ", (*trocar)[2],
                                     "], that of the instrument")
                        : "none: the instrument has no trocar");
}

/// From the tip to the handle that a device shall be: nothing that a tick knows of.
void check_fulcrum(Fields& members, bool has_trocar) {
  constexpr double kLongest = 2.0;
  const double length = members.number_or("fulcrum_m", 0.0);
  if (!(length >= 0.0 && length <= kLongest)) {
    members.refuse("fulcrum_m", write_text(length), "0 to 2");
  }
  if (length > 0.0 && !has_trocar) {
    members.refuse("fulcrum_m", write_text(length),
                   "0: the instrument has no trocar to turn about");
  }
}

/// The optics of the laparoscope that ships (meshes/tools.toml): 30 degrees, the lens beside the
/// tip, which is where the axis of its capsule begins.
TaskCamera make_camera(int instrument, const Tool& tool) {
  constexpr double kTip = 0.0088, kLens = 0.0029;  // [m] from the capsule and to the lens
  const Vec3 forward(0.0, 0.5, -std::sqrt(0.75));
  return {.instrument = instrument,
          .at = Vec3(0.0, 0.0, tool.capsules[0].from.z() - kTip + kLens),
          .forward = forward,
          .field_of_view = 1.22};
}

/// What an assessment says of an instrument is that of the scene, which `palpate scenario publish`
/// sees to.
void check_tool(Fields& members, const Instrument& instrument) {
  const Tool& tool = instrument.tool;
  constexpr double kRounding = 1e-9, kHighest = 0.3, kFarthest = 0.3;
  const auto check = [&](const char* name, double scenes) {
    if (!members.has(name)) return;
    const double said = members.number(name);
    if (std::abs(said - scenes) <= kRounding) return;
    members.refuse(name, write_text(said), write_text(scenes, ", that of the instrument"));
  };
  check("radius_m", tool.radius);
  check("length_m", measure_length(tool));
  check("friction", tool.friction);
  check("jaw_opening_rad", tool.jaws ? tool.jaws->open : 0.0);
  if (tool.jaws) check("grip_force_N", tool.jaws->grip);
  check("force_max_N", instrument.coupling.force_max);
  check_trocar(members, instrument.trocar);
  check_fulcrum(members, instrument.trocar.has_value());
  const double height = members.number_or("trocar_height_m", 0.0);
  if (height < 0.0 || height > kHighest) {
    members.refuse("trocar_height_m", write_text(height), "0 to 0.3");
  }
  const double side = members.number_or("trocar_side_m", 0.0);
  if (!(std::abs(side) <= kFarthest)) {
    members.refuse("trocar_side_m", write_text(side), "-0.3 to 0.3");
  }
}

}  // namespace

void read_bodies_and_instruments(Fields& fields, const Scene& scene, const std::string& file,
                                 Names& names, DrawnTask& drawn) {
  const auto read = [&](const char* member, const char* number, std::size_t count, auto take) {
    for (auto& [id, members] : read_named(fields, member, count, file, kWhere)) {
      const auto last = static_cast<std::int64_t>(count) - 1;
      const bool stated = count > 1 || members.has(number);
      const int row = stated ? static_cast<int>(members.whole(number, 0, last)) : 0;
      take(id, row, members);
      members.finish();
    }
  };
  read("organs", "body", scene.bodies.size(),
       [&](const std::string& id, int row, Fields&) { names.bodies.emplace(id, row); });
  read("objects", "rigid", scene.rigid.size(),
       [&](const std::string& id, int row, Fields&) { names.objects.emplace(id, row); });
  read("tools", "instrument", scene.instruments.size(),
       [&](const std::string& id, int row, Fields& members) {
         names.instruments.emplace(id, row);
         const Instrument& instrument = scene.instruments[static_cast<std::size_t>(row)];
         const int kind = members.choice("kind", kKinds);
         if (kind == kGrasper) names.graspers.insert(id);
         check_kind(members, kind, instrument.tool);
         if (kind == kLaparoscope) {
           names.laparoscopes.insert(id);
           drawn.task.cameras.push_back(make_camera(row, instrument.tool));
         }
         check_tool(members, instrument);
       });
  if (names.bodies.empty()) fields.refuse("organs", "none", "at least one");
  if (names.instruments.empty()) fields.refuse("tools", "none", "at least one");
}

}  // namespace palpate::scenario
