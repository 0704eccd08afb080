// SPDX-License-Identifier: BSD-3-Clause
// Files of several bodies and instruments.
#include <doctest/doctest.h>

#include <array>

#include "palpate/scenario/migrate.h"
#include "some_scenario.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

Scenario make_pair() {
  Scenario made = make_scenario();
  made.scene = make_pair_scene();
  return made;
}

/// Hands that go into the two organs of make_pair_scene(), and the hash of what they leave.
std::vector<std::uint64_t> felt_bits(const Scene& scene) {
  World world(scene);
  std::vector<std::uint64_t> bits;
  std::array<HapticSample, 2> hands;
  std::array<HapticCommand, 2> commands;
  for (int i = 0; i < 300; ++i) {
    for (HapticSample& hand : hands) hand.position = {0.001, 0.002, 0.035 - 3e-5 * i};
    hands[1].position.x() += 0.2;
    tick(scene, hands, 1.0 / scene.rate, world, commands);
    for (const HapticCommand& command : commands) {
      for (const double number : command.force)
        bits.push_back(std::bit_cast<std::uint64_t>(number));
    }
  }
  for (const std::uint64_t word : compute_hash(world)) bits.push_back(word);
  return bits;
}

/// make_pair() with coefficients of the second instrument on either organ.
Scenario make_rubbing_pair() {
  Scenario made = make_pair();
  made.scene.instruments[1].pair_friction = {0.25, 0.0625};
  made.scene = build_scene(std::move(made.scene));
  return made;
}

std::string refuse_content(const std::string& from, const std::string& to) {
  Container changed = scenario::pack(make_rubbing_pair());
  const std::size_t at = changed.content.rfind(from);  // of the second
  REQUIRE(at != std::string::npos);
  changed.content.replace(at, from.size(), to);
  return refusal([&] { scenario::unpack(changed, "file"); });
}

template <class Change>
std::string refuse_scene(Change change) {
  Scenario made = make_pair();
  change(made.scene);
  return bad_argument([&] { scenario::pack(made); });
}

}  // namespace

TEST_CASE("a scene of two bodies and instruments that was read gives the very forces") {
  const Folder folder("pair");
  const Scenario made = make_rubbing_pair();

  scenario::write(folder.file("pair.palpate"), made);
  const Scenario found = scenario::read(folder.file("pair.palpate"));

  REQUIRE(found.scene.bodies.size() == 2);
  REQUIRE(found.scene.instruments.size() == 2);
  CHECK(found.scene.instruments[1].tool.radius == 0.002);
  CHECK(found.scene.instruments[1].tool.friction == 0.25);
  CHECK(found.scene.instruments[0].pair_friction.empty());
  CHECK(found.scene.instruments[1].pair_friction == std::vector{0.25, 0.0625});
  CHECK(found.scene.instruments[1].coupling.force_max == 2.0);
  CHECK(found.scene.bodies[0].force_error == 0.0);
  CHECK(found.scene.bodies[1].force_error == 1e-3);
  CHECK(found.scene.bodies[1].substeps == made.scene.bodies[1].substeps);
  const auto bits = felt_bits(made.scene);
  CHECK(felt_bits(found.scene) == bits);
  CHECK(std::count(bits.begin(), bits.end(), 0u) < 1200);  // both were touched
  CHECK(scenario::pack(found).content == scenario::pack(made).content);
}

TEST_CASE("a body keeps its integrator, and one of symplectic Euler names none") {
  Scenario made = make_pair();
  made.scene.bodies[1].integrator = Integrator::runge_kutta_4;
  made.scene.bodies[1].kernel = Kernel::automatic;
  made.scene.bodies[1].force_error = 0.0;
  made.scene.bodies[1].substeps = made.scene.bodies[1].substeps_max = 0;
  made.scene = build_scene(made.scene);

  const Container packed = scenario::pack(made);
  const Scenario found = scenario::unpack(packed, "file");

  CHECK(found.scene.bodies[0].integrator == Integrator::symplectic_euler);
  CHECK(found.scene.bodies[1].integrator == Integrator::runge_kutta_4);
  CHECK(found.scene.bodies[1].kernel == made.scene.bodies[1].kernel);
  CHECK(packed.content.find("integrator") == packed.content.rfind("integrator"));
  CHECK(felt_bits(found.scene) == felt_bits(made.scene));
  CHECK(contains(
      refuse_content("\"spectrum_damping\":", "\"integrator\":\"leapfrog\",\"spectrum_damping\":"),
      "content.scene.bodies[1].integrator: got \"leapfrog\", expected an integrator"));
}

