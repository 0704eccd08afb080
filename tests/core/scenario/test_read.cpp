// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/scenario/read.h"
#include "palpate/sim/base/private/refuse.h"
#include "some_scenario.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// The sentence that refuses a scenario one of whose tables was changed after it was packed.
template <class T>
std::string refuse_with(const std::string& table, std::size_t at, T value) {
  Container changed = scenario::pack(make_scenario());
  Array& array = changed.arrays.at("scene/bodies/0/tissue/" + table);
  REQUIRE((at + 1) * sizeof(T) <= array.bytes.size());
  std::memcpy(array.bytes.data() + at * sizeof(T), &value, sizeof(T));
  return refusal([&] { scenario::unpack(changed, "file"); });
}

/// The same with a piece of the JSON replaced.
std::string refuse_content(const std::string& from, const std::string& to) {
  Container changed = scenario::pack(make_scenario());
  const std::size_t at = changed.content.find(from);
  REQUIRE(at != std::string::npos);
  changed.content.replace(at, from.size(), to);
  return refusal([&] { scenario::unpack(changed, "file"); });
}

/// What a hand that goes in and pulls feels in 400 ticks, bit by bit.
std::vector<std::uint64_t> felt_bits(const Scene& scene) {
  World world(scene);
  std::vector<std::uint64_t> bits;
  for (int i = 0; i < 400; ++i) {
    HapticSample hand;
    hand.position = {0.001, 0.002,
                     0.03 + scene.instruments[0].tool.radius + 0.001 - 2e-5 * std::min(i, 300)};
    hand.buttons = i > 250 ? kAttachButton : 0;
    const Vec3 force = tick(scene, hand, 1.0 / scene.rate, world).force;
    for (const double number : force) bits.push_back(std::bit_cast<std::uint64_t>(number));
  }
  for (const std::uint64_t word : compute_hash(world)) bits.push_back(word);
  return bits;
}

}  // namespace

TEST_CASE("a scene that was read gives the very forces of the one that was written") {
  const Folder folder("read");
  const Scenario made = make_scenario();

  scenario::write(folder.file("kidney.palpate"), made);
  const Scenario found = scenario::read(folder.file("kidney.palpate"));

  const auto bits = felt_bits(made.scene);
  CHECK(felt_bits(found.scene) == bits);
  CHECK(std::count(bits.begin(), bits.end(), 0u) < 1000);  // it was touched
}

TEST_CASE("every table, every number and the authored document come back") {
  const Scenario made = make_scenario();

  const Scenario found = scenario::unpack(scenario::pack(made), "file");

  const Container first = scenario::pack(made), second = scenario::pack(found);
  CHECK(first.content == second.content);
  CHECK(first.arrays == second.arrays);
  CHECK(first.arrays.size() == 43);
  for (const auto& each : first.arrays) {
    const std::string& name = each.first;
    CAPTURE(name);
    // so that none can be forgotten unseen; a linear solid has no other law beside it, and solids
    // at finite strain, which vector code does not step, stand in test_finite_strain.cpp
    const bool alone = contains(name, "/elastic/") || contains(name, "/corotated/") ||
                       contains(name, "/neo_hookean/");
    CHECK(each.second.bytes.empty() == alone);
  }
  CHECK(found.title == "Böbrek");
  CHECK(found.task == made.task);
  CHECK(found.version == 7);
  CHECK(found.authored == made.authored);
  CHECK(found.authored_arrays == made.authored_arrays);
  CHECK(found.scene.gravity == made.scene.gravity);
  CHECK(found.scene.bodies[0].substeps == made.scene.bodies[0].substeps);
  CHECK(found.scene.bodies[0].spectrum_stiffness == made.scene.bodies[0].spectrum_stiffness);
  CHECK(found.scene.bodies[0].rest_areas == made.scene.bodies[0].rest_areas);
  CHECK(found.scene.bodies[0].tissue.damping_law == DampingLaw::isotropic);
  CHECK(found.scene.bodies[0].tissue.volumes.nodal_share == 0.25);
  CHECK(found.scene.bodies[0].tissue.volumes.around == made.scene.bodies[0].tissue.volumes.around);
}

