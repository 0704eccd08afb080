// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>

#include <cmath>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/tick/world.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {
namespace {

void bind_safeguards(py::module_& m) {
  // an integer in Python too, as in the column of a record's events
  py::native_enum<Safeguard>(
      m, "Safeguard", "enum.IntEnum",
      "What a body is stepped by where it would blow up without, each beyond the one before.")
      .value("none", Safeguard::none, "As the scene says.")
      .value("half_steps", Safeguard::half_steps, "Of half the length.")
      .value("quarter_steps", Safeguard::quarter_steps, "Of a quarter of it.")
      .value("implicit_damping", Safeguard::implicit_damping,
             "Damped by the velocity that a step leads to, as well.")
      .value("implicit_euler", Safeguard::implicit_euler,
             "By implicit Euler where that is still too long, as well.")
      .finalize();
}

void bind_states(py::module_& m) {
  bind_safeguards(m);
  py::class_<SoftState> body(m, "SoftState", "A soft body of a running scene, after every tick.");
  body.def_readonly("tissue", &SoftState::tissue, "The tissue after the last tick; read-only.")
      .def_readonly("tree", &SoftState::tree, "The boxes around its surface; read-only.")
      .def_readonly("load", &SoftState::load, "What all tools do to the tissue; read-only.")
      .def_readonly("guard", &SoftState::guard, "The memory of the alarm; read-only.")
      .def_readonly("torn_count", &SoftState::torn_count,
                    "Links, or triangles of bonds, that have torn since the start.")
      .def_readonly("substeps", &SoftState::substeps, "Of the last tick.")
      .def_readonly("safeguard", &SoftState::safeguard, "Of the last tick.")
      .def_readonly("averted", &SoftState::averted,
                    "The last alarm that a safeguard has averted; none so far.")
      .def_readonly("asleep", &SoftState::asleep,
                    "It has come to rest far from every instrument, and ticks leave it out until "
                    "one comes near: no bit of it would change.");
  def_view(body, "skin", &SoftState::skin,
           "[m] the vertices of the skin, shape (n, 3), after every tick; empty where there is "
           "none; a view.");
  def_copy(body);
  def_summary(body, [](const SoftState& self) {
    return write_text(self.tissue.position.size(), " particles, ", self.substeps, " substeps");
  });

  py::class_<DeviceCoupling> device(
      m, "DeviceCoupling",
      "The hand's spring of an instrument whose device bears less of one than the instrument has.");
  device
      .def_readonly("passive_stiffness", &DeviceCoupling::passive_stiffness,
                    "[N/m] Up to which a spring is passive with the device, see "
                    "find_passive_stiffness; 0, or no less than the instrument's own, for none "
                    "of this: World.bound_coupling.")
      .def_readonly("delay", &DeviceCoupling::delay,
                    "[s] By which a force is late, T/2 + d: times passive_stiffness the device's "
                    "damping. Likewise.")
      .def_readonly("energy", &DeviceCoupling::energy,
                    "[J] That the spring may give as it gets stiffer.")
      .def_readonly("stiffness", &DeviceCoupling::stiffness,
                    "[N/m] Of the spring in the last tick.")
      .def_readonly("tissue", &DeviceCoupling::tissue,
                    "[N/m] As the contact has shown it to be to the tool.")
      .def_readonly("follows_tissue", &DeviceCoupling::follows_tissue,
                    "9 tissue is above what is passive, so that the spring follows the tissue.");
  device.def(py::init<>())
      .def_readonly("way", &DeviceCoupling::way,
                    "[m] Of the tool against its force, in this touch.")
      .def_readonly("mean_way", &DeviceCoupling::mean_way, "[m] Lately, as what follows.")
      .def_readonly("mean_force", &DeviceCoupling::mean_force, "[N]")
      .def_readonly("way_square", &DeviceCoupling::way_square, "[m²] Variance.")
      .def_readonly("way_force", &DeviceCoupling::way_force, "[N m] Covariance.");
  def_vector(device, "tool", &DeviceCoupling::tool, "[m] In the last tick.");
  def_value(device, &DeviceCoupling::passive_stiffness, &DeviceCoupling::delay,
            &DeviceCoupling::stiffness, &DeviceCoupling::tissue, &DeviceCoupling::follows_tissue,
            &DeviceCoupling::energy, &DeviceCoupling::way, &DeviceCoupling::mean_way,
            &DeviceCoupling::mean_force, &DeviceCoupling::way_square, &DeviceCoupling::way_force,
            &DeviceCoupling::tool);
  def_repr(device, {"passive_stiffness", "stiffness", "tissue", "follows_tissue"});

  py::class_<InstrumentState> instrument(
      m, "InstrumentState", "An instrument of a running scene, and the hand that moves it.");
  instrument.def_readonly("tool", &InstrumentState::tool, "Where the tool is; read-only.")
      .def_readonly("attach_pressed", &InstrumentState::attach_pressed,
                    "Whether the attach button was, in the last tick.")
      .def_readonly("opens", &InstrumentState::opens,
                    "Its jaws open by themselves, until the hand has.")
      .def_readonly("release_ticks", &InstrumentState::release_ticks,
                    "Left until a hold that fades is gone; 0 when none does.")
      .def_readonly("device", &InstrumentState::device,
                    "A DeviceCoupling: off unless its device needs it.");
  def_vector(instrument, "hand", &InstrumentState::hand,
             "[m] where the tool is drawn to: the hand, unless that jumped.");
  def_copy(instrument);
  def_summary(instrument, [](const InstrumentState& self) {
    return std::string(self.tool.hold_count > 0 ? "attached"
                       : self.tool.touching     ? "touching"
                                                : "not touching");
  });

  py::class_<ContactPair> pair(m, "ContactPair",
                               "What an instrument may touch of a body, and what it does to it.");
  pair.def_readonly("candidates", &ContactPair::candidates,
                    "What the tool may touch in this tick; read-only.")
      .def_readonly("load", &ContactPair::load,
                    "What the tool did in the last substep; read-only.");
  def_copy(pair);
  def_summary(pair, [](const ContactPair& self) {
    return write_text(self.candidates.count, " candidates, ", self.load.push_count, " pushes");
  });
}

void bind_body_pair_state(py::module_& m) {
  py::class_<BodyPairState> pair(m, "BodyPairState",
                                 "How two bodies of a running scene touch, after every tick.");
  pair.def(py::init<>());
  pair.def_readonly("near", &BodyPairState::near, "Some of their surfaces may come to touch.")
      .def_readonly("touching", &BodyPairState::touching,
                    "Vertices and middles of long edges within the thickness, in the last substep.")
      .def_readonly("least_gap", &BodyPairState::least_gap,
                    "[m] between the surfaces where they were nearest in the last tick, below 0 "
                    "inside of each other; infinite where nothing was within the thickness.");
  def_vector(pair, "force", &BodyPairState::force,
             "[N] on the second body, mean of the last tick; 0 of a body with itself.");
  def_value(pair, &BodyPairState::near, &BodyPairState::touching, &BodyPairState::least_gap,
            &BodyPairState::force);
  def_repr(pair, {"near", "touching", "least_gap", "force"});
}

}  // namespace

