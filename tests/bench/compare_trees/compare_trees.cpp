// SPDX-License-Identifier: BSD-3-Clause
// Our tree beside Embree's, CGAL's and FCL's: one surface, the same questions.
//
//     compare_trees SURFACE.obj [--json]
//
// All answers are held against those of a textbook tree, at rest and moved. Where a library's are
// others, its row says so and how far, and states no ratio: what is wrong cannot be too slow. Fails
// where ours are others or a row is missing. Times are CPU times of the process, medians of rounds
// in which everyone takes a turn, so that a slow moment of the machine falls on all.
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
const std::vector<std::string> kPeers = {"Palpate",    "textbook", "Embree refit",
                                         "Embree low", "CGAL",     "FCL"};
/// Of the answers: float may miss an edge of a triangle or of a ball.
constexpr double kAllowed = 0.005;

struct Row {
  std::string work, peer, note;
  double median = 0.0;       ///< [s] per refit or question
  double ratio = 0.0;        ///< to ours: above 1 we are faster
  double disagreeing = 0.0;  ///< share of the answers
  double farthest = 0.0;     ///< by which they differ most: [m], or triangles of a ball

  bool is_comparable() const { return disagreeing <= kAllowed; }
};

/// How the answers to one kind of question differ from the textbook's.
struct Difference {
  double share = 0.0, farthest = 0.0;
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

/// [m] or triangles by which two answers differ; a hit against none counts as nothing here.
double measure_gap(const std::string& work, double a, double b) {
  return work == "segment" && (a < 0.0 || b <= 0.0) ? 0.0 : std::abs(a - b);
}

Difference compare_answers(const std::string& name, Peer& textbook, Peer& peer,
                           const Workload& work) {
  const std::size_t count = peer.questions(work);
  std::vector<double> expected(count), found(count);
  do_work(textbook, name, work, count, expected);
  do_work(peer, name, work, count, found);
  Difference difference;
  for (std::size_t q = 0; q < count; ++q) {
    if (agree(name, expected[q], found[q], peer.tolerance())) continue;
    difference.share += 1.0 / static_cast<double>(count);
    difference.farthest = std::max(difference.farthest, measure_gap(name, expected[q], found[q]));
  }
  return difference;
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
    Row row{name, peers[p]->name(), peers[p]->note(name), median(times[p])};
    row.ratio = row.median / median(times[0]);
    rows.push_back(row);
  }
  return rows;
}

/// Every work for every peer, at rest; refit last, and after it the answers once more, moved.
std::vector<Row> compare(const Workload& work) {
  std::vector<std::unique_ptr<Peer>> peers;
  for (const auto make :
       {make_own, make_textbook, make_embree_refit, make_embree_low, make_cgal, make_fcl}) {
    peers.push_back(make(work));
  }
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
      const Difference difference = compare_answers(row.work, *peers[1], **peer, work);
      row.disagreeing = std::max(row.disagreeing, difference.share);
      row.farthest = std::max(row.farthest, difference.farthest);
    }
  }
  return rows;
}

void print_table(const std::vector<Row>& rows, const Workload& work) {
  std::printf("%zu vertices, %zu triangles; a ratio above 1 says that Palpate is faster\n",
              work.x.size(), work.triangles.size());
  for (const Row& row : rows) {
    std::printf("%-8s %-12s %12.0f ns ", row.work.c_str(), row.peer.c_str(), 1e9 * row.median);
    if (row.is_comparable()) {
      std::printf("%9.2f x   %s\n", row.ratio, row.note.c_str());
    } else {
      std::printf("answers differ: not compared (%.1f %% of them, by up to %.3g %s)   %s\n",
                  100.0 * row.disagreeing, row.work == "sphere" ? row.farthest : 1e3 * row.farthest,
                  row.work == "sphere" ? "triangles" : "mm", row.note.c_str());
    }
  }
}

void print_json(const std::vector<Row>& rows, const Workload& work) {
  std::printf("{\"vertices\": %zu, \"triangles\": %zu, \"rows\": [", work.x.size(),
              work.triangles.size());
  const char* comma = "";
  for (const Row& row : rows) {
    std::printf("%s\n  {\"work\": \"%s\", \"library\": \"%s\", \"median_us\": %.6g, ", comma,
                row.work.c_str(), row.peer.c_str(), 1e6 * row.median);
    row.is_comparable() ? std::printf("\"ratio_to_palpate\": %.4g, ", row.ratio)
                        : std::printf("\"ratio_to_palpate\": null, ");
    std::printf("\"other_answers\": %.3g, \"farthest_answer\": %.3g, \"note\": \"%s\"}",
                row.disagreeing, row.farthest, row.note.c_str());
    comma = ",";
  }
  std::printf("\n]}\n");
}

/// What is wrong with the rows, in words; empty where nothing is.
std::string find_fault(const std::vector<Row>& rows) {
  for (const std::string& work : kWorks) {
    for (const std::string& peer : kPeers) {
      const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
        return r.work == work && r.peer == peer && r.median > 0.0;
      });
      if (row == rows.end()) return "no row for " + work + " by " + peer;
      if (peer == "Palpate" && !row->is_comparable()) return "our answers to " + work + " differ";
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