TEST_CASE("title and task in further languages come back, and a file without them is as before") {
  Scenario made = make_scenario();
  CHECK(!contains(scenario::pack(made).content, "languages"));
  made.languages["tr"] = {"Böbrek", "Organa dokunun ve çekin."};
  made.languages["pt-BR"] = {"Rim", ""};

  const Scenario found = scenario::unpack(scenario::pack(made), "file");

  REQUIRE(found.languages.size() == 2);
  CHECK(found.languages.at("tr").title == "Böbrek");
  CHECK(found.languages.at("tr").task == "Organa dokunun ve çekin.");
  CHECK(scenario::pack(found).content == scenario::pack(made).content);
}

TEST_CASE("words are those of the language, of the same language elsewhere, or of the scenario") {
  Scenario made;
  made.title = "Kidney";
  made.task = "Press.";
  made.languages["tr"] = {"Böbrek", "Bastırın."};
  made.languages["pt"] = {"Rim", "Pressione."};
  made.languages["pt-BR"] = {"", "Aperte."};

  CHECK(scenario::find_words(made, "tr").title == "Böbrek");
  CHECK(scenario::find_words(made, "tr-TR").task == "Bastırın.");
  CHECK(scenario::find_words(made, "pt-BR").title == "Rim");
  CHECK(scenario::find_words(made, "pt-BR").task == "Aperte.");
  CHECK(scenario::find_words(made, "de").title == "Kidney");
  CHECK(scenario::find_words(made, "").task == "Press.");
}

TEST_CASE("the code of a language is two or three small letters, and parts behind hyphens") {
  for (const char* code : {"tr", "en-GB", "zh-Hant-TW", "sr-Latn", "de-1996", "gsw"}) {
    CHECK_MESSAGE(!scenario::find_language_problem(code), code);
  }
  for (const char* code : {"", "t", "TR", "turk", "tr-", "tr--TR", "tr_TR", "tr-\xc3\xa7", "-tr",
                           "tr-abcdefghi", "aa-bbbbbbbb-cccccccc-dddddddd-eeeeee"}) {
    CHECK_MESSAGE(scenario::find_language_problem(code).has_value(), code);
  }
}

TEST_CASE("the pressure of an organ without a skin comes back") {
  Scenario made = make_scenario();
  made.scene.bodies[0].tissue.skin = {};
  made.scene.bodies[0].tissue.pressure = 100.0;
  made.scene = build_scene(made.scene);

  CHECK(scenario::unpack(scenario::pack(made), "file").scene.bodies[0].tissue.pressure == 100.0);
}

TEST_CASE("substeps a designer has chosen stay as they were chosen") {
  Scenario made = make_scenario();
  made.scene.bodies[0].substeps += 3;
  made.scene.bodies[0].substeps_max = made.scene.bodies[0].substeps;

  const Scenario found = scenario::unpack(scenario::pack(made), "file");

  CHECK(found.scene.bodies[0].substeps == made.scene.bodies[0].substeps);
  CHECK(found.scene.bodies[0].substeps_max == made.scene.bodies[0].substeps_max);
}