void bind_world(py::module_& m) {
  bind_states(m);
  bind_body_pair_state(m);
  py::class_<World> world(m, "World",
                          "A running scene. Everything a tick needs is allocated here, once.");
  world.def(py::init([](const Scene& scene, bool recovers) {
              require_built(scene);
              const py::gil_scoped_release released;
              World made(scene);
              made.recovers = recovers;
              return made;
            }),
            "scene"_a, py::kw_only(), "recovers"_a = true, "The scene at rest.");
  def_elements(world, "bodies", &World::bodies, "As Scene.bodies, a tuple; read-only.");
  def_elements(world, "rigid", &World::rigid, "As Scene.rigid, a tuple.");
  def_elements(world, "instruments", &World::instruments,
               "As Scene.instruments, a tuple; read-only.");
  def_elements(world, "pairs", &World::pairs,
               "Every instrument with every body, a tuple; read-only.");
  def_elements(world, "body_pairs", &World::body_pairs, "As Scene.body_pairs, a tuple; read-only.");
  def_elements(world, "scenery_contacts", &World::scenery_contacts,
               "As Scene.scenery, one for each body that it lists, a tuple; read-only.");
  world
      .def(
          "bound_coupling",
          [](World& self, int instrument, double passive_stiffness, double delay) {
            require_index("instrument", instrument, self.instruments.size());
            if (self.tick_count > 0) {
              throw py::value_error(
                  "bound_coupling: got a world that has ticked, expected it "
                  "before its first tick");
            }
            for (const double value : {passive_stiffness, delay}) {
              if (value >= 0.0 && std::isfinite(value)) continue;
              throw py::value_error(write_text("bound_coupling: got ", passive_stiffness,
                                               " N/m and ", delay,
                                               " s, expected finite numbers of at least 0"));
            }
            DeviceCoupling& coupling = self.instruments[std::size_t(instrument)].device;
            coupling.passive_stiffness = passive_stiffness;
            coupling.delay = delay;
          },
          "instrument"_a, "passive_stiffness"_a, "delay"_a,
          "Has an instrument felt through a device that bears no more of a spring, as a live run "
          "has it. Before the first tick; raises ValueError after it.\n\nArgs:\n"
          "    instrument: Which, from 0.\n"
          "    passive_stiffness: [N/m] See find_passive_stiffness; 0 for the instrument's own.\n"
          "    delay: [s] By which a force is late, T/2 + d.")
      .def(
          "pair",
          [](const py::object& self, int instrument, int body) -> py::object {
            const auto& its = self.cast<const World&>();
            require_index("instrument", instrument, its.instruments.size());
            require_index("body", body, its.bodies.size());
            return self.attr("pairs")[py::int_(instrument * its.bodies.size() + body)];
          },
          "instrument"_a, "body"_a, "An instrument with a body; read-only.")
      .def_readonly("alarm", &World::alarm,
                    "The first alarm; from then on the forces fade and all tissue stands still.")
      .def_readonly("alarm_body", &World::alarm_body,
                    "Whose tissue raised it; -1 for what is of no body.")
      .def_readonly("tick_count", &World::tick_count, "How many ticks have been run.")
      .def_readonly("recovers", &World::recovers,
                    "Whether a tick in which a body blows up is done again, from where it began, "
                    "under the body's next safeguard, before its alarm stands. What judges a "
                    "scene as it is asks for none of it.")
      .def_readonly("measures_costs", &World::measures_costs,
                    "Whether tick() keeps costs: forces are the same to the bit with and without, "
                    "and a tick takes some microseconds more.")
      .def_readonly("costs", &World::costs, "Of the last tick; read-only.");
  def_copy(world);
  def_summary(world, [](const World& self) {
    std::size_t particles = 0;
    for (const SoftState& body : self.bodies) particles += body.tissue.position.size();
    bool touching = false;
    for (const InstrumentState& each : self.instruments) touching |= each.tool.touching;
    return write_text("tick ", self.tick_count, ", ", particles, " particles, ",
                      self.alarm ? "stopped by an alarm"
                      : touching ? "touching"
                                 : "not touching");
  });
}

}  // namespace palpate::bindings