TEST_CASE("a weightless body is kept as one, and a file of before has none") {
  Scenario made = make_pair();
  const std::string before = scenario::pack(made).content;
  made.scene.bodies[1].weightless = true;
  made.scene = build_scene(std::move(made.scene));
  Container packed = scenario::pack(made);

  const Scenario found = scenario::unpack(packed, "file");

  CHECK_FALSE(contains(before, "weightless"));
  CHECK_FALSE(found.scene.bodies[0].weightless);
  CHECK(found.scene.bodies[1].weightless);
  CHECK(felt_bits(found.scene) == felt_bits(made.scene));
  const std::string said = R"("weightless":true)";
  packed.content.replace(packed.content.find(said), said.size(), R"("weightless":9.8)");
  CHECK(contains(refusal([&] { scenario::unpack(packed, "file"); }),
                 "bodies[1].weightless: got 9.8, expected true or false"));
}

TEST_CASE("a body keeps its law of contact, and one of the hard law names none") {
  Scenario made = make_pair();
  made.scene.bodies[0].tissue.fixed = {0, 1, 2};
  made.scene.bodies[0].contact_modulus = 6270.0;
  made.scene = build_scene(made.scene);

  const Container packed = scenario::pack(made);
  const Scenario found = scenario::unpack(packed, "file");

  CHECK(found.scene.bodies[0].contact_modulus == 6270.0);
  REQUIRE(found.scene.bodies[0].near_field);
  CHECK(found.scene.bodies[0].near_field->compliance ==
        made.scene.bodies[0].near_field->compliance);
  CHECK(found.scene.bodies[1].contact_modulus == 0.0);
  CHECK_FALSE(found.scene.bodies[1].near_field);
  CHECK(packed.content.find("near_field") == packed.content.rfind("near_field"));
  CHECK(felt_bits(found.scene) == felt_bits(made.scene));
  const auto refuse = [](const std::string& contact) {
    return refuse_content("\"spectrum_damping\":",
                          "\"contact\":" + contact + ",\"spectrum_damping\":");
  };
  const std::string place = "content.scene.bodies[1].contact";
  CHECK(contains(refuse(R"({"law":"soft","version":1,"modulus":10})"), place + ".law: got"));
  CHECK(contains(refuse(R"({"law":"near_field","version":6,"modulus":10})"),
                 place + ".version: got 6"));
  CHECK(contains(refuse(R"({"law":"near_field","version":1,"modulus":-10})"),
                 "contact.modulus: got -10"));
  CHECK(contains(refuse(R"({"law":"near_field","version":1})"), place + ".modulus"));
}

TEST_CASE("a solid whose facets are felt keeps that, and a file of before has none") {
  Scenario made = make_pair();
  made.scene.bodies[0].tissue.fixed = {0, 1, 2};
  made.scene.bodies[0].tissue.prisms = {};
  made.scene.bodies[0].contact_modulus = 6270.0;
  Scenario before;
  before.scene = build_scene(made.scene);
  made.scene.bodies[0].contact_facets = true;
  made.scene = build_scene(made.scene);

  const Scenario found = scenario::unpack(scenario::pack(made), "file");
  const Scenario old = scenario::unpack(scenario::pack(before), "file");

  CHECK(found.scene.bodies[0].contact_facets);
  CHECK(found.scene.bodies[0].near_field->rest_position ==
        made.scene.bodies[0].near_field->rest_position);
  CHECK(felt_bits(found.scene) == felt_bits(made.scene));
  CHECK_FALSE(old.scene.bodies[0].contact_facets);
  CHECK(old.scene.bodies[0].near_field->rest_position.empty());
}

TEST_CASE("a body whose holds are tied to tissue keeps that, and a file of before has none") {
  Scenario made = make_pair();
  made.scene.bodies[0].tissue.fixed = {0, 1, 2};
  made.scene.bodies[0].tissue.prisms = {};
  made.scene.bodies[0].contact_modulus = 6270.0;
  for (const bool facets : {false, true}) {
    for (const bool tied : {false, true}) {
      made.scene.bodies[0].contact_facets = facets;
      made.scene.bodies[0].tied_holds = tied;
      made.scene = build_scene(made.scene);
      const Scenario found = scenario::unpack(scenario::pack(made), "file");
      CHECK(found.scene.bodies[0].contact_facets == facets);
      CHECK(found.scene.bodies[0].tied_holds == tied);
      CHECK(found.scene.bodies[0].near_field->ties_holds == tied);
    }
  }
}