TEST_CASE("substeps too few for the tissue are refused, with how many it needs and what would do") {
  Scenario made = make_scenario();
  SoftBody& body = made.scene.bodies[0];
  made.scene.rate = 50.0;
  body.substeps = body.substeps_max = 0;
  made.scene = build_scene(std::move(made.scene));
  const int needed = body.substeps;
  REQUIRE(needed >= 4);
  const Container sound = scenario::pack(made);
  const std::string place = write_text("\"substeps\":", needed);

  for (const int few : {1, needed / 2, needed - 1}) {
    Container changed = sound;
    changed.content.replace(changed.content.find(place), place.size(),
                            write_text("\"substeps\":", few));
    const std::string told = refusal([&] { scenario::unpack(changed, "file"); });
    CHECK(contains(told, write_text("scene: substeps: got ", few, ", steps of ")));
    CHECK(contains(told, write_text("expected at least ", needed, " (and a substeps_max of")));
    body.substeps = few;
    CHECK_THROWS_AS(scenario::pack(made), std::invalid_argument);  // nor written
    body.substeps = needed;
  }
  body.substeps = body.substeps_max = needed + 1;
  CHECK(scenario::unpack(scenario::pack(made), "file").scene.bodies[0].substeps == needed + 1);
}

TEST_CASE("the part of a tissue's stiffness that its substeps are said to do for is the nearest") {
  const auto refuse_part = [](double part) {
    Scenario made;
    SoftBody& body = made.scene.bodies[0];
    body.tissue = scenes::make_spring_organ(2);
    for (double& number : body.tissue.springs.stiffness) number *= part;
    for (double& number : body.tissue.springs.damping) number *= part;
    for (double& number : body.tissue.home) number *= part;
    made.scene.rate = 20.0;
    body.substeps = body.substeps_max = 3;
    return bad_argument([&] {
      made.scene = build_scene(std::move(made.scene));
      scenario::pack(made);
    });
  };
  const std::string told = refuse_part(1.0);
  REQUIRE(contains(told, " ms; or at most 0.0"));
  const double part = std::stod(told.substr(told.find("at most ") + 8));
  CHECK(contains(told, " of all its stiffness and damping"));
  CHECK(refuse_part(part) == "not refused");
  CHECK(contains(refuse_part(1.15 * part), "scene: substeps: got 3, steps of "));
}

TEST_CASE(
    "the error of the force that a scene allows is kept, and is none where no file says one") {
  Scenario made = make_scenario();
  CHECK(scenario::unpack(scenario::pack(made), "file").scene.bodies[0].force_error == 0.0);

  made.scene.bodies[0].tissue.home.assign(made.scene.bodies[0].tissue.mass.size(), 5.0);
  // solids and shells are moved whole
  made.scene.bodies[0].tissue.volumes = {};
  made.scene.bodies[0].tissue.skin = {};
  made.scene.bodies[0].tissue.prisms = {};
  made.scene.bodies[0].substeps = made.scene.bodies[0].substeps_max = 0;
  made.scene.bodies[0].force_error = 2e-3;
  made.scene = build_scene(made.scene);
  CHECK(scenario::unpack(scenario::pack(made), "file").scene.bodies[0].force_error == 2e-3);
}

TEST_CASE("an index that is out of range is refused, table and row named") {
  CHECK(contains(refuse_with("springs/ends", 7, 4200), "springs.ends: row 3: got "));
  CHECK(contains(refuse_with("bonds/ends", 0, -1), "bonds.ends: row 0: got "));
  CHECK(contains(refuse_with("angles/corners", 5, 42), "angles.corners: row 1: got "));
  CHECK(contains(refuse_with("triangles", 3, 42), "triangles: row 1: got "));
  CHECK(contains(refuse_with("fixed", 0, -5), "fixed: row 0: got particle -5"));
  CHECK(contains(refuse_with("volumes/corners", 1, 42), "corners: row 0: got particle 42"));
  CHECK(contains(refuse_with("volumes/corners", 1, -1), "corners: row 0: got particle -1"));
  CHECK(contains(refuse_with("skin/corners", 9, 42), "skin.corners: row 2: got "));
}

