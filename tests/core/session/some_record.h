// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "palpate/sim/session/record.h"

namespace palpate::testing {

/// A folder of its own for one test, gone with it; in memory where there is such a place, for
/// these tests write tens of thousands of files.
struct Folder {
  Folder() {
    const std::filesystem::path memory = "/dev/shm";
    const bool usable = ::access(memory.c_str(), W_OK | X_OK) == 0;
    const auto parent = usable ? memory : std::filesystem::temp_directory_path();
    std::string pattern = (parent / "palpate-XXXXXX").string();
    path = ::mkdtemp(pattern.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string file(const char* name) const { return (path / name).string(); }
  std::filesystem::path path;
};

inline TickLog::Tick some_tick(std::int64_t i) {
  std::mt19937_64 random(static_cast<std::uint64_t>(i) + 1);
  std::normal_distribution<double> noise(0.0, 2e-5);
  TickLog::Tick tick;
  const double t = 1e-3 * static_cast<double>(i);
  tick.tick = i;
  tick.sample.time = t;
  tick.sample.position = Vec3(0.02 * std::sin(t), 0.01 * std::cos(3 * t), noise(random));
  tick.sample.orientation = Quaternion(Eigen::AngleAxisd(0.3 * t, Vec3::UnitY()));
  tick.sample.velocity = Vec3(0.02 * std::cos(t), -0.0, noise(random));
  tick.sample.buttons = static_cast<std::uint8_t>(i / 100 % 2);
  tick.sample.grip = 0.1 * t;
  tick.felt.force = Eigen::Vector3f(0.1f * static_cast<float>(i % 7), -0.5f, 1e-3f);
  tick.felt.position = tick.sample.position.cast<float>();
  tick.felt.touched = static_cast<std::uint8_t>(i % 3);
  tick.felt.lateness_us = static_cast<std::uint16_t>(random());
  return tick;
}

inline Record some_record(int ticks, int instruments = 1) {
  Record record;
  record.header = R"({"kernel":"reference"})";
  record.instruments = instruments;
  for (int i = 0; i < ticks; ++i) {
    for (int instrument = 0; instrument < instruments; ++instrument) {
      const TickLog::Tick tick = some_tick(i + 1000 * instrument);
      record.hand.push_back(tick.sample);
      record.felt.push_back(tick.felt);
    }
  }
  record.events = {{3, EventKind::attached, 12, 0.25}, {5, EventKind::released, 12, 0}};
  record.hashes = {{4, {0x0123456789abcdef, 0xfedcba9876543210}}};
  for (Event& event : record.events) event.source = instruments - 1;
  return record;
}

inline bool same_bits(const HapticSample& a, const HapticSample& b) {
  const auto same = [](const double* x, const double* y, std::size_t n) {
    return std::memcmp(x, y, n * sizeof(double)) == 0;
  };
  return same(&a.time, &b.time, 1) && same(a.position.data(), b.position.data(), 3) &&
         same(a.orientation.coeffs().data(), b.orientation.coeffs().data(), 4) &&
         same(a.velocity.data(), b.velocity.data(), 3) && a.buttons == b.buttons &&
         same(&a.grip, &b.grip, 1);
}

inline bool same_bits(const Felt& a, const Felt& b) {
  return std::memcmp(a.force.data(), b.force.data(), 12) == 0 &&
         std::memcmp(a.position.data(), b.position.data(), 12) == 0 && a.touched == b.touched &&
         a.lateness_us == b.lateness_us;
}

/// Whether the ticks of `part` are those of `whole`, up to where `part` ends.
inline bool is_prefix(const Record& part, const Record& whole) {
  if (part.instruments != whole.instruments) return false;
  if (part.hand.size() > whole.hand.size() || part.felt.size() != part.hand.size()) return false;
  for (std::size_t i = 0; i < part.hand.size(); ++i) {
    if (!same_bits(part.hand[i], whole.hand[i]) || !same_bits(part.felt[i], whole.felt[i])) {
      return false;
    }
  }
  if (part.events.size() > whole.events.size()) return false;
  for (std::size_t i = 0; i < part.events.size(); ++i) {
    const Event &a = part.events[i], &b = whole.events[i];
    if (a.tick != b.tick || a.kind != b.kind || a.index != b.index || a.value != b.value ||
        a.source != b.source) {
      return false;
    }
  }
  if (part.hashes.size() > whole.hashes.size()) return false;
  for (std::size_t i = 0; i < part.hashes.size(); ++i) {
    if (part.hashes[i].tick != whole.hashes[i].tick ||
        part.hashes[i].hash != whole.hashes[i].hash) {
      return false;
    }
  }
  return true;
}

inline bool is_same(const Record& a, const Record& b) { return is_prefix(a, b) && is_prefix(b, a); }

inline std::vector<char> read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::string& path, const std::vector<char>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace palpate::testing
