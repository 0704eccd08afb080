// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/hard_parts.h"

#include "palpate/scenario/scenario.h"

namespace palpate::scenario {
namespace {

/// Its tables lie in scene/rigid/i.
Json print_rigid(const RigidBody& body) {
  const Quaternion& q = body.orientation;
  return {{"mass", body.mass},
          {"inertia", print_vector(body.inertia)},
          {"position", print_vector(body.position)},
          {"orientation", {q.x(), q.y(), q.z(), q.w()}},
          {"friction", body.friction},
          {"stiffness", body.stiffness},
          {"contact_stiffness", body.contact_stiffness}};
}

/// Its tables lie in scene/scenery/i.
Json print_scenery(const Scenery& scenery) {
  return {{"bodies", scenery.bodies}, {"friction", scenery.friction}};
}

RigidBody parse_rigid(Fields& fields) {
  RigidBody body;
  body.mass = fields.number("mass");
  body.inertia = parse_vector(fields, "inertia");
  body.position = parse_vector(fields, "position");
  body.orientation = Quaternion(fields.numbers("orientation", 4).data());
  body.friction = fields.number("friction");
  body.stiffness = fields.number("stiffness");
  body.contact_stiffness = fields.number("contact_stiffness");
  fields.finish();
  return body;
}

Scenery parse_scenery(Fields& fields, std::size_t bodies) {
  Scenery scenery;
  scenery.bodies = fields.indices("bodies", kMostBodies, bodies);
  scenery.friction = fields.number("friction");
  fields.finish();
  return scenery;
}

Fluid parse_fluid(Fields fields) {
  Fluid fluid;
  fluid.density = fields.number("density");
  fluid.viscosity = fields.number("viscosity");
  fields.finish();
  return fluid;
}

}  // namespace

Vec3 parse_vector(Fields& fields, const char* name) { return Vec3(fields.numbers(name, 3).data()); }

void print_hard_parts(const Scene& scene, Json& printed) {
  printed["rigid"] = Json::array();
  for (const RigidBody& body : scene.rigid) printed["rigid"].push_back(print_rigid(body));
  printed["scenery"] = Json::array();
  for (const Scenery& part : scene.scenery) printed["scenery"].push_back(print_scenery(part));
  printed["fluid"] = {{"density", scene.fluid.density}, {"viscosity", scene.fluid.viscosity}};
}

void parse_hard_parts(Fields& scene_fields, Scene& scene) {
  if (!scene_fields.is_empty_list("rigid")) {
    for (Fields& body : scene_fields.objects("rigid", kMostRigid)) {
      scene.rigid.push_back(parse_rigid(body));
    }
  }
  if (!scene_fields.is_empty_list("scenery")) {
    for (Fields& part : scene_fields.objects("scenery", kMostScenery)) {
      scene.scenery.push_back(parse_scenery(part, scene.bodies.size()));
    }
  }
  scene.fluid = parse_fluid(scene_fields.object("fluid"));
}

}  // namespace palpate::scenario
