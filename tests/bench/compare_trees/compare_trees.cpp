// SPDX-License-Identifier: BSD-3-Clause
// Our tree beside Embree's, CGAL's and FCL's: one surface, the same questions, the same answers.
//
//     compare_trees SURFACE.obj [--json]
//
// Fails where answers differ or a row is missing. Times are CPU times of the process, medians of
// rounds in which everyone takes a turn, so that a slow moment of the machine falls on all.
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <stdexcept>

#include "peer.h"

namespace palpate::bench {
namespace {

constexpr int kQuestions = 4000;
constexpr int kRounds = 31;
const std::vector<std::string> kWorks = {"refit", "segment", "closest", "sphere"};
const std::vector<std::string> kPeers = {"Palpate", "Embree", "CGAL", "FCL"};

struct Row {
  std::string work, peer, note;
  double median = 0.0;       ///< [s] per refit or question
  double ratio = 0.0;        ///< to ours: above 1 we are faster
  double disagreeing = 0.0;  ///< share of the answers
};

double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Does one piece of work `count` times.
void do_work(Peer& peer, const std::string& name, const Workload& work, std::size_t count,
             std::vector<double>& answers) {
  if (name == "refit") peer.refit();
  if (name == "segment") peer.segment(work, count, answers);
  if (name == "closest") peer.closest(work, count, answers);
  if (name == "sphere") peer.sphere(work, count, answers);
}

bool agree(const std::string& work, double ours, double theirs, double tolerance) {
  if (work != "segment") return std::abs(ours - theirs) <= (work == "closest" ? tolerance : 0.0);
  if ((ours < 0.0) != (theirs < 0.0)) return false;
  // 0: told only that something was hit
  return theirs <= 0.0 || std::abs(ours - theirs) <= 10.0 * tolerance;
}

/// The share of answers that are not ours. Floats and the edges of a ball allow for a few.
double compare_answers(const std::string& name, Peer& own, Peer& peer, const Workload& work) {
  const std::size_t count = peer.questions(work);
  std::vector<double> ours(count), theirs(count);
  do_work(own, name, work, count, ours);
  do_work(peer, name, work, count, theirs);
  int differing = 0;
  for (std::size_t q = 0; q < count; ++q) {
    differing += !agree(name, ours[q], theirs[q], peer.tolerance());
  }
  return static_cast<double>(differing) / static_cast<double>(count);
}

std::vector<Row> time_work(const std::string& name, std::vector<std::unique_ptr<Peer>>& peers,
                           const Workload& work) {
  std::vector<double> answers(work.from.size());
  std::vector<std::vector<double>> times(peers.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t p = 0; p < peers.size(); ++p) {
      const std::size_t count = name == "refit" ? 1 : peers[p]->questions(work);
      // what takes a tenth of a second need not be done so often
      if (round >= 5 && median(times[p]) * static_cast<double>(count) > 0.1) continue;
      if (name == "refit") peers[p]->prepare(round % 2 == 0 ? work.moved : work.x);
      const double start = cpu_time();
      do_work(*peers[p], name, work, count, answers);
      times[p].push_back((cpu_time() - start) / static_cast<double>(count));
    }
  }
  std::vector<Row> rows;
  for (std::size_t p = 0; p < peers.size(); ++p) {
    Row row{name, peers[p]->name(), peers[p]->note(name), median(times[p]), 0.0, 0.0};
    row.ratio = row.median / median(times[0]);
    rows.push_back(row);
  }
  return rows;
}

/// Every work for every peer, at rest; refit last, and after it the answers once more, moved.
std::vector<Row> compare(const Workload& work) {
  std::vector<std::unique_ptr<Peer>> peers;
  peers.push_back(make_own(work));
  peers.push_back(make_embree(work));
  peers.push_back(make_cgal(work));
  peers.push_back(make_fcl(work));
  std::vector<Row> rows;
  for (const std::string& name : {kWorks[1], kWorks[2], kWorks[3], kWorks[0]}) {
    for (Row& row : time_work(name, peers, work)) rows.push_back(std::move(row));
  }
  for (const Vec3Array* x : {&work.x, &work.moved}) {
    for (auto& peer : peers) {
      peer->prepare(*x);
      peer->refit();
    }
    for (Row& row : rows) {
      if (row.work == "refit") continue;
      const auto peer = std::find_if(peers.begin(), peers.end(),
                                     [&](const auto& p) { return p->name() == row.peer; });
      row.disagreeing =
          std::max(row.disagreeing, compare_answers(row.work, *peers[0], **peer, work));
    }
  }
  return rows;
}

void print_table(const std::vector<Row>& rows, const Workload& work) {
  std::printf("%zu vertices, %zu triangles; a ratio above 1 says that Palpate is faster\n",
              work.x.size(), work.triangles.size());
  for (const Row& row : rows) {
    std::printf("%-8s %-8s %12.0f ns %9.2f x   other answers %5.2f %%   %s\n", row.work.c_str(),
                row.peer.c_str(), 1e9 * row.median, row.ratio, 100.0 * row.disagreeing,
                row.note.c_str());
  }
}

void print_json(const std::vector<Row>& rows, const Workload& work) {
  std::printf("{\"vertices\": %zu, \"triangles\": %zu, \"rows\": [", work.x.size(),
              work.triangles.size());
  const char* comma = "";
  for (const Row& row : rows) {
    std::printf("%s\n  {\"work\": \"%s\", \"library\": \"%s\", \"median_us\": %.6g, ", comma,
                row.work.c_str(), row.peer.c_str(), 1e6 * row.median);
    std::printf("\"ratio_to_palpate\": %.4g, \"other_answers\": %.3g, \"note\": \"%s\"}", row.ratio,
                row.disagreeing, row.note.c_str());
    comma = ",";
  }
  std::printf("\n]}\n");
}

/// What is wrong with the rows, in words; empty where nothing is.
std::string find_fault(const std::vector<Row>& rows) {
  // of the answers: float may miss an edge of a triangle or of a ball
  constexpr double kAllowed = 0.005;
  for (const std::string& work : kWorks) {
    for (const std::string& peer : kPeers) {
      const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
        return r.work == work && r.peer == peer && r.median > 0.0;
      });
      if (row == rows.end()) return "no row for " + work + " by " + peer;
      if (!(row->disagreeing <= kAllowed)) return "other answers to " + work + " by " + peer;
    }
  }
  return "";
}

int run(const std::string& surface, bool json) {
  const Workload work = read_workload(surface, kQuestions);
  const std::vector<Row> rows = compare(work);
  json ? print_json(rows, work) : print_table(rows, work);
  const std::string fault = find_fault(rows);
  if (fault.empty()) return 0;
  std::fprintf(stderr, "compare_trees: %s\n", fault.c_str());
  return 1;
}

}  // namespace
}  // namespace palpate::bench

int main(int count, char** words) {
  const bool json = count == 3 && std::strcmp(words[2], "--json") == 0;
  if (count != 2 && !json) {
    std::fprintf(stderr, "usage: compare_trees SURFACE.obj [--json]\n");
    return 2;
  }
  try {
    return palpate::bench::run(words[1], json);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_trees: %s\n", error.what());
    return 1;
  }
}