TEST_CASE("a far field that was given is kept bit for bit, and a body without one has no entry") {
  Scenario made = make_pair();
  made.scene.bodies[0].tissue.fixed = {0, 1, 2};
  made.scene.bodies[0].tissue.prisms = {};
  made.scene.bodies[0].contact_modulus = 6270.0;
  made.scene.bodies[0].far_compliance.assign(42, {0.0123, 0.02, 0.03, -0.004, 0.005, 0.006});
  made.scene.bodies[0].far_compliance[7][5] = -1.0 / 300.0;
  made.scene = build_scene(made.scene);

  const Container packed = scenario::pack(made);
  const Scenario found = scenario::unpack(packed, "file");

  const std::string name = "scene/bodies/0/contact/far_compliance";
  CHECK(found.scene.bodies[0].far_compliance == made.scene.bodies[0].far_compliance);
  CHECK(found.scene.bodies[0].near_field->far_tensor == made.scene.bodies[0].far_compliance);
  CHECK(felt_bits(found.scene) == felt_bits(made.scene));
  CHECK(packed.arrays.at(name).shape[0] == 42);
  CHECK_FALSE(packed.arrays.contains("scene/bodies/1/contact/far_compliance"));
  Container hard = packed, wide = packed, shorter = packed;
  hard.arrays["scene/bodies/1/contact/far_compliance"] = hard.arrays.at(name);
  CHECK(contains(refusal([&] { scenario::unpack(hard, "file"); }),
                 "bodies[1].far_compliance: got one without a contact_modulus"));
  const double far_off = 1e5;
  std::memcpy(wide.arrays.at(name).bytes.data(), &far_off, sizeof(far_off));
  CHECK(contains(refusal([&] { scenario::unpack(wide, "file"); }),
                 "contact/far_compliance: row 0: got 100000, expected -10000 to 10000 m/N"));
  shorter.arrays.at(name).shape[0] = 41;
  shorter.arrays.at(name).bytes.resize(41 * sizeof(Symmetric));
  CHECK(contains(refusal([&] { scenario::unpack(shorter, "file"); }),
                 "bodies[0].far_compliance: got 41 tensors, expected 42"));
}

TEST_CASE("each body has its arrays under its number") {
  const Container packed = scenario::pack(make_pair());

  CHECK(packed.arrays.at("scene/bodies/0/tissue/mass").shape[0] == 42);
  CHECK(packed.arrays.at("scene/bodies/1/tissue/mass").shape[0] == 42);
  CHECK(packed.arrays.at("scene/bodies/0/tissue/volumes/bulk").shape[0] == 1);
  CHECK(packed.arrays.at("scene/bodies/1/tissue/volumes/bulk").shape[0] == 0);
  CHECK_FALSE(packed.arrays.contains("scene/bodies/2/tissue/mass"));
}

TEST_CASE("what is wrong with a further body or instrument is refused by its number") {
  const std::string radius = "\"radius\":0.002";
  CHECK(contains(refuse_content(radius, "\"radius\":0"),
                 "scene.instruments[1].tool.radius: got 0, expected 1e-05 to 0.2 m"));
  CHECK(contains(refuse_content(radius, "\"radius\":\"thin\""),
                 "content.scene.instruments[1].tool.radius: got \"thin\", expected a number"));
  CHECK(contains(refuse_content(radius, "\"width\":1," + radius), "unknown member \"width\""));
  CHECK(contains(refuse_content("\"friction\":0.25", "\"friction\":3"),
                 "scene.instruments[1].tool.friction: got 3, expected 0 to 2 -"));
  const std::string pairs = "\"pair_friction\":[0.25,0.0625]";
  CHECK(contains(refuse_content(pairs, "\"pair_friction\":[0.25]"),
                 "scene.instruments[1].pair_friction: got a list of 1"));
  CHECK(contains(refuse_content(pairs, "\"pair_friction\":[0.25,3]"),
                 "scene.instruments[1].pair_friction: got 3, expected 0 to 2 -"));
  CHECK(contains(refuse_content(pairs, "\"pair_friction\":[0.25,\"wet\"]"),
                 "scene.instruments[1].pair_friction"));
  CHECK(contains(refuse_content("\"hold_stiffness\":300.0", "\"hold_stiffness\":0"),
                 "scene.instruments[1].hold_stiffness: got 0"));
  CHECK(contains(refuse_content("\"substeps\":", "\"substeps\":0,\"unused\":"),
                 "content.scene.bodies[1].substeps: got 0"));

  const auto refuse_array = [](const std::string& name, std::size_t at, auto value) {
    Container changed = scenario::pack(make_pair());
    std::memcpy(changed.arrays.at(name).bytes.data() + at * sizeof(value), &value, sizeof(value));
    return refusal([&] { scenario::unpack(changed, "file"); });
  };
  CHECK(contains(refuse_array("scene/bodies/1/tissue/mass", 2, 1e-300),
                 "file: scene/bodies/1/tissue/mass: row 2: got 1e-300, expected"));
  CHECK(contains(refuse_array("scene/bodies/1/rest_areas", 3, 1.0),
                 "file: scene.bodies[1].rest_areas: row 3: got 1, expected"));
  CHECK(contains(refuse_array("scene/bodies/0/tissue/volumes/corners", 1, 42),
                 "file: scene/bodies/0/tissue/volumes/corners: row 0: got particle 42"));
  CHECK(contains(refuse_array("scene/bodies/1/tissue/springs/ends", 0, -1), "springs"));
}

