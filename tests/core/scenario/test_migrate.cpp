// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/scenario/migrate.h"
#include "some_scenario.h"

using namespace palpate;
using namespace palpate::testing;
using scenario::Migration;

TEST_CASE("a container goes through the steps from its own version on, in order") {
  const std::vector<Migration> steps = {
      [](Container& c) { c.written_by += " 1 to 2"; },
      [](Container& c) { c.written_by += " 2 to 3"; },
      [](Container& c) { c.written_by += " 3 to 4, at " + std::to_string(c.version); }};
  Container old{"palpate", 2, "{}", {}, ""}, newest{"palpate", 4, "{}", {}, ""};

  scenario::migrate(steps, old);
  scenario::migrate(steps, newest);

  CHECK(old.written_by == " 2 to 3 3 to 4, at 3");
  CHECK(old.version == 4);
  CHECK(newest.written_by == "");
}

TEST_CASE("a file of every version ever released is kept and still plays") {
  for (int version = 1; version <= scenario::newest_version(); ++version) {
    CAPTURE(version);
    const Scenario kept =
        scenario::read(PALPATE_PUBLISHED "/v" + std::to_string(version) + ".palpate");

    World world(kept.scene);
    std::vector<HapticSample> hands(kept.scene.instruments.size());
    std::vector<HapticCommand> commands(hands.size());
    double force = 0.0;
    for (int i = 0; i <= 1000; ++i) {  // from 2 mm above the top to 5 mm inside
      for (HapticSample& hand : hands) {
        hand.position.z() = 0.03 + kept.scene.instruments[0].tool.radius + 0.002 - 7e-6 * i;
      }
      tick(kept.scene, hands, 1.0 / kept.scene.rate, world, commands);
      force = commands[0].force.z();
    }

    CHECK(kept.version == version);
    CHECK(kept.title == "Kept of version " + std::to_string(version));
    CHECK(force > 0.05);
    CHECK(!world.alarm);
  }
}

TEST_CASE("the kept file of the newest version is what is written today") {
  const std::string name = "/v" + std::to_string(scenario::newest_version()) + ".palpate";
  const Container kept =
      scenario::read_container(PALPATE_PUBLISHED + name, "palpate", scenario::newest_version());

  const Container today = scenario::pack(scenario::read(PALPATE_PUBLISHED + name));

  CHECK(today.content == kept.content);
  CHECK(today.arrays == kept.arrays);
}

TEST_CASE("what a file of one body had at the top is its first body and its first instrument") {
  const Container old = scenario::read_container(PALPATE_PUBLISHED "/v3.palpate", "palpate", 3);
  Container moved = old;
  scenario::migrate(scenario::migrations(), moved);

  CHECK(moved.version == scenario::newest_version());
  // and the four columns of each of the two laws that only a newer file can have
  CHECK(moved.arrays.size() == old.arrays.size() + 8);
  CHECK(moved.arrays.at("scene/bodies/0/tissue/mass") == old.arrays.at("scene/tissue/mass"));
  CHECK(moved.arrays.at("scene/bodies/0/rest_areas") == old.arrays.at("scene/rest_areas"));
  CHECK(moved.arrays.at("authored/notes") == old.arrays.at("authored/notes"));
  CHECK(contains(moved.content, R"("instruments":[{"coupling":{"force_max":3.0,)"));
  CHECK(scenario::unpack(old, "file").scene.bodies[0].substeps ==
        scenario::unpack(moved, "file").scene.bodies[0].substeps);
}

TEST_CASE("a file of several bodies gets the tables of later laws for each of them, empty") {
  Container moved = scenario::read_container(PALPATE_PUBLISHED "/v4.palpate", "palpate", 4);
  scenario::migrate(scenario::migrations(), moved);

  for (const char* body : {"0", "1"}) {
    for (const char* law : {"corotated", "neo_hookean"}) {
      const std::string table = std::string("scene/bodies/") + body + "/tissue/" + law;
      CHECK(moved.arrays.at(table + "/corners").bytes.empty());
      CHECK(moved.arrays.at(table + "/viscosity").bytes.empty());
    }
  }
  CHECK(contains(moved.content, R"("corotated_nodal_share":0.0)"));
}

TEST_CASE("a file whose bodies are no list, or hold no tissue, is refused and not filled in") {
  for (const char* bodies : {"7", "[7]", "[{}]", "[{\"tissue\": 7}]"}) {
    Container old = scenario::read_container(PALPATE_PUBLISHED "/v4.palpate", "palpate", 4);
    old.content = std::string("{\"scene\": {\"bodies\": ") + bodies + "}}";
    CHECK_THROWS_AS(scenario::unpack(old, "file"), FileError);
  }
}

TEST_CASE("a file that says it is older and has what only a newer one can have is refused") {
  Container old = scenario::read_container(PALPATE_PUBLISHED "/v3.palpate", "palpate", 3);
  const std::string begin = "\"scene\":{";
  REQUIRE(contains(old.content, begin));
  old.content.replace(old.content.find(begin), begin.size(), begin + "\"bodies\":[],");

  CHECK(contains(refusal([&] { scenario::unpack(old, "file"); }), "content.scene.bodies: got"));
}

TEST_CASE(
    "in a file of before there were pairs no bodies touch, and one that has some is refused") {
  Container old = scenario::read_container(PALPATE_PUBLISHED "/v5.palpate", "palpate", 5);
  CHECK(scenario::unpack(old, "file").scene.body_pairs.empty());
  const std::string begin = "\"scene\":{";
  old.content.replace(old.content.find(begin), begin.size(), begin + "\"body_pairs\":[],");

  CHECK(refusal([&] { scenario::unpack(old, "file"); }) ==
        "file: manifest.json: content.scene.body_pairs: got one in a file of version 5, expected "
        "none, which came with version 6");
}

TEST_CASE(
    "a file of before there were rigid bodies and scenery has none, and is refused with some") {
  const Container old = scenario::read_container(PALPATE_PUBLISHED "/v6.palpate", "palpate", 6);
  const Scene scene = scenario::unpack(old, "file").scene;
  CHECK(scene.rigid.empty());
  CHECK(scene.scenery.empty());
  CHECK(scene.fluid.density == 0.0);
  for (const std::string member : {"rigid", "scenery", "fluid"}) {
    Container changed = old;
    const std::string begin = "\"scene\":{";
    changed.content.replace(changed.content.find(begin), begin.size(),
                            begin + "\"" + member + "\":[],");
    CHECK(refusal([&] { scenario::unpack(changed, "file"); }) ==
          "file: manifest.json: content.scene." + member +
              ": got one in a file of version 6, expected none, which came with version 7");
  }
}

// Run once for every new version, see tests/scenes/published/README.md.
TEST_CASE("publish the file to keep of the newest version" * doctest::skip()) {
  const std::string version = std::to_string(scenario::newest_version());
  Scenario made = make_scenario();
  made.title = "Kept of version " + version;
  made.scene = make_stone_scene();

  scenario::write(PALPATE_PUBLISHED "/v" + version + ".palpate", made);
}
