// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/body_pairs.h"

#include <cstdint>
#include <string>

#include "palpate/scenario/scenario.h"

namespace palpate::scenario {
namespace {

/// One of a body with itself says that the body may fold. Readers of before know no friction.
Json print_pair(const BodyPair& pair) {
  Json printed = {{"bodies", {pair.first, pair.second}},
                  {"thickness", pair.thickness},
                  {"stiffness", pair.stiffness},
                  {"damping", pair.damping}};
  if (pair.friction > 0.0) printed["friction"] = pair.friction;
  return printed;
}

/// Which two bodies a pair is of, counted from 0.
void parse_members(Fields& fields, std::size_t count, BodyPair& pair) {
  const Json& bodies = fields.any("bodies");
  const auto is_body = [&](const Json& index) {
    return index.is_number_unsigned() && index.get<std::uint64_t>() < count;
  };
  if (!bodies.is_array() || bodies.size() != 2 || !is_body(bodies[0]) || !is_body(bodies[1])) {
    fields.refuse("bodies", bodies.is_array() ? bodies.dump().substr(0, 60) : describe(bodies),
                  "a list of 2 whole numbers from 0 to " + std::to_string(count - 1));
  }
  pair.first = bodies[0].get<int>();
  pair.second = bodies[1].get<int>();
}

}  // namespace

Json print_pairs(const Scene& scene) {
  Json printed = Json::array();
  for (const BodyPair& pair : scene.body_pairs) printed.push_back(print_pair(pair));
  return printed;
}

void parse_pairs(Fields& scene_fields, Scene& scene) {
  if (scene_fields.is_empty_list("body_pairs")) return;
  for (Fields& fields : scene_fields.objects("body_pairs", kMostBodyPairs)) {
    BodyPair pair;
    parse_members(fields, scene.bodies.size(), pair);
    pair.thickness = fields.number("thickness");
    pair.stiffness = fields.number("stiffness");
    pair.damping = fields.number("damping");
    pair.friction = fields.number_or("friction", 0.0);
    fields.finish();
    if (pair.first == pair.second) {
      scene.bodies[static_cast<std::size_t>(pair.first)].may_fold = true;
    }
    scene.body_pairs.push_back(pair);
  }
}

}  // namespace palpate::scenario
