// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/confine.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace palpate::authoring {
namespace {

// linux/landlock.h of a newer kernel than the one this may be compiled beside; the numbers of the
// calls are the same on every processor
constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr unsigned kAskVersion = 1, kRulePathBeneath = 1;
constexpr std::uint64_t kReadFile = 1u << 2, kReadFolder = 1u << 3;

struct Ruleset {
  std::uint64_t handled_access_fs = 0, handled_access_net = 0, scoped = 0;
};

struct __attribute__((packed)) PathBeneath {
  std::uint64_t allowed_access;
  std::int32_t parent;
};

/// What is denied unless a rule allows it: all that the kernel's version knows.
Ruleset build_ruleset(long version) {
  const int rights = version >= 5 ? 16 : version >= 3 ? 15 : version >= 2 ? 14 : 13;
  Ruleset ruleset{.handled_access_fs = (std::uint64_t{1} << rights) - 1};
  if (version >= 4) ruleset.handled_access_net = 3;  // to bind, to connect
  if (version >= 6) ruleset.scoped = 3;              // abstract sockets, signals
  return ruleset;
}

std::size_t size_for(long version) {
  return (version >= 6 ? 3 : version >= 4 ? 2 : 1) * sizeof(std::uint64_t);
}

bool allow(long ruleset, const std::filesystem::path& path, std::uint64_t access) {
  const int handle = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (handle < 0) return false;
  const PathBeneath rule{access, handle};
  const bool added = ::syscall(kAddRule, ruleset, kRulePathBeneath, &rule, 0u) == 0;
  ::close(handle);
  return added;
}

}  // namespace

MeshFolder::MeshFolder(const std::filesystem::path& mesh) {
  std::error_code problem;
  mesh_ = std::filesystem::canonical(mesh, problem);
  folder_ = std::filesystem::canonical(mesh.has_parent_path() ? mesh.parent_path() : ".", problem);
}

bool MeshFolder::holds(const std::filesystem::path& path) const {
  std::error_code problem;
  const auto found = std::filesystem::canonical(path, problem);
  if (problem || !std::filesystem::is_regular_file(found, problem)) return false;
  if (found == mesh_) return true;
  if (folder_.empty()) return false;
  const auto [end, rest] =
      std::mismatch(folder_.begin(), folder_.end(), found.begin(), found.end());
  return end == folder_.end() && rest != found.end();
}

void confine_to(const MeshFolder& folder) {
  const long version = ::syscall(kCreateRuleset, nullptr, std::size_t{0}, kAskVersion);
  if (version < 1) return;
  const Ruleset wanted = build_ruleset(version);
  const long ruleset = ::syscall(kCreateRuleset, &wanted, size_for(version), 0u);
  const bool confined = ruleset >= 0 && allow(ruleset, folder.mesh(), kReadFile) &&
                        allow(ruleset, folder.folder(), kReadFile | kReadFolder) &&
                        ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                        ::syscall(kRestrictSelf, ruleset, 0u) == 0;
  if (!confined) std::_Exit(6);
  ::close(static_cast<int>(ruleset));
}

}  // namespace palpate::authoring
