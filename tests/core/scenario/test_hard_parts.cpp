// SPDX-License-Identifier: BSD-3-Clause
// Files of scenes with rigid bodies and scenery.
#include <doctest/doctest.h>

#include <array>
#include <limits>

#include "some_scenario.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Scenario make_with_stone() {
  Scenario made = make_scenario();
  made.scene = make_stone_scene();
  return made;
}

/// Hashes of the world while the stone sinks, tick by tick; and how it has fared.
std::vector<std::uint64_t> sink_bits(const Scene& scene, RigidState& stone) {
  World world(scene);
  std::vector<std::uint64_t> bits;
  std::array<HapticSample, 2> hands;
  std::array<HapticCommand, 2> commands;
  hands[0].position = hands[1].position = {0.3, 0.0, 0.0};
  for (int i = 0; i < 400; ++i) {
    tick(scene, hands, 1.0 / scene.rate, world, commands);
    for (const std::uint64_t word : compute_hash(world)) bits.push_back(word);
  }
  REQUIRE_FALSE(world.alarm);
  stone = world.rigid[0];
  return bits;
}

/// What a reader says of a file whose content says `to` where it said `from`.
std::string refuse_content(const std::string& from, const std::string& to) {
  Container changed = scenario::pack(make_with_stone());
  const std::size_t at = changed.content.find(from);
  REQUIRE(at != std::string::npos);
  changed.content.replace(at, from.size(), to);
  return refusal([&] { scenario::unpack(changed, "file"); });
}

/// The same of one with another number in an array.
template <class T>
std::string refuse_number(const std::string& name, std::size_t at, T value) {
  Container changed = scenario::pack(make_with_stone());
  Array& array = changed.arrays.at(name);
  REQUIRE((at + 1) * sizeof(T) <= array.bytes.size());
  std::memcpy(array.bytes.data() + at * sizeof(T), &value, sizeof(T));
  return refusal([&] { scenario::unpack(changed, "file"); });
}

/// The same of one without rows in these arrays.
std::string refuse_empty(std::initializer_list<const char*> names) {
  Container changed = scenario::pack(make_with_stone());
  for (const char* name : names) {
    changed.arrays.at(name).shape[0] = 0;
    changed.arrays.at(name).bytes.clear();
  }
  return refusal([&] { scenario::unpack(changed, "file"); });
}

template <class Change>
std::string refuse_scene(Change change) {
  Scenario made = make_with_stone();
  change(made.scene);
  return bad_argument([&] { scenario::pack(made); });
}

}  // namespace

TEST_CASE("a stone sinks onto a table in a file that was read as it did before, bit for bit") {
  const Folder folder("stone");
  const Scenario made = make_with_stone();

  scenario::write(folder.file("stone.palpate"), made);
  const Scenario found = scenario::read(folder.file("stone.palpate"));

  const RigidBody &stone = found.scene.rigid[0], &was = made.scene.rigid[0];
  CHECK(stone.mesh.vertices == was.mesh.vertices);
  CHECK(stone.mesh.triangles == was.mesh.triangles);
  CHECK(stone.sphere_centres == was.sphere_centres);
  CHECK(stone.sphere_radii == was.sphere_radii);
  CHECK(stone.mass == was.mass);
  CHECK(stone.inertia == was.inertia);
  CHECK(stone.position == was.position);
  CHECK(stone.orientation.coeffs() == was.orientation.coeffs());
  CHECK(stone.friction == 0.35);
  CHECK(stone.stiffness == 2e7);
  CHECK(stone.contact_stiffness == 800.0);
  CHECK(found.scene.scenery[0].mesh.vertices == made.scene.scenery[0].mesh.vertices);
  CHECK(found.scene.scenery[0].bodies == std::vector<int>{1});
  CHECK(found.scene.scenery[0].friction == 0.2);
  CHECK(found.scene.fluid.density == 1000.0);
  CHECK(found.scene.fluid.viscosity == 1e-3);
  RigidState sunk, sunk_as_made;
  CHECK(sink_bits(found.scene, sunk) == sink_bits(made.scene, sunk_as_made));
  CHECK(sunk.position == sunk_as_made.position);
  CHECK(sunk.position.z() < was.position.z() - 1e-4);
  CHECK(scenario::pack(found).content == scenario::pack(made).content);
  CHECK(scenario::pack(found).arrays == scenario::pack(made).arrays);
}

