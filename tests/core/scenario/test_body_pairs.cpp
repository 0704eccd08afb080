// SPDX-License-Identifier: BSD-3-Clause
// Files of bodies that touch each other.
#include <doctest/doctest.h>

#include <array>

#include "palpate/scenario/migrate.h"
#include "some_scenario.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

Scenario make_touching() {
  Scenario made = make_scenario();
  made.scene = make_touching_scene();
  return made;
}

/// A hand presses the upper organ. Hashes of the world, tick by tick, and how
/// many vertices touched in the last.
std::vector<std::uint64_t> press_bits(const Scene& scene, int& touching) {
  World world(scene);
  std::vector<std::uint64_t> bits;
  std::array<HapticSample, 2> hands;
  std::array<HapticCommand, 2> commands;
  hands[1].position = {0.3, 0.0, 0.0};
  for (int i = 0; i < 400; ++i) {
    hands[0].position = {0.001, 0.002, 0.038 - 3e-5 * i};
    tick(scene, hands, 1.0 / scene.rate, world, commands);
    for (const std::uint64_t word : compute_hash(world)) bits.push_back(word);
  }
  REQUIRE_FALSE(world.alarm);
  touching = world.body_pairs[0].touching;
  return bits;
}

/// What a reader says of a file whose content says `to` where it said `from`.
std::string refuse_content(const std::string& from, const std::string& to) {
  Container changed = scenario::pack(make_touching());
  const std::size_t at = changed.content.find(from);
  REQUIRE(at != std::string::npos);
  changed.content.replace(at, from.size(), to);
  return refusal([&] { scenario::unpack(changed, "file"); });
}

template <class Change>
std::string refuse_scene(Change change) {
  Scenario made = make_touching();
  change(made.scene);
  return bad_argument([&] { scenario::pack(made); });
}

}  // namespace

TEST_CASE("bodies that touch do so in a file that was read, bit for bit") {
  const Folder folder("touching");
  const Scenario made = make_touching();

  scenario::write(folder.file("touching.palpate"), made);
  const Scenario found = scenario::read(folder.file("touching.palpate"));

  REQUIRE(found.scene.body_pairs.size() == 2);
  for (std::size_t p = 0; p < 2; ++p) {
    const BodyPair &pair = found.scene.body_pairs[p], &was = made.scene.body_pairs[p];
    CHECK(pair.first == was.first);
    CHECK(pair.second == was.second);
    CHECK(pair.thickness == was.thickness);
    CHECK(pair.stiffness == was.stiffness);
    CHECK(pair.damping == was.damping);
    CHECK(pair.friction == was.friction);
  }
  CHECK(found.scene.body_pairs[0].stiffness == 2e7);
  CHECK(found.scene.body_pairs[0].friction == 0.0625);
  CHECK_FALSE(found.scene.bodies[0].may_fold);
  CHECK(found.scene.bodies[1].may_fold);
  int touching = 0, touching_as_made = 0;
  CHECK(press_bits(found.scene, touching) == press_bits(made.scene, touching_as_made));
  CHECK(touching > 0);
  CHECK(touching == touching_as_made);
  CHECK(scenario::pack(found).content == scenario::pack(made).content);
}

TEST_CASE("bodies of a file that says no friction slide on each other") {
  Container packed = scenario::pack(make_touching());
  // the one of the lower body with itself is written as all were before there was any
  CHECK(packed.content.find("\"friction\":0.0625") == packed.content.rfind("\"friction\":0.0625"));
  const std::string told = "\"friction\":0.0625,";
  const std::size_t at = packed.content.find(told);
  REQUIRE(at != std::string::npos);
  packed.content.erase(at, told.size());

  const Scenario found = scenario::unpack(packed, "file");

  for (const BodyPair& pair : found.scene.body_pairs) CHECK(pair.friction == 0.0);
  CHECK(scenario::pack(found).content == packed.content);
}

TEST_CASE("a scene whose bodies do not touch says that in a list without entries") {
  Scenario made = make_scenario();
  made.scene = make_pair_scene();
  const Container packed = scenario::pack(made);

  CHECK(contains(packed.content, R"("body_pairs":[])"));
  CHECK(scenario::unpack(packed, "file").scene.body_pairs.empty());
}