TEST_CASE("numbers no tissue has are refused") {
  CHECK(contains(refuse_with("mass", 2, -1.0), "mass: row 2: got -1, expected"));
  CHECK(contains(refuse_with("springs/stiffness", 0, -1.0), "springs.stiffness: row 0"));
  CHECK(contains(refuse_with("home", 1, -1.0), "home: row 1"));
  CHECK(contains(refuse_with("volumes/rest_volume", 0, 0.0), "volumes/rest_volume: row 0"));
  CHECK(contains(refuse_with("volumes/bulk", 0, -2.0), "volumes.bulk: row 0: got -2 Pa"));
  CHECK(contains(refuse_with("skin/weights", 8, 0.5), "skin.weights: row 2: got a sum of 0.5"));
  CHECK(contains(refuse_with("angles/rest_cosine", 0, 2.0), "angles/rest_cosine: row 0"));
  CHECK(contains(refuse_with("mass", 2, 1e-300), "mass: row 2: got 1e-300, expected"));
  CHECK(contains(refuse_with("rest_position", 60, 1e200), "rest_position: row 20: got 1e+200"));
}

TEST_CASE("derived numbers that are not those of the tissue are refused") {
  Container changed = scenario::pack(make_scenario());
  const double area = 1.0;
  std::memcpy(changed.arrays.at("scene/bodies/0/rest_areas").bytes.data(), &area, sizeof(area));

  CHECK(contains(refusal([&] { scenario::unpack(changed, "file"); }),
                 "scene.bodies[0].rest_areas: row 0: got 1, expected "));
}

TEST_CASE("a table that is missing, too much, or of another shape is refused") {
  const Container whole = scenario::pack(make_scenario());
  Container missing = whole, extra = whole, shape = whole, type = whole;
  missing.arrays.erase("scene/bodies/0/tissue/mass");
  extra.arrays["scene/bodies/0/tissue/charge"] = {};
  shape.arrays.at("scene/bodies/0/tissue/rest_position").shape = {3, 42};
  type.arrays.at("scene/bodies/0/tissue/mass").dtype = Dtype::i8;

  CHECK(refusal([&] { scenario::unpack(missing, "file"); }) ==
        "file: scene/bodies/0/tissue/mass: got no such array, expected one; it may be empty");
  CHECK(contains(refusal([&] { scenario::unpack(extra, "file"); }), "no known table"));
  CHECK(contains(refusal([&] { scenario::unpack(shape, "file"); }), "got shape (3, 42)"));
  CHECK(contains(refusal([&] { scenario::unpack(type, "file"); }), "expected (n) of <f8"));
}

TEST_CASE("more rows than any tissue that ticks are refused before they are worked on") {
  Container changed = scenario::pack(make_scenario());
  Array& mass = changed.arrays.at("scene/bodies/0/tissue/mass");
  Array& position = changed.arrays.at("scene/bodies/0/tissue/rest_position");
  const auto count = static_cast<std::int64_t>(scenario::kMostParticles) + 1;
  mass = {Dtype::f8, {count}, Bytes(static_cast<std::size_t>(8 * count))};
  position = {Dtype::f8, {count, 3}, Bytes(static_cast<std::size_t>(24 * count))};

  CHECK(contains(refusal([&] { scenario::unpack(changed, "file"); }),
                 "rest_position: got 20001 rows, expected at most 20000"));
}

TEST_CASE("a number, a text or a choice in the manifest that is none is refused by name") {
  CHECK(contains(refuse_content("\"rate\":800.0", "\"rate\":\"fast\""),
                 "content.scene.rate: got \"fast\", expected a number"));
  CHECK(contains(refuse_content("\"rate\":800.0", "\"rate\":-1"),
                 "scene.rate: got -1, expected 1 to 20000 Hz"));
  CHECK(contains(refuse_content(",\"rate\":800.0", ""), "content.scene.rate: got nothing"));
  CHECK(contains(refuse_content("\"rate\"", "\"pace\":1,\"rate\""), "unknown member \"pace\""));
  CHECK(contains(refuse_content("\"isotropic\"", "\"sticky\""),
                 "damping_law: got \"sticky\", expected one of axis, isotropic"));
  CHECK(contains(refuse_content("\"radius\":0.004", "\"radius\":0"), "tool.radius"));
  CHECK(contains(refuse_content("[0.1,-0.2,-9.81]", "[0.1,-0.2]"), "gravity: got a list of 2"));
  CHECK(contains(refuse_content("[0.1,-0.2,-9.81]", "[0.1,-0.2,[]]"), "gravity"));
  CHECK(contains(refuse_content("\"substeps\":", "\"substeps\":0.5,\"unused\":"), "substeps"));
  CHECK(contains(refuse_content("\"substeps\":", "\"substeps\":0,\"unused\":"), "substeps"));
  CHECK(contains(refuse_content("\"title\":", "\"title\":7,\"unused\":"), "title: got 7"));
  CHECK(contains(refuse_content("\"authored\":", "\"authored\":[],\"unused\":"), "authored"));
}