TEST_CASE("a scene without stones and scenery says so in lists without entries") {
  const Container packed = scenario::pack(make_scenario());

  CHECK(contains(packed.content, R"("rigid":[])"));
  CHECK(contains(packed.content, R"("scenery":[])"));
  CHECK(contains(packed.content, R"("fluid":{"density":0.0,"viscosity":0.0})"));
  CHECK_FALSE(packed.arrays.contains("scene/rigid/0/mesh/vertices"));
}

TEST_CASE("what is wrong with a stone in a file is refused by its number") {
  const std::string content = "manifest.json: content.scene.";
  CHECK(contains(refuse_content("\"contact_stiffness\":800.0", "\"contact_stiffness\":\"hard\""),
                 content + "rigid[0].contact_stiffness: got \"hard\", expected a number"));
  CHECK(contains(refuse_content("\"contact_stiffness\":800.0", "\"contact_stiffness\":0"),
                 "scene.rigid[0].contact_stiffness: got 0, expected 0.1 to 1e+06 N/m"));
  CHECK(contains(refuse_content("\"friction\":0.35", "\"friction\":-1"),
                 "scene.rigid[0].friction: got -1, expected 0 to 2 -"));
  CHECK(contains(refuse_content("\"friction\":0.35", "\"friction\":0.35,\"colour\":1"),
                 content + "rigid[0]: got an unknown member \"colour\""));
  CHECK(contains(refuse_content("\"rigid\":[", "\"rigid\":[{},"),
                 content + "rigid[0].mass: got nothing"));
  CHECK(contains(refuse_content("\"rigid\":[", "\"stones\":["), content + "rigid: got nothing"));
  CHECK(contains(refuse_content("\"position\":[", "\"position\":[0,"),
                 content + "rigid[0].position: got a list of 4, expected a list of 3 numbers"));
  CHECK(contains(refuse_content("\"orientation\":[", "\"orientation\":[1,\"x\"],\"was\":["),
                 content + "rigid[0].orientation: got a list of 2, expected a list of 4 numbers"));
  CHECK(contains(refuse_content("\"density\":1000.0", "\"density\":1e9"),
                 "scene.fluid.density: got 1e+09, expected 0 to 20000 kg/m³"));
}

TEST_CASE("what is wrong with scenery in a file is refused by its number") {
  const std::string place = "manifest.json: content.scene.scenery[0]";
  for (const std::string bodies : {"[2]", "[-1]", "[0.5]", "[true]", "[18446744073709551615]"}) {
    CAPTURE(bodies);
    CHECK(contains(refuse_content("\"bodies\":[1],", "\"bodies\":" + bodies + ","),
                   place + ".bodies: got " + bodies +
                       ", expected a list of at most 16 whole numbers from 0 to 1"));
  }
  CHECK(contains(refuse_content("\"bodies\":[1],", "\"bodies\":[1,1],"),
                 "scenery[0].bodies: got body 1 again, expected each body once"));
  CHECK(contains(refuse_content("\"bodies\":[1],", "\"bodies\":{},"),
                 place + ".bodies: got an object"));
  CHECK(contains(refuse_number("scene/scenery/0/mesh/vertices", 2, 20.0),
                 "scene/scenery/0/mesh/vertices: row 0: got 20, expected -10 to 10 m"));
  CHECK(contains(refuse_number("scene/scenery/0/mesh/triangles", 0, 9),
                 "scene: scenery[0].mesh: mesh: triangle 0: got vertex 9, expected 0 to 7"));
  CHECK(contains(refuse_empty({"scene/scenery/0/mesh/vertices", "scene/scenery/0/mesh/triangles"}),
                 "scene: scenery[0].mesh: mesh: triangles: got none"));
  // the table is lifted into the organ that stops at it
  CHECK(contains(refuse_scene([](Scene& scene) {
                   for (Vec3& x : scene.scenery[0].mesh.vertices) x.z() += 0.02;
                 }),
                 "mm inside of"));
}