TEST_CASE("what is wrong with a pair in a file is refused by its number") {
  const std::string place = "manifest.json: content.scene.body_pairs[0]";
  for (const std::string bodies :
       {"[1,2]", "[1]", "[1,0,1]", "[1,-1]", "[1,0.5]", "[1,true]", "[1,18446744073709551615]"}) {
    CAPTURE(bodies);
    CHECK(contains(
        refuse_content("\"bodies\":[1,0]", "\"bodies\":" + bodies),
        place + ".bodies: got " + bodies + ", expected a list of 2 whole numbers from 0 to 1"));
  }
  CHECK(contains(refuse_content("\"bodies\":[1,0]", "\"bodies\":{}"),
                 place + ".bodies: got an object, expected a list of 2"));
  CHECK(contains(refuse_content("\"stiffness\":20000000.0", "\"stiffness\":\"hard\""),
                 place + ".stiffness: got \"hard\", expected a number"));
  CHECK(contains(refuse_content("\"stiffness\":20000000.0", "\"stiffness\":0"),
                 "scene.body_pairs[0].stiffness: got 0, expected 1000 to 1e+13 N/m³"));
  CHECK(contains(refuse_content("\"damping\":0.2", "\"damping\":2"),
                 "scene.body_pairs[0].damping: got 2, expected 0 to 1 -"));
  CHECK(contains(refuse_content("\"damping\":0.2", "\"damping\":0.2,\"width\":1"),
                 place + ": got an unknown member \"width\""));
  CHECK(contains(refuse_content("\"friction\":0.0625", "\"friction\":2.5"),
                 "scene.body_pairs[0].friction: got 2.5, expected 0 to 2 -"));
  CHECK(contains(refuse_content("\"friction\":0.0625", "\"friction\":-1"),
                 "scene.body_pairs[0].friction: got -1, expected 0 to 2 -"));
  CHECK(contains(refuse_content("\"friction\":0.0625", "\"friction\":\"wet\""),
                 place + ".friction: got \"wet\", expected a number"));
  CHECK(contains(refuse_content("\"body_pairs\":[", "\"unused\":["),
                 "content.scene.body_pairs: got nothing"));
  CHECK(contains(refuse_content("\"body_pairs\":[", "\"body_pairs\":[7,"),
                 place + ": got 7, expected an object"));
  // the pair of the lower body with itself, become one of both
  CHECK(contains(refuse_content("\"bodies\":[1,1]", "\"bodies\":[0,1]"),
                 "body_pairs[1]: got bodies 0 and 1 again, expected each pair once"));
}

TEST_CASE("a file whose bodies begin in each other is refused with how deep") {
  Container changed = scenario::pack(make_touching());
  scenario::Array& rest = changed.arrays.at("scene/bodies/1/tissue/rest_position");
  for (std::size_t at = 2 * sizeof(double); at < rest.bytes.size(); at += 3 * sizeof(double)) {
    double z = 0.0;
    std::memcpy(&z, rest.bytes.data() + at, sizeof(z));
    z += 0.001;
    std::memcpy(rest.bytes.data() + at, &z, sizeof(z));
  }
  const std::string sentence = refusal([&] { scenario::unpack(changed, "file"); });
  CHECK(contains(sentence, "file: scene: body_pairs[0]: got vertex"));
  CHECK(contains(sentence, "mm inside of body"));
}

TEST_CASE("a scene that no file can hold is refused before anything is written") {
  CHECK(contains(refuse_scene([](Scene& scene) { scene.body_pairs.pop_back(); }),
                 "scene.body_pairs: got 1, expected 2, one more for each body that may fold"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.body_pairs[0].thickness = 0.0; }),
                 "scene.body_pairs[0].thickness: got 0, expected 1e-05 to 0.005 m"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.bodies[1].force_error = 1e-3; }),
                 "force_error [N]: got 0.001"));
  CHECK(contains(refuse_scene([](Scene& scene) {
                   scene.bodies[0].tissue.elastic.corners = {{0, 1, 2, 3}};
                 }),
                 "scene.bodies[0].tissue.elastic: got a linear solid that touches more"));
}

TEST_CASE("as many pairs as a file may have are written and read") {
  Scene scene;
  for (std::size_t b = 0; b < scenario::kMostBodies; ++b) {
    SoftBody body;
    body.tissue = scenes::make_spring_organ(0);
    for (Vec3& x : body.tissue.rest_position) x.x() += 0.2 * double(b);
    body.may_fold = true;
    b == 0 ? void(scene.bodies[0] = std::move(body)) : scene.bodies.push_back(std::move(body));
    for (std::size_t other = 0; other < b; ++other) {
      scene.body_pairs.push_back({.first = int(other), .second = int(b)});
    }
  }
  Scenario made = make_scenario();
  made.scene = build_scene(std::move(scene));

  const Scenario found = scenario::unpack(scenario::pack(made), "file");

  CHECK(found.scene.body_pairs.size() == scenario::kMostBodyPairs);
  CHECK(found.scene.bodies.back().may_fold);
}