TEST_CASE("languages that are none, are unknown in form or hold anything but words are refused") {
  const auto refuse_languages = [](const std::string& languages) {
    return refuse_content("\"title\":", "\"languages\":" + languages + ",\"title\":");
  };
  std::string many;
  for (char a = 'a'; a <= 'z'; ++a) {
    for (const char b : {'a', 'b'}) {
      many += (many.empty() ? "\"" : ",\"") + std::string{a, b} + "\":{}";
    }
  }

  CHECK(contains(refuse_languages("[]"), "content.languages: got a list of 0, expected an obj"));
  CHECK(contains(refuse_languages("{\"TR\":{}}"), "got the code \"TR\", which does not begin"));
  CHECK(contains(refuse_languages("{\"tr\":7}"), "languages.tr: got 7, expected an object"));
  CHECK(contains(refuse_languages("{\"tr\":{}}"), "languages.tr.title: got nothing"));
  CHECK(contains(refuse_languages("{\"tr\":{\"title\":\"\",\"task\":1}}"), "tr.task: got 1"));
  CHECK(contains(refuse_languages("{\"tr\":{\"title\":\"\",\"task\":\"\",\"tas\":1}}"),
                 "unknown member \"tas\""));
  CHECK(contains(refuse_languages("{" + many + "}"), "got 52 languages, expected at most 50"));
}

TEST_CASE("a scenario that could not be read is not written") {
  const auto refused = [](auto change) {
    Scenario made = make_scenario();
    change(made);
    return bad_argument([&] { scenario::pack_container(scenario::pack(made)); });
  };

  CHECK(contains(refused([](Scenario& s) { s.title.assign(201, 'a'); }), "title: got 201 bytes"));
  CHECK(contains(refused([](Scenario& s) { s.task = "\xff"; }), "not UTF-8"));
  CHECK(contains(refused([](Scenario& s) { s.authored = "{"; }), "authored: got text that is"));
  CHECK(contains(refused([](Scenario& s) { s.scene.bodies[0].rest_areas.clear(); }), "rest_areas"));
  CHECK(contains(refused([](Scenario& s) { s.scene.bodies[0].spectrum_stiffness *= 0.5; }),
                 "spectrum"));
  CHECK(contains(refused([](Scenario& s) { s.scene = Scene{}; }), "result of build_scene"));
  CHECK(contains(refused([](Scenario& s) { s.scene.bodies[0].tissue.mass[0] = 0.0; }),
                 "mass: row 0"));
  CHECK(contains(refused([](Scenario& s) { s.authored_arrays["../up"] = {}; }), "the name"));
  CHECK(contains(refused([](Scenario& s) { s.languages["TR"] = {}; }), "got the code \"TR\""));
  CHECK(contains(refused([](Scenario& s) { s.languages["tr"].title.assign(201, 'a'); }),
                 "languages.tr.title: got 201 bytes"));
  CHECK(contains(refused([](Scenario& s) {
                   for (char a = 'a'; a <= 'z'; ++a) {
                     s.languages[{a, 'a'}] = s.languages[{a, 'b'}] = {};
                   }
                 }),
                 "languages: got 52, expected at most 50"));
}
