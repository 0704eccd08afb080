// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "core/scenario/some_scenario.h"
#include "palpate/scenario/assessment.h"
#include "palpate/scenario/table_array.h"

using namespace palpate;
using namespace palpate::testing;
using palpate::scenario::draw;
using palpate::scenario::draw_task;
using palpate::scenario::DrawnTask;

namespace {

/// Of every verb, measure, kind of place and parameter that can be judged.
const std::string kAssessment = R"({
  "palpate_scenario": 1, "id": "every-verb", "version": "1.0.0", "title": "title",
  "organs": {"organ": {}}, "tools": {"hand": {"kind": "grasper"}},
  "places": {"top": {"region": "organ/top"}, "side": {"region": "organ/side"},
             "line": {"path": [[0, 0, 0.02], [0.01, 0, 0.02], [0.02, "$y", 0.02]], "organ": "organ"},
             "spot": {"ball": [0, 0, 0.02, 0.005], "organ": "organ"}},
  "levels": ["easy", "normal"],
  "parameters": {"limit": {"unit": "N", "value": 1.5, "levels": {"easy": 2}},
                 "press": {"unit": "N", "uniform": [0.2, 0.4]},
                 "where": {"unit": "place", "choose": ["top", "side"]},
                 "y": {"unit": "m", "choose": [0.001, 0.002, 0.003]}},
  "steps": [{"id": "a", "do": "touch", "at": "$where", "say": "go"},
            {"id": "b", "do": "hold", "at": "top", "force_N": ["$press", 0.5], "for_s": 3, "say": "go"},
            {"id": "c", "do": "push", "at": "top", "depth_m": [0.001, null], "say": "go", "within_s": 9},
            {"id": "d", "do": "grasp", "at": "top", "say": "go", "after": ["a"]},
            {"id": "e", "do": "pull", "at": "top", "distance_m": [0.01, 0.02], "say": "go"},
            {"id": "f", "do": "release", "say": "go", "after": ["e", "c"]},
            {"id": "g", "do": "trace", "at": "line", "share": 0.9, "off_path_m": 0.004, "say": "go"},
            {"id": "h", "do": "find", "at": "spot", "say": "go"}],
  "limits": [{"id": "hard", "when": {"measure": "force", "above": "$limit", "for_s": 0.05},
              "then": "error", "say": "go"},
             {"id": "off", "when": {"measure": "contact", "place": "side"}, "then": "warn",
              "say": "go", "during": ["b", "c"]},
             {"id": "near", "when": {"measure": "clearance", "place": "spot", "below": 0.01},
              "then": "end", "say": "go", "during": ["a"]},
             {"id": "astray", "when": {"measure": "path.off", "place": "line", "above": 0.01},
              "then": "error", "say": "go", "during": ["g"]},
             {"id": "stretched", "when": {"measure": "strain", "place": "top", "above": 0.4},
              "then": "error", "say": "go"}],
  "finish": {"time_limit_s": 90, "errors_at_most": 5},
  "goals": [{"metric": "time", "at_most": 30, "basis": {"kind": "designer"}}],
  "texts": {"en": {"title": "Every verb", "go": "Go"}, "tr": {"title": "Her fiil"}}
})";

Scenario make_assessed(const std::string& assessment = kAssessment) {
  Scenario made = make_scenario();
  made.assessment = assessment;
  made.assessment_arrays["places/top"] = scenario::to_array(std::vector<int>{0, 1, 2});
  made.assessment_arrays["places/side"] = scenario::to_array(std::vector<int>{5, 6});
  return made;
}

std::string with(const std::string& part, const std::string& other) {
  std::string text = kAssessment;
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), other);
}

}  // namespace

TEST_CASE("an assessment comes to the tables it stands for") {
  const DrawnTask drawn = draw_task(make_assessed(), "", 7);

  CHECK(drawn.id == "every-verb");
  CHECK(drawn.level == "normal");
  REQUIRE(drawn.task.steps.size() == 8);
  CHECK(drawn.steps[4] == "e");
  const std::vector<TaskStep>& steps = drawn.task.steps;
  CHECK(steps[0].after.empty());
  CHECK(steps[1].after == std::vector<int>{0});
  CHECK(steps[3].after == std::vector<int>{0});
  CHECK(steps[5].after == std::vector<int>{4, 2});
  CHECK(steps[5].place == -1);
  CHECK(steps[1].duration == 3.0);
  CHECK(steps[1].force.most == 0.5);
  CHECK(steps[2].time_limit == 9.0);
  CHECK(steps[2].depth.least == 0.001);
  CHECK(steps[4].distance.most == 0.02);
  const TaskPlace& traced = drawn.task.places[static_cast<std::size_t>(steps[6].place)];
  CHECK(traced.kind == PlaceKind::path);
  CHECK(traced.radius == 0.004);
  CHECK(steps[6].share == 0.9);
  REQUIRE(drawn.task.limits.size() == 5);
  CHECK(drawn.task.limits[4].measure == TaskMeasure::strain);
  CHECK(drawn.task.limits[0].bound == 1.5);
  CHECK(drawn.task.limits[0].duration == 0.05);
  CHECK(drawn.task.limits[1].then == LimitConsequence::warn);
  CHECK(drawn.task.limits[1].during == std::vector<int>{1, 2});
  CHECK_FALSE(drawn.task.limits[2].above);
  CHECK(drawn.task.time_limit == 90.0);
  CHECK(drawn.task.errors_at_most == 5);
  CHECK(draw_task(make_assessed(), "easy", 7).task.limits[0].bound == 2.0);
}

