// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/native_enum.h>
#include <pybind11/stl/filesystem.h>

#include <optional>
#include <utility>

#include "bindings.h"
#include "border.h"
#include "interrupt.h"
#include "palpate/sim/session/record.h"
#include "rows.h"
#include "task_bindings.h"
#include "value.h"

namespace palpate::bindings {

namespace {

using Path = std::filesystem::path;
using Release = py::call_guard<py::gil_scoped_release>;

Record make_record(const std::string& header, const py::object& hand, const py::object& felt,
                   const py::object& events, const py::object& hashes, bool complete,
                   std::optional<int> instruments) {
  int hands = 1, felts = 1;
  Record record{header,
                copy_rows<HapticSample>(hand, "hand", &hands),
                copy_rows<Felt>(felt, "felt", &felts),
                copy_rows<Event>(events, "events"),
                copy_rows<StateHash>(hashes, "hashes"),
                complete};
  record.instruments = instruments.value_or(hands);
  for (const auto& [name, columns] : {std::pair("hand", hands), std::pair("felt", felts)}) {
    if (columns == record.instruments || (columns == 1 && instruments)) continue;
    refuse(name, std::to_string(columns) + " columns",
           std::to_string(record.instruments) + ", one for each instrument");
  }
  count_ticks(record);
  return record;
}

void bind_record(py::module_& m) {
  py::class_<Record> record(m, "Record", "A whole run in memory: enough to run it again.");
  record.def(py::init(&make_record), py::kw_only(), "header"_a = "", "hand"_a = py::tuple(),
             "felt"_a = py::tuple(), "events"_a = py::tuple(), "hashes"_a = py::tuple(),
             "complete"_a = false, "instruments"_a = py::none(),
             "Copies its tables: structured arrays with the dtype of HapticSample, Felt, Event "
             "and StateHash, or lists of these. hand and felt of k instruments have the shape "
             "(n, k), or are lists with those of each tick in order, and instruments says how "
             "many.");
  record.def_readwrite("header", &Record::header,
                       "JSON: version, kernel, build, scene hash, device, columns, ...");
  def_rows(record, "hand", &Record::hand, &Record::instruments,
           "Per tick, a structured array with the fields of HapticSample, shape (n,), or (n, k) of "
           "k instruments; a view.");
  def_rows(record, "felt", &Record::felt, &Record::instruments,
           "Per tick, a structured array with the fields of Felt, shape (n,), or (n, k) of k "
           "instruments; a view.");
  def_rows(record, "events", &Record::events,
           "A structured array with the fields of Event, shape (n,); a view.");
  def_rows(record, "hashes", &Record::hashes,
           "At 1 Hz, a structured array with the fields of StateHash, shape (n,); a view.");
  record.def_readwrite("complete", &Record::complete,
                       "The file has its summary and the summary's SHA-256 holds.");
  record.def_readonly("instruments", &Record::instruments, "Rows of hand and of felt a tick.");
  def_value(record, &Record::header, &Record::hand, &Record::felt, &Record::events, &Record::hashes,
            &Record::complete, &Record::instruments);
  record.def("__repr__", [](const Record& self) {
    const std::string instruments =
        self.instruments == 1 ? "" : std::to_string(self.instruments) + " instruments, ";
    return "Record(" + std::to_string(count_ticks(self)) + " ticks, " + instruments +
           (self.complete ? "complete" : "incomplete") + ")";
  });
  m.def("count_ticks", &count_ticks, "record"_a,
        "Ticks of a record. Raises ValueError where hand and felt are not as many whole ones.");
}

#ifdef PALPATE_RECORD_FILES
void bind_record_files(py::module_& m) {
  py::native_enum<RecordCodec>(m, "RecordCodec", "enum.Enum", "How a block's body is stored.")
      .value("none", RecordCodec::none)
      .value("deflate", RecordCodec::deflate)
      .finalize();
  py::class_<Recorder>(
      m, "Recorder", py::release_gil_before_calling_cpp_dtor(),
      "Writes a .prec record while it is being made, readable up to its last whole block at any "
      "moment. As a context manager it finishes at the end.")
      .def(py::init([](const Path& path, const std::string& header_json, RecordCodec codec,
                       int instruments, int bodies) {
             return std::make_unique<Recorder>(path.string(), header_json, codec, instruments,
                                               bodies);
           }),
           "path"_a, "header_json"_a, "codec"_a = RecordCodec::deflate, "instruments"_a = 1,
           "bodies"_a = 1, Release(),
           "header_json is one JSON object; the column table and the format version are added to "
           "it. instruments and bodies are how many the scene has. Raises FileError when the file "
           "cannot be written, ValueError for a bad header or none of them.")
      .def("log", &Recorder::log, py::return_value_policy::reference_internal,
           "Where the haptic thread pushes; hand it to a Loop.")
      .def("finish", &Recorder::finish, Release(),
           "Writes what is left, then the summary; syncs. Raises FileError.")
      .def(
          "__enter__", [](Recorder& self) -> Recorder& { return self; },
          py::return_value_policy::reference)
      .def("__exit__", [](Recorder& self, const py::args&) {
        const py::gil_scoped_release released;
        self.finish();
      });
  m.def(
      "write_record",
      [](const Path& path, const Record& record, RecordCodec codec) {
        write_record(path.string(), record, codec);
      },
      "path"_a, "record"_a, "codec"_a = RecordCodec::deflate, Release(),
      "Writes a whole record at once, to a temporary name, synced, renamed. Raises FileError.");
  m.def(
      "read_record", [](const Path& path) { return read_record(path.string()); }, "path"_a,
      Release(),
      "Reads a record; an unfinished file ends at its last good block (complete = False). Raises "
      "FileError for anything else that is wrong, naming block and field.");
}
#endif

void bind_replay(py::module_& m) {
  py::class_<ReplayReport> report(m, "ReplayReport",
                                  "How a replay compares with what was recorded.");
  report.def_readonly("ticks", &ReplayReport::ticks, "How many were run.")
      .def_readonly("equal", &ReplayReport::equal,
                    "Every force, every tool position and every hash, bit by bit.")
      .def_readonly("first_difference", &ReplayReport::first_difference, "Tick, -1 for none.")
      .def_readonly("largest_force_difference", &ReplayReport::largest_force_difference, "[N]")
      .def_readonly("largest_position_difference", &ReplayReport::largest_position_difference,
                    "[m] of the tool.");
  def_rows(report, "felt", &ReplayReport::felt, &ReplayReport::instruments,
           "As replayed, a structured array with the fields of Felt, shape as in the record; a "
           "view.");
  report.def_readonly("instruments", &ReplayReport::instruments, "Rows of felt a tick.");
  report.def_property_readonly(
      "task", [](const ReplayReport& self) { return self.task; },
      "The TaskState at its end; without steps where no task was judged.");
  def_rows(report, "events", &ReplayReport::events,
           "Of the task, as judged again, a structured array with the fields of Event, shape (k,); "
           "a view.");
  report.def_readonly("events_equal", &ReplayReport::events_equal, "The record has the very same.")
      .def_readonly("first_event_difference", &ReplayReport::first_event_difference,
                    "Tick, -1 for none.");
  def_value(report, &ReplayReport::ticks, &ReplayReport::equal, &ReplayReport::first_difference,
            &ReplayReport::largest_force_difference, &ReplayReport::largest_position_difference,
            &ReplayReport::felt, &ReplayReport::instruments, &ReplayReport::task,
            &ReplayReport::events, &ReplayReport::events_equal,
            &ReplayReport::first_event_difference);
  def_repr(report, {"ticks", "equal", "first_difference", "largest_force_difference",
                    "largest_position_difference"});
  m.def(
      "replay",
      [](const Scene& scene, const Record& record, const Task* task) {
        require_built(scene);
        if (task) require_fit(*task, scene);
        Interrupt interrupt;
        ReplayReport replayed;
        {
          const py::gil_scoped_release released;
          replayed = replay(scene, record, task, [&] { return interrupt.came(); });
        }
        interrupt.rethrow();
        return replayed;
      },
      "scene"_a, "record"_a, "task"_a = py::none(),
      "Runs the recorded hands through the same tick from a fresh world, and judges a task, of "
      "build_task with that scene, where one is given. What the judge leaves undecided came out as "
      "the record says: left, a fault of the device, or interrupted, where it does not say. Raises "
      "ValueError for a "
      "record with gaps, with more rows of hand than of felt, or of another number of instruments "
      "than the scene has. To learn what any hand would feel, give it zeros for felt, as many as "
      "rows of hand, and read the report's felt.");
  m.def("find_outcome", &find_outcome, "record"_a,
        "How the task of a recorded run came out: as its last event says, else interrupted, also "
        "for a record without a task.");
}

}  // namespace

void bind_session(py::module_& m) {
  bind_record(m);
#ifdef PALPATE_RECORD_FILES
  bind_record_files(m);
#endif
  bind_replay(m);
}

}  // namespace palpate::bindings
