// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "palpate/scenario/assessment_parts.h"
#include "palpate/scenario/table_array.h"

namespace palpate::scenario {
namespace {

constexpr std::size_t kMostPathPoints = 1000;
constexpr double kPathWidth = 0.003;  ///< [m] to both sides of a path, where none is said

std::vector<int> read_vertices(const Arrays& arrays, const std::string& file,
                               const std::string& id) {
  const std::string name = name_place_array(id);
  const auto at = arrays.find("places/" + id);
  if (at == arrays.end()) throw FileError(file, name, "no such array", "the region's vertices");
  if (!is_table<int>(at->second)) {
    throw FileError(file, name, "another shape or type", "(n) of <i4");
  }
  return to_table<int>(at->second);
}

Vec3 read_point(Fields& fields, const char* name, const Json& list, Parameters& parameters) {
  Vec3 point;
  for (Eigen::Index k = 0; k < 3; ++k) {
    point[k] = parameters.number(fields, name, list[static_cast<std::size_t>(k)]);
  }
  return point;
}

void read_path(Fields& fields, Parameters& parameters, TaskPlace& place) {
  const Json& list = fields.any("path");
  if (!list.is_array() || list.size() < 2 || list.size() > kMostPathPoints) {
    fields.refuse("path", describe(list), "a list of 2 to 1000 points [x, y, z]");
  }
  for (const Json& point : list) {
    if (!point.is_array() || point.size() != 3) {
      fields.refuse("path", describe(point), "points [x, y, z]");
    }
    place.points.push_back(read_point(fields, "path", point, parameters));
  }
  place.kind = PlaceKind::path;
  place.radius = parameters.number_or(fields, "within_m", kPathWidth);
}

/// Of a ball of an organ, or of a space of the scene.
void read_ball(Fields& fields, const char* name, Parameters& parameters, TaskPlace& place) {
  const Json& list = fields.any(name);
  if (!list.is_array() || list.size() != 4) {
    fields.refuse(name, describe(list), "[x, y, z, radius]");
  }
  place.points = {read_point(fields, name, list, parameters)};
  place.radius = parameters.number(fields, name, list[3]);
}

/// A ball of the organ that is so many times as stiff where it is drawn; the tables of that are
/// arrays, and what stands here is what they were made of.
void check_inclusion(Fields fields, Parameters& parameters) {
  const Json& list = fields.any("ball");
  if (!list.is_array() || list.size() != 4) {
    fields.refuse("ball", describe(list), "[x, y, z, radius]");
  }
  read_point(fields, "ball", list, parameters);
  const double radius = parameters.number(fields, "ball", list[3]);
  if (!(radius > 0.0)) fields.refuse("ball", describe(list), "a positive radius");
  const double times = parameters.number(fields, "stiffness");
  if (!(times > 0.0)) fields.refuse("stiffness", describe(Json(times)), "more than 0");
  fields.finish();
}

/// A place that is of no organ.
TaskPlace read_own_place(Fields fields, Parameters& parameters, const Names& names) {
  TaskPlace place;
  if (fields.has("object")) {
    place.kind = PlaceKind::object;
    const std::string object = fields.text("object", kMostIdBytes);
    place.body = find_row(fields, "object", object, names.objects, "an object of the scenario");
  } else {
    place.kind = PlaceKind::space;
    read_ball(fields, "space", parameters, place);
  }
  fields.finish();
  return place;
}

TaskPlace read_place(const std::string& id, Fields fields, const Arrays& arrays,
                     const std::string& file, Parameters& parameters, Names& names) {
  if (fields.has("object") || fields.has("space")) {
    return read_own_place(std::move(fields), parameters, names);
  }
  TaskPlace place;
  std::string organ;
  if (fields.has("region")) {
    const std::string region = fields.text("region", 2 * kMostIdBytes);
    organ = region.substr(0, region.find('/'));
    place.kind = PlaceKind::region;
    place.vertices = read_vertices(arrays, file, id);
  } else {
    if (!fields.has("organ")) {
      fields.refuse("region", "no place", "region, path, ball, object or space");
    }
    organ = fields.text("organ", kMostIdBytes);
    if (fields.has("path")) {
      read_path(fields, parameters, place);
    } else if (fields.has("ball")) {
      read_ball(fields, "ball", parameters, place);
    } else {
      fields.refuse("region", "no place", "region, path or ball");
    }
  }
  const char* says = place.kind == PlaceKind::region ? "region" : "organ";
  place.body = find_row(fields, says, organ, names.bodies, "an organ of the scenario");
  if (fields.has("inclusion")) {
    check_inclusion(fields.object("inclusion"), parameters);
    names.inclusions.emplace(id, place.body);
  }
  fields.finish();
  return place;
}

}  // namespace

void read_places(Fields& fields, const Arrays& arrays, const std::string& file,
                 const std::string& where, Parameters& parameters, Names& names, DrawnTask& drawn) {
  for (auto& [id, members] : read_named(fields, "places", kMostPlaces, file, where)) {
    names.places.emplace(id, static_cast<int>(drawn.places.size()));
    drawn.task.places.push_back(
        read_place(id, std::move(members), arrays, file, parameters, names));
    drawn.places.push_back(id);
  }
}

void read_inclusion(Fields& fields, Parameters& parameters, const Names& names, DrawnTask& drawn) {
  if (!fields.has("inclusion")) {
    if (names.inclusions.empty()) return;
    fields.refuse("inclusion", "nothing", "the place whose inclusion an attempt has");
  }
  drawn.inclusion = parameters.place(fields, "inclusion");
  drawn.inclusion_body =
      find_row(fields, "inclusion", drawn.inclusion, names.inclusions, "a place with an inclusion");
}

}  // namespace palpate::scenario
