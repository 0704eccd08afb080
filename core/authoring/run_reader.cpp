// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/run_reader.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <thread>

namespace palpate::authoring {
namespace {

using Clock = std::chrono::steady_clock;

// some ten million triangles; more could not be simulated, and child and parent together must
// stay below 2 GB
constexpr std::size_t kMostBytes = 400'000'000;

[[noreturn]] void throw_system_error(const char* what) {
  throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
}

/// A child process and the pipe it writes to. Never outlives this object.
class Child {
 public:
  Child(const std::filesystem::path& program, std::vector<std::string> words) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw_system_error("pipe");
    out_ = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);

    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int failed =
        posix_spawn(&pid_, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (failed != 0) {
      close(out_);
      throw FileError(program.string(), "", std::strerror(failed),
                      "the program palpate-read-mesh of this installation");
    }
  }

  ~Child() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
    }
    close(out_);
  }

  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Appends what the child wrote; false at the end. Waits until `deadline` at most.
  bool read_more(Clock::time_point deadline, std::vector<char>& bytes) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd waiting{out_, POLLIN, 0};
    if (left.count() <= 0 || poll(&waiting, 1, static_cast<int>(left.count())) <= 0) return true;

    char buffer[65536];
    const ssize_t count = read(out_, buffer, sizeof buffer);
    if (count > 0) bytes.insert(bytes.end(), buffer, buffer + count);
    return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
  }

  /// The status of waitpid once the child has ended; none at the deadline.
  std::optional<int> wait(Clock::time_point deadline) {
    for (;;) {
      int status = 0;
      if (waitpid(pid_, &status, WNOHANG) == pid_) {
        pid_ = 0;
        return status;
      }
      if (Clock::now() >= deadline) return std::nullopt;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

 private:
  pid_t pid_ = 0;
  int out_ = -1;
};

std::string name_end(int status) {
  if (!WIFSIGNALED(status)) {
    return "a reader that ended with code " + std::to_string(WEXITSTATUS(status));
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU) return "a reader that used up its processor time";
  return std::string("content that crashes the reader (") + strsignal(signal) + ")";
}

std::string seconds(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", time);
  return text;
}

}  // namespace

std::vector<char> run_reader(const std::filesystem::path& path, const std::string& format,
                             const ReadOptions& options) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(options.time_limit));
  const auto processor_seconds = static_cast<long>(std::ceil(options.time_limit)) + 1;
  std::vector<std::string> words = {options.reader.string()};
  words.insert(words.end(), options.words.begin(), options.words.end());
  words.insert(words.end(), {path.string(), format, std::to_string(options.memory_limit),
                             std::to_string(processor_seconds)});
  Child child(options.reader, std::move(words));

  std::vector<char> bytes;
  bool more = true;
  while (more && Clock::now() < deadline) {
    more = child.read_more(deadline, bytes);
    if (bytes.size() > kMostBytes) {
      throw FileError(path.string(), "", "more than ten million triangles", "an organ's surface");
    }
  }
  const std::optional<int> status = more ? std::nullopt : child.wait(deadline);
  if (!status) {
    throw FileError(path.string(), "",
                    "content still being read after " + seconds(options.time_limit),
                    "a mesh that can be read in that time");
  }
  if (*status != 0) throw FileError(path.string(), "", name_end(*status), "a readable mesh file");
  return bytes;
}

}  // namespace palpate::authoring