TEST_CASE("a draw is of the first 53 bits of the SHA-256 of seed, id and name") {
  // int.from_bytes(hashlib.sha256(b"7\nevery-verb\npress").digest()[:8], "big") // 2**11 / 2**53
  CHECK(draw(7, "every-verb", "press") == 0x1.d0fe9bf189991p-1);
}

TEST_CASE("a seed chooses the parameters, each by itself") {
  const DrawnTask one = draw_task(make_assessed(), "", 1),
                  other = draw_task(make_assessed(), "", 2);
  REQUIRE(one.values.size() == 4);
  CHECK(one.values[1].name == "press");
  CHECK(one.values[1].value == doctest::Approx(0.2 + 0.2 * draw(1, "every-verb", "press")));
  CHECK(one.values[1].value == one.task.steps[1].force.least);
  CHECK(one.values[1].value != other.values[1].value);
  CHECK(one.sha256 == other.sha256);

  // one that is added changes no other
  const std::string more = with(R"("y": {)", R"("x": {"unit": "m", "uniform": [0, 1]}, "y": {)");
  std::string used = more;
  used.replace(used.find("[0.01, 0, 0.02]"), 15, R"(["$x", 0, 0.02])");
  CHECK(draw_task(make_assessed(used), "", 1).task.steps[1].force.least ==
        one.task.steps[1].force.least);
  CHECK(draw_task(make_assessed(used), "", 1).sha256 != one.sha256);
}

TEST_CASE("a file with an assessment round-trips, and one without is what it was before") {
  const Scenario made = make_assessed();
  const Container packed = scenario::pack(made);
  const Scenario read = scenario::unpack(packed, "made.palpate");

  CHECK(scenario::pack(read).arrays == packed.arrays);
  CHECK(scenario::pack(read).content == packed.content);
  CHECK(draw_task(read, "easy", 3).sha256 == draw_task(made, "easy", 3).sha256);
  CHECK(packed.arrays.contains("assessment/places/top"));

  CHECK_FALSE(contains(scenario::pack(make_scenario()).content, "assessment"));
  CHECK_THROWS_AS(draw_task(make_scenario()), std::invalid_argument);
  CHECK_THROWS_AS(draw_task(made, "hard"), std::invalid_argument);
}

TEST_CASE("an assessment that cannot be judged is refused, with its place and what was expected") {
  const std::pair<std::string, const char*> refused[] = {
      {with(R"("id": "every-verb")", R"("id": "Every verb")"), "id: got"},
      {with(R"("palpate_scenario": 1)", R"("palpate_scenario": 2)"), "made by a newer program"},
      {with(R"("for_s": 3)", R"("for_sec": 3)"), "an unknown member \"for_sec\""},
      {with(R"("at": "top", "depth)", R"("at": "tip", "depth)"), "steps[2].at: got \"tip\""},
      {with(R"("do": "push")", R"("do": "cut")"), "there are no scissors"},
      {with(R"("do": "touch")", R"("do": "look")"), "a tool of the kind laparoscope"},
      {with(R"("do": "touch")", R"("do": "carry")"), "steps[0].to: got"},
      {with(R"("measure": "force")", R"("measure": "inside")"), "a step that carries asks"},
      {with(R"("do": "push")", R"("do": "shove")"), "one of touch, hold, push"},
      {with(R"("measure": "force")", R"("measure": "volume")"), "there is no syringe"},
      {with(R"(["$press", 0.5])", R"(["$press", 0.1])"), "an empty band"},
      {with(R"(["$press", 0.5])", R"(["$pres", 0.5])"), "the name of a parameter"},
      {with(R"(["$press", 0.5])", R"([0.2, 0.5])"), "a parameter that nothing uses"},
      {with(R"(["top", "side"])", R"(["top", "../side"])"), "parameters.where.choose: got"},
      {with(R"(["top", "side"])", R"(["nowhere", "side"])"), "the id of a place"},
      {with(R"("after": ["a"])", R"("after": ["f"])"), "wait for each other in a circle"},
      {with(R"("after": ["a"])", R"("after": ["z"])"), "the id of a step"},
      {with(R"("id": "c")", R"("id": "b")"), "once more"},
      {with(R"("say": "go"},)", R"("say": "come"},)"), "a text that texts.en has"},
      {with(R"("tr": {"title")", R"("tr": {"titel")"), "one that texts.en has too"},
      {with(R"("en": {)", R"("de": {)"), "the texts in English"},
      {with(R"("kind": "grasper")", R"("kind": "probe")"), "a tool of the kind grasper"},
      {with(R"("time_limit_s": 90)", R"("time_limit_s": 1e308)"), "finish.time_limit_s: got"},
      {with(R"("levels": {"easy": 2})", R"("levels": {"esay": 2})"),
       "one of the scenario's levels"},
      {with(R"({"region": "organ/side"})", R"({"region": "spleen/side"})"), "an organ of"},
      {with(R"("then": "end")", R"("then": "stop")"), "one of warn, error, end"},
      {with(R"("ball": [0, 0, 0.02, 0.005])", R"("ball": [0, 0, 0.02, 0])"), "places.spot.radius"},
      {with(R"("ball": [0, 0, 0.02, 0.005])", R"("object": "stone")"), "an object of the scenario"},
      {with(R"("ball": [0, 0, 0.02, 0.005], "organ": "organ")", R"("space": [0, 0, 0.02])"),
       "[x, y, z, radius]"},
      {with(R"("ball": [0, 0, 0.02, 0.005], "organ": "organ")", ""),
       "region, path, ball, object or space"},
      {"{\"palpate_scenario\": NaN}", "not JSON"},
      {"[]", "an object"},
  };
  for (const auto& [text, sentence] : refused) {
    const std::string said = bad_argument([&] { scenario::pack(make_assessed(text)); });
    CHECK_MESSAGE(contains(said, sentence), said);
  }
}

