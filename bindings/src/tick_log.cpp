// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/tick_log.h"

#include <pybind11/native_enum.h>

#include "bindings.h"
#include "border.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {

template <>
py::dtype row_dtype<Felt>() {
  return RowType<Felt>()
      .field("force", &Felt::force)
      .field("position", &Felt::position)
      .field("touched", &Felt::touched)
      .field("lateness_us", &Felt::lateness_us)
      .dtype();
}

template <>
py::dtype row_dtype<Event>() {
  return RowType<Event>()
      .field("tick", &Event::tick)
      .integer("kind", &Event::kind)
      .field("index", &Event::index)
      .field("value", &Event::value)
      .field("source", &Event::source)
      .dtype();
}

template <>
py::dtype row_dtype<StateHash>() {
  return RowType<StateHash>()
      .field("tick", &StateHash::tick)
      .field("hash", &StateHash::hash)
      .dtype();
}

template <>
py::dtype row_dtype<TickLog::Tick>() {
  return RowType<TickLog::Tick>()
      .field("tick", &TickLog::Tick::tick)
      .nested("sample", &TickLog::Tick::sample, row_dtype<HapticSample>())
      .nested("felt", &TickLog::Tick::felt, row_dtype<Felt>())
      .dtype();
}

namespace {

void bind_log_rows(py::module_& m) {
  py::class_<Felt> felt(m, "Felt", "What was felt in one tick, of one instrument.");
  felt.def(py::init<>());
  felt.def_property(
      "force", [](const py::object& self) { return view_one(self.cast<Felt&>().force, self); },
      [](Felt& self, const Eigen::Vector3f& value) { self.force = value; },
      "[N] float32, shape (3,), from tick(), before the safety wrapper.");
  felt.def_property(
      "position",
      [](const py::object& self) { return view_one(self.cast<Felt&>().position, self); },
      [](Felt& self, const Eigen::Vector3f& value) { self.position = value; },
      "[m] float32, shape (3,), the tool.");
  felt.def_readwrite("touched", &Felt::touched,
                     "Bit 0: touching, bit 1: attached, bit 2 (NOT_RENDERED): the device's motors "
                     "were not on, so nobody felt the force.")
      .def_readwrite("lateness_us", &Felt::lateness_us, "[us] saturates.");
  felt.attr("dtype") = row_dtype<Felt>();
  m.attr("TOUCHING") = kTouching;
  m.attr("ATTACHED") = kAttached;
  m.attr("NOT_RENDERED") = kNotRendered;
  def_value(felt, &Felt::force, &Felt::position, &Felt::touched, &Felt::lateness_us);
  def_repr(felt, {"force", "position", "touched", "lateness_us"});

  // an integer in Python too, to be compared with the column of a structured array
  py::native_enum<EventKind>(m, "EventKind", "enum.IntEnum", "What may happen at a tick.")
      .value("missed_ticks", EventKind::missed_ticks,
             "index: how many were skipped before this tick")
      .value("record_gap", EventKind::record_gap, "index: how many ticks the log had no room for")
      .value("alarm", EventKind::alarm, "index: AlarmKind")
      .value("fault", EventKind::fault, "index: DeviceFault; value: what it found, [m] or [m/s]")
      .value("attached", EventKind::attached)
      .value("released", EventKind::released)
      .value("paused", EventKind::paused, "value: how long [s] the loop rested before this tick")
      .value("tree_exchanged", EventKind::tree_exchanged,
             "index: ticks since its positions were taken; value: what the cost of queries had "
             "grown by")
      .value("motors_off", EventKind::motors_off, "index: MotorState, 1 silent, 2 off, 3 cut")
      .value("motors_on", EventKind::motors_on)
      .value("safeguard", EventKind::safeguard,
             "index: Safeguard of a body from this tick on; value: the AlarmKind that it averts, 0 "
             "where one was taken back")
      .value("passivity", EventKind::passivity,
             "the passivity controller began to damp; value: [J] that the hand was given")
      .value("tissue_exchanged", EventKind::tissue_exchanged,
             "index: ticks since the hands were told to the slow tissue that is felt from this "
             "tick on; value: [s] that it took")
      .value("coupling_limited", EventKind::coupling_limited,
             "from this tick on the hand's spring is bounded by what its device keeps passive; "
             "value: [N/m] that; index: [us] by which a force is late")
      .value("coupling_follows", EventKind::coupling_follows,
             "index 1: from this tick on the hand's spring is stiffer than that, as the tissue "
             "asks; 0: no more; value: [N/m] of the tissue")
      .finalize();
  py::class_<Event> event(m, "Event", "Something that happened at a tick.");
  event
      .def(py::init([](std::int64_t tick, EventKind kind, std::int32_t index, double value,
                       std::int32_t source) {
             return Event{tick, kind, index, value, source};
           }),
           py::kw_only(), "tick"_a = 0, "kind"_a = EventKind::missed_ticks, "index"_a = 0,
           "value"_a = 0.0, "source"_a = 0)
      .def_readwrite("tick", &Event::tick, "Its number.")
      .def_readwrite("kind", &Event::kind, "What happened.")
      .def_readwrite("index", &Event::index, "EventKind says of what.")
      .def_readwrite("value", &Event::value, "[s] or [-]; EventKind says what.")
      .def_readwrite(
          "source", &Event::source,
          "Which body an alarm, tree_exchanged or safeguard is of, or which instrument "
          "fault, attached, released, motors_off, motors_on, passivity, coupling_limited and "
          "coupling_follows are; else 0.");
  event.attr("dtype") = row_dtype<Event>();
  def_value(event, &Event::tick, &Event::kind, &Event::index, &Event::value, &Event::source);
  def_repr(event, {"tick", "kind", "index", "value", "source"});

  py::class_<StateHash> hash(m, "StateHash", "The world's hash after a tick (compute_hash).");
  hash.def(py::init([](std::int64_t tick, const std::array<std::uint64_t, 2>& value) {
             return StateHash{tick, value};
           }),
           py::kw_only(), "tick"_a = 0, "hash"_a = std::array<std::uint64_t, 2>{});
  hash.def_readwrite("tick", &StateHash::tick, "Its number.")
      .def_readwrite("hash", &StateHash::hash, "128 bits as two whole numbers.");
  hash.attr("dtype") = row_dtype<StateHash>();
  def_value(hash, &StateHash::tick, &StateHash::hash);
  def_repr(hash, {"tick", "hash"});
}

void bind_tick_log(py::module_& m) {
  py::class_<TickLog> log(
      m, "TickLog",
      "Where the haptic thread leaves what it did: rings with room for 4 s, one writer and one "
      "reader, without lock or allocation. A full ring is a counted gap, never a blocked tick.");
  py::class_<TickLog::Tick> tick(log, "Tick", "One tick of one instrument as logged.");
  tick.def(py::init([](std::int64_t number, const HapticSample& sample, const Felt& felt) {
             return TickLog::Tick{number, sample, felt};
           }),
           py::kw_only(), "tick"_a = 0, "sample"_a = HapticSample(), "felt"_a = Felt())
      .def_readwrite("tick", &TickLog::Tick::tick, "Its number.")
      .def_readwrite("sample", &TickLog::Tick::sample, "What the device said.")
      .def_readwrite("felt", &TickLog::Tick::felt, "What was felt.");
  def_value(tick, &TickLog::Tick::tick, &TickLog::Tick::sample, &TickLog::Tick::felt);
  def_repr(tick, {"tick", "felt", "sample"});
  tick.attr("dtype") = row_dtype<TickLog::Tick>();

  m.attr("MOST_LOGGED_INSTRUMENTS") = kMostLoggedInstruments;
  log.def(py::init([](int tick_capacity, int instruments) {
            require_positive("tick_capacity", tick_capacity);
            return std::make_unique<TickLog>(tick_capacity, instruments);
          }),
          "tick_capacity"_a = 4000, "instruments"_a = 1,
          "Room for so many ticks of so many instruments. Raises ValueError for none, or more "
          "than MOST_LOGGED_INSTRUMENTS.");
  log.def("push", py::overload_cast<const TickLog::Tick&>(&TickLog::push), "tick"_a,
          "For the one writer of a log of one instrument; False, and counted, when there is no "
          "room.")
      .def(
          "push",
          [](TickLog& self, const std::vector<TickLog::Tick>& ticks) { return self.push(ticks); },
          "ticks"_a, "A tick of all instruments in order; False also for another number of them.")
      .def("push", py::overload_cast<const Event&>(&TickLog::push), "event"_a, "Likewise.")
      .def("push", py::overload_cast<const StateHash&>(&TickLog::push), "hash"_a, "Likewise.")
      .def(
          "take",
          [](TickLog& self) {
            std::vector<TickLog::Tick> ticks;
            std::vector<Event> events;
            std::vector<StateHash> hashes;
            self.take(ticks, events, hashes);
            return py::make_tuple(own_rows(std::move(ticks), self.instruments()),
                                  own_rows(std::move(events)), own_rows(std::move(hashes)));
          },
          "For the one reader: ticks, events and hashes that have arrived since the last call, "
          "as structured arrays of shape (k,); ticks of several instruments have a column for "
          "each.")
      .def("instruments", &TickLog::instruments, "How many every tick has a row of.")
      .def("gap_count", &TickLog::gap_count, "How many ticks it had no room for.");
}

}  // namespace

void bind_log(py::module_& m) {
  bind_log_rows(m);
  bind_tick_log(m);
}

}  // namespace palpate::bindings