TEST_CASE("what is wrong with the hull or the mesh of a stone is refused") {
  const std::string folder = "scene/rigid/0/";
  CHECK(
      contains(refuse_empty({"scene/rigid/0/sphere_centres", "scene/rigid/0/sphere_radii"}),
               "rigid[0].sphere_radii: got 0 centres and 0 radii, expected as many of both, 1 to"));
  CHECK(contains(refuse_empty({"scene/rigid/0/sphere_radii"}), "got 14 centres and 0 radii"));
  CHECK(contains(refuse_empty({"scene/rigid/0/mesh/vertices", "scene/rigid/0/mesh/triangles"}),
                 "scene.rigid[0].mesh: got no triangles, expected a closed mesh"));
  CHECK(contains(refuse_number(folder + "sphere_radii", 3, 0.0),
                 folder + "sphere_radii: row 3: got 0, expected 1e-05 to 0.5 m"));
  CHECK(contains(refuse_number(folder + "sphere_centres", 3, kNone),
                 folder + "sphere_centres: row 1: got nan"));
  CHECK(contains(refuse_number(folder + "mesh/triangles", 1, -1),
                 "rigid[0].mesh: mesh: triangle 0: got vertex -1"));
  CHECK(contains(refuse_scene([](Scene& scene) {
                   for (Triangle& t : scene.rigid[0].mesh.triangles) std::swap(t[0], t[1]);
                 }),
                 "rigid[0].mesh: got a volume of -"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.rigid[0].mesh.triangles.pop_back(); }),
                 "rigid[0].mesh: got an open one, expected a closed one"));
  Container changed = scenario::pack(make_with_stone());
  changed.arrays.erase(folder + "sphere_radii");
  CHECK(contains(refusal([&] { scenario::unpack(changed, "file"); }),
                 folder + "sphere_radii: got no such array"));
  changed = scenario::pack(make_with_stone());
  changed.arrays["scene/rigid/1/sphere_radii"] = changed.arrays.at(folder + "sphere_radii");
  CHECK(contains(refusal([&] { scenario::unpack(changed, "file"); }),
                 "scene/rigid/1/sphere_radii: got an array of no known table"));
}

TEST_CASE("a stone or a scenery that no file can hold is refused before anything is written") {
  CHECK(contains(refuse_scene([](Scene& scene) { scene.rigid[0].mass = kNone; }),
                 "scene.rigid[0].mass: got nan, expected 1e-12 to 1000 kg"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.rigid[0].position.y() = kNone; }),
                 "scene.rigid[0].position: got nan"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.rigid[0].inertia.x() = 1.0; }),
                 "rigid[0].inertia [kg m^2]: got 1 about one axis"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.rigid[0].orientation.coeffs() *= 0.5; }),
                 "rigid[0].orientation [-]: got a norm of 0.5, expected a unit quaternion"));
  CHECK(contains(refuse_scene([](Scene& scene) {
                   scene.rigid.resize(scenario::kMostRigid + 1, scene.rigid[0]);
                 }),
                 "scene.rigid: got 17, expected 0 to 16"));
  CHECK(contains(refuse_scene([](Scene& scene) {
                   scene.scenery.resize(scenario::kMostScenery + 1, scene.scenery[0]);
                 }),
                 "scene.scenery: got 17, expected 0 to 16"));
  CHECK(contains(refuse_scene([](Scene& scene) {
                   scene.scenery[0].mesh.vertices.resize(scenario::kMostHardVertices);
                 }),
                 "scene.scenery[0].mesh: got 20042 vertices and"));
  CHECK(contains(refuse_scene([](Scene& scene) {
                   scene.bodies[0].tissue.elastic.corners = {{0, 1, 2, 3}};
                   scene.body_pairs.clear();
                 }),
                 "scene.bodies[0].tissue.elastic: got a linear solid that touches more"));
}