TEST_CASE("bodies without their arrays, arrays without their body, and too many are refused") {
  const Container whole = scenario::pack(make_pair());
  Container missing = whole, extra = whole, many = whole;
  missing.arrays.erase("scene/bodies/1/tissue/home");
  extra.arrays["scene/bodies/2/tissue/home"] = {};

  CHECK(refusal([&] { scenario::unpack(missing, "file"); }) ==
        "file: scene/bodies/1/tissue/home: got no such array, expected one; it may be empty");
  CHECK(contains(refusal([&] { scenario::unpack(extra, "file"); }),
                 "scene/bodies/2/tissue/home: got an array of no known table"));

  std::string objects = "{}";
  for (std::size_t i = 0; i < scenario::kMostBodies; ++i) objects += ",{}";
  for (const auto& [list, told] : {std::pair{"[" + objects + "]", "a list of 17"},
                                   {std::string("[]"), "a list of 0"},
                                   {std::string("{}"), "an object"},
                                   {std::string("[7]"), "7, expected an object"}}) {
    for (const std::string name : {"bodies", "instruments"}) {
      many.content = whole.content;
      const std::string member = "\"" + name + "\":";
      many.content.replace(many.content.find(member), member.size(),
                           member + list + ",\"" + name.substr(1) + "\":");
      const std::string sentence = refusal([&] { scenario::unpack(many, "file"); });
      CHECK(contains(sentence, "content.scene." + name));
      CHECK(contains(sentence, told));
    }
  }
}

TEST_CASE("limits of tables are of all bodies together, and of bodies and instruments") {
  const auto fill = [](TissueModel& tissue, std::size_t count) {
    tissue.rest_position.resize(count, Vec3::Zero());
  };
  CHECK(contains(refuse_scene([&](Scene& scene) {
                   fill(scene.bodies[0].tissue, 12000);
                   fill(scene.bodies[1].tissue, 12000);
                 }),
                 "scene.bodies[1].tissue.rest_position: got 24000 rows with those of the bodies "
                 "before, expected at most 20000"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.instruments.resize(17); }),
                 "scene.instruments: got 17, expected 1 to 16"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.bodies.resize(17, scene.bodies[1]); }),
                 "scene.bodies: got 17, expected 1 to 16"));
  CHECK(contains(refuse_scene([](Scene& scene) { scene.bodies.clear(); }),
                 "scene.bodies: got 0, expected 1 to 16"));
}

TEST_CASE("as many bodies as a file may hold are written and read") {
  Scenario made = make_scenario();
  Scene scene;
  for (std::size_t b = 0; b < scenario::kMostBodies; ++b) {
    SoftBody body;
    body.tissue = scenes::make_spring_organ(0);
    for (Vec3& x : body.tissue.rest_position) x.x() += 0.2 * double(b);
    b == 0 ? void(scene.bodies[0] = std::move(body)) : scene.bodies.push_back(std::move(body));
  }
  scene.instruments.resize(scenario::kMostInstruments);
  made.scene = build_scene(std::move(scene));

  const Bytes bytes = scenario::pack_container(scenario::pack(made));
  const Scenario found = scenario::unpack(
      scenario::unpack_container(bytes, "file", "palpate", scenario::newest_version()), "file");

  CHECK(found.scene.bodies.size() == scenario::kMostBodies);
  CHECK(found.scene.instruments.size() == scenario::kMostInstruments);
  CHECK(found.scene.bodies.back().tissue.rest_position ==
        made.scene.bodies.back().tissue.rest_position);
}