TEST_CASE("a damaged assessment is refused as a file is, and so are arrays beside it") {
  Container packed = scenario::pack(make_assessed());
  packed.arrays["assessment/places/top"] = scenario::to_array(std::vector<int>{0, 100000});
  const std::string far = refusal([&] { scenario::unpack(packed, "x.palpate"); });
  CHECK_MESSAGE(contains(far, "places.top.vertices: got 100000"), far);
  CHECK(contains(far, "x.palpate: "));

  packed = scenario::pack(make_assessed());
  packed.arrays.erase("assessment/places/side");
  CHECK(contains(refusal([&] { scenario::unpack(packed, "x.palpate"); }), "no such array"));
  packed = scenario::pack(make_assessed());
  packed.arrays["assessment/places/spot"] = packed.arrays["assessment/places/top"];
  CHECK(contains(refusal([&] { scenario::unpack(packed, "x.palpate"); }), "an array of no region"));
  packed = scenario::pack(make_scenario());
  packed.arrays["assessment/places/top"] = scenario::to_array(std::vector<int>{0});
  CHECK(contains(refusal([&] { scenario::unpack(packed, "x.palpate"); }), "no assessment"));
}

TEST_CASE("a scene is drawn with the constants of the inclusion, and of no other") {
  std::string text = with(R"("spot": {"ball")",
                          R"("spot": {"inclusion": {"ball": [0, 0, 0.02, 0.01], "stiffness": 4},
                              "ball")");
  text.replace(text.find(R"("steps")"), 7, R"("inclusion": "spot", "steps")");
  Scenario made = make_assessed(text);
  std::vector<double> stiffness = made.scene.bodies[0].tissue.springs.stiffness;
  REQUIRE(!stiffness.empty());
  for (double& each : stiffness) each *= 4.0;
  made.assessment_arrays["constants/spot/tissue/springs/stiffness"] = scenario::to_array(stiffness);
  const DrawnTask drawn = draw_task(made, "", 7);
  CHECK(drawn.inclusion == "spot");

  const Scene scene = scenario::draw_scene(made, drawn);

  CHECK(scene.bodies[0].tissue.springs.stiffness == stiffness);
  CHECK(scene.bodies[0].tissue.mass == made.scene.bodies[0].tissue.mass);
  CHECK(scene.bodies[0].spectrum_stiffness > made.scene.bodies[0].spectrum_stiffness);
  CHECK(scenario::draw_scene(make_assessed(), draw_task(make_assessed(), "", 7)).identity !=
        scene.identity);
  CHECK_NOTHROW(scenario::pack(made));
  stiffness.pop_back();
  made.assessment_arrays["constants/spot/tissue/springs/stiffness"] = scenario::to_array(stiffness);
  CHECK_THROWS_AS(scenario::draw_scene(made, drawn), std::invalid_argument);
  CHECK_THROWS_AS(scenario::pack(made), std::invalid_argument);
  made.assessment_arrays.erase("constants/spot/tissue/springs/stiffness");
  CHECK_THROWS_AS(scenario::pack(made), std::invalid_argument);
}
