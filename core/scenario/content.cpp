// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/content.h"

#include <limits>
#include <stdexcept>

#include "palpate/scenario/body_pairs.h"
#include "palpate/scenario/hard_parts.h"
#include "palpate/scenario/json_fields.h"
#include "palpate/scenario/tables.h"

namespace palpate::scenario {
namespace {

constexpr const char* kContentWhere = "manifest.json: content";
constexpr std::initializer_list<const char*> kDampingLaws = {"axis", "isotropic"};
constexpr std::initializer_list<const char*> kAngleLaws = {"gradient", "eq10"};

Json print_tissue(const TissueModel& tissue) {
  Json printed = {{"pressure", tissue.pressure},
                  {"drag", tissue.drag},
                  {"damping_law", kDampingLaws.begin()[static_cast<int>(tissue.damping_law)]},
                  {"angle_law", kAngleLaws.begin()[static_cast<int>(tissue.angle_law)]}};
  visit_law_numbers(tissue, [&](const char* field, double number) { printed[field] = number; });
  return printed;
}

/// A law of contact beside the hard one, and which form of it: the second has walls of prisms too,
/// the third feels facets; of the fourth and fifth, with walls and with facets, holds are tied.
constexpr const char* kNearField = "near_field";
constexpr int kWallVersion = 2, kFacetVersion = 3, kTiedVersion = 4, kTiedFacetVersion = 5;

int find_contact_version(const SoftBody& body) {
  if (body.tied_holds) return body.contact_facets ? kTiedFacetVersion : kTiedVersion;
  if (body.contact_facets) return kFacetVersion;
  return body.tissue.prisms.corners.empty() ? 1 : kWallVersion;
}

Json print_body(const SoftBody& body) {
  Json printed = {{"tissue", print_tissue(body.tissue)},
                  {"substeps", body.substeps},
                  {"substeps_max", body.substeps_max},
                  {"spectrum_stiffness", body.spectrum_stiffness},
                  {"spectrum_damping", body.spectrum_damping}};
  if (body.force_error > 0.0) printed["force_error"] = body.force_error;
  if (body.contact_modulus > 0.0) {
    printed["contact"] = {{"law", kNearField},
                          {"version", find_contact_version(body)},
                          {"modulus", body.contact_modulus}};
  }
  if (body.integrator != Integrator::symplectic_euler) {
    printed["integrator"] = std::string(integrator_name(body.integrator));
  }
  if (body.iterations > 0) printed["iterations"] = body.iterations;
  if (body.weightless) printed["weightless"] = true;
  if (body.tear_stretch > 0.0) printed["tear_stretch"] = body.tear_stretch;
  return printed;
}

Json print_jaws(const Jaws& jaws) {
  return {{"hinge", print_vector(jaws.hinge)},
          {"axis", print_vector(jaws.axis)},
          {"open", jaws.open},
          {"grip", jaws.grip},
          {"pad_area", jaws.pad_area}};
}

Json print_instrument(const Instrument& instrument) {
  const auto& [radius, tool_stiffness, friction, capsules, jaws] = instrument.tool;
  const auto& [coupling_stiffness, force_max] = instrument.coupling;
  Json tool = {{"radius", radius}, {"stiffness", tool_stiffness}};
  if (friction > 0.0) tool["friction"] = friction;
  for (const Capsule& capsule : capsules) {
    tool["capsules"].push_back(
        {{"from", print_vector(capsule.from)}, {"to", print_vector(capsule.to)}});
  }
  if (jaws) tool["jaws"] = print_jaws(*jaws);
  Json printed = {{"tool", std::move(tool)},
                  {"coupling", {{"stiffness", coupling_stiffness}, {"force_max", force_max}}},
                  {"hold_stiffness", instrument.hold_stiffness}};
  if (instrument.trocar) printed["trocar"] = print_vector(*instrument.trocar);
  if (!instrument.pair_friction.empty()) printed["pair_friction"] = instrument.pair_friction;
  return printed;
}

Json print_scene(const Scene& scene) {
  Json printed = {{"bodies", Json::array()},
                  {"body_pairs", print_pairs(scene)},
                  {"instruments", Json::array()},
                  {"gravity", print_vector(scene.gravity)},
                  {"rate", scene.rate}};
  print_hard_parts(scene, printed);
  // only where there is one: a file without is what it was before there were any
  if (scene.exchange_rate > 0.0) printed["exchange_rate"] = scene.exchange_rate;
  for (const SoftBody& body : scene.bodies) printed["bodies"].push_back(print_body(body));
  for (const Instrument& instrument : scene.instruments) {
    printed["instruments"].push_back(print_instrument(instrument));
  }
  return printed;
}

void parse_tissue(Fields fields, TissueModel& tissue) {
  visit_law_numbers(tissue,
                    [&](const char* field, double& number) { number = fields.number(field); });
  tissue.pressure = fields.number("pressure");
  tissue.drag = fields.number("drag");
  tissue.damping_law = static_cast<DampingLaw>(fields.choice("damping_law", kDampingLaws));
  tissue.angle_law = static_cast<AngleLaw>(fields.choice("angle_law", kAngleLaws));
  fields.finish();
}

/// Symplectic Euler where there is none.
Integrator parse_integrator(Fields& fields) {
  constexpr std::size_t kMostNameBytes = 100;
  if (!fields.has("integrator")) return Integrator::symplectic_euler;
  const std::string name = fields.text("integrator", kMostNameBytes);
  if (const auto integrator = find_integrator(name)) return *integrator;
  fields.refuse("integrator", describe(Json(name)),
                "an integrator that this program knows, such as symplectic_euler");
}

/// Gravity acts on a body where a file says nothing.
bool parse_weightless(Fields& fields) {
  if (!fields.has("weightless")) return false;
  const Json& said = fields.any("weightless");
  if (!said.is_boolean()) fields.refuse("weightless", describe(said), "true or false");
  return said.get<bool>();
}

/// Of the near field; the hard law, where there is none.
void parse_contact(Fields& fields, SoftBody& body) {
  if (!fields.has("contact")) return;
  Fields contact = fields.object("contact");
  contact.choice("law", {kNearField});
  const std::int64_t version = contact.whole("version", 1, kTiedFacetVersion);
  body.contact_facets = version == kFacetVersion || version == kTiedFacetVersion;
  body.tied_holds = version >= kTiedVersion;
  body.contact_modulus = contact.number("modulus");
  contact.finish();
}

SoftBody parse_body(Fields fields) {
  constexpr std::int64_t kMostInt = std::numeric_limits<int>::max();
  SoftBody body;
  parse_tissue(fields.object("tissue"), body.tissue);
  // at least 1: 0 would have build_scene choose, perhaps otherwise than it did
  body.substeps = static_cast<int>(fields.whole("substeps", 1, kMostInt));
  body.substeps_max = static_cast<int>(fields.whole("substeps_max", 1, kMostInt));
  body.force_error = fields.number_or("force_error", 0.0);
  parse_contact(fields, body);
  body.integrator = parse_integrator(fields);
  if (fields.has("iterations")) {
    body.iterations = static_cast<int>(fields.whole("iterations", 1, kMostInt));
  }
  body.weightless = parse_weightless(fields);
  body.tear_stretch = fields.number_or("tear_stretch", 0.0);
  body.spectrum_stiffness = fields.number("spectrum_stiffness");
  body.spectrum_damping = fields.number("spectrum_damping");
  fields.finish();
  return body;
}

/// None of a ball.
std::vector<Capsule> parse_capsules(Fields& tool) {
  std::vector<Capsule> capsules;
  if (!tool.has("capsules")) return capsules;
  for (Fields& capsule : tool.objects("capsules", kMostCapsules)) {
    capsules.push_back({parse_vector(capsule, "from"), parse_vector(capsule, "to")});
    capsule.finish();
  }
  return capsules;
}

/// None of a rigid tool.
std::optional<Jaws> parse_jaws(Fields& tool) {
  if (!tool.has("jaws")) return {};
  Fields fields = tool.object("jaws");
  Jaws jaws;
  jaws.hinge = parse_vector(fields, "hinge");
  jaws.axis = parse_vector(fields, "axis");
  jaws.open = fields.number("open");
  jaws.grip = fields.number("grip");
  jaws.pad_area = fields.number("pad_area");
  fields.finish();
  return jaws;
}

Instrument parse_instrument(Fields fields, std::size_t surfaces) {
  Instrument instrument;
  Fields tool = fields.object("tool");
  instrument.tool = {.radius = tool.number("radius"),
                     .stiffness = tool.number("stiffness"),
                     .friction = tool.number_or("friction", 0.0),
                     .capsules = parse_capsules(tool),
                     .jaws = parse_jaws(tool)};
  tool.finish();
  Fields coupling = fields.object("coupling");
  instrument.coupling = {.stiffness = coupling.number("stiffness"),
                         .force_max = coupling.number("force_max")};
  coupling.finish();
  instrument.hold_stiffness = fields.number("hold_stiffness");
  if (fields.has("trocar")) instrument.trocar = parse_vector(fields, "trocar");
  if (fields.has("pair_friction")) {
    instrument.pair_friction = fields.numbers("pair_friction", surfaces);
  }
  fields.finish();
  return instrument;
}

void parse_scene(Fields fields, Scene& scene) {
  scene.bodies.clear();
  for (Fields& body : fields.objects("bodies", kMostBodies)) {
    scene.bodies.push_back(parse_body(std::move(body)));
  }
  parse_pairs(fields, scene);
  parse_hard_parts(fields, scene);
  const std::size_t surfaces = scene.bodies.size() + scene.scenery.size() + scene.rigid.size();
  scene.instruments.clear();
  for (Fields& instrument : fields.objects("instruments", kMostInstruments)) {
    scene.instruments.push_back(parse_instrument(std::move(instrument), surfaces));
  }
  scene.gravity = parse_vector(fields, "gravity");
  scene.rate = fields.number("rate");
  scene.exchange_rate = fields.number_or("exchange_rate", 0.0);
  fields.finish();
}

void check_text(const char* name, const std::string& text, std::size_t most) {
  if (text.size() <= most) return;
  throw std::invalid_argument("scenario: " + std::string(name) + ": got " +
                              std::to_string(text.size()) + " bytes, expected at most " +
                              std::to_string(most));
}

void check_languages(const Scenario& scenario) {
  if (scenario.languages.size() > kMostLanguages) {
    throw std::invalid_argument("scenario: languages: got " +
                                std::to_string(scenario.languages.size()) + ", expected at most " +
                                std::to_string(kMostLanguages));
  }
  for (const auto& [code, words] : scenario.languages) {
    if (const auto problem = find_language_problem(code)) {
      throw std::invalid_argument("scenario: languages: got the code " + describe(Json(code)) +
                                  ", " + *problem + ", expected a code such as tr or pt-BR");
    }
    check_text(("languages." + code + ".title").c_str(), words.title, kMostTitleBytes);
    check_text(("languages." + code + ".task").c_str(), words.task, kMostTaskBytes);
  }
}

Json print_languages(const Scenario& scenario) {
  Json printed = Json::object();
  for (const auto& [code, words] : scenario.languages) {
    printed[code] = {{"title", words.title}, {"task", words.task}};
  }
  return printed;
}

void parse_languages(Fields& fields, const std::string& file, Scenario& scenario) {
  const Json& languages = fields.any("languages");
  if (!languages.is_object()) fields.refuse("languages", describe(languages), "an object");
  if (languages.size() > kMostLanguages) {
    fields.refuse("languages", std::to_string(languages.size()) + " languages",
                  "at most " + std::to_string(kMostLanguages));
  }
  for (const auto& [code, words] : languages.items()) {
    if (const auto problem = find_language_problem(code)) {
      fields.refuse("languages", "the code " + describe(Json(code)) + ", " + *problem,
                    "a code such as tr or pt-BR");
    }
    Fields said(words, file, std::string(kContentWhere) + ".languages." + code);
    scenario.languages[code] = {said.text("title", kMostTitleBytes),
                                said.text("task", kMostTaskBytes)};
    said.finish();
  }
}

Json parse_text(const std::string& text, const char* name) {
  try {
    return parse_object(text, "", "");
  } catch (const FileError& problem) {
    throw std::invalid_argument("scenario: " + std::string(name) + ": got " + problem.got +
                                ", expected " + problem.expected);
  }
}

}  // namespace

std::string print_content(const Scenario& scenario) {
  check_text("title", scenario.title, kMostTitleBytes);
  check_text("task", scenario.task, kMostTaskBytes);
  check_languages(scenario);
  Json printed = {{"title", scenario.title},
                  {"task", scenario.task},
                  {"scene", print_scene(scenario.scene)},
                  {"authored", parse_text(scenario.authored, "authored")}};
  // only where there are some: a file without is what it was before there were any
  if (!scenario.assessment.empty())
    printed["assessment"] = parse_text(scenario.assessment, "assessment");
  if (!scenario.languages.empty()) printed["languages"] = print_languages(scenario);
  return print(printed, "scenario: title or task");
}

void parse_content(const std::string& content, const std::string& file, Scenario& scenario) {
  const Json parsed = parse_object(content, file, kContentWhere);
  Fields fields(parsed, file, kContentWhere);
  scenario.title = fields.text("title", kMostTitleBytes);
  scenario.task = fields.text("task", kMostTaskBytes);
  parse_scene(fields.object("scene"), scenario.scene);
  const Json& authored = fields.any("authored");
  if (!authored.is_object()) fields.refuse("authored", describe(authored), "an object");
  scenario.authored = authored.dump();
  if (parsed.contains("assessment")) {
    const Json& assessment = fields.any("assessment");
    if (!assessment.is_object()) fields.refuse("assessment", describe(assessment), "an object");
    scenario.assessment = assessment.dump();
  }
  if (parsed.contains("languages")) parse_languages(fields, file, scenario);
  fields.finish();
}

}  // namespace palpate::scenario
