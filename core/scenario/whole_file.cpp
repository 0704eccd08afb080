// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/whole_file.h"

#include <fcntl.h>

#include "palpate/sim/base/private/whole_file.h"
#include "palpate/sim/session/private/record_file.h"

namespace palpate::scenario {

using record_layout::File;

Bytes read_whole(const std::string& path, std::size_t most) {
  // a pipe without a writer would be waited for
  const File file(path, O_RDONLY | O_NONBLOCK);
  const std::uint64_t size = file.size();
  if (size > most) {
    file.refuse("", std::to_string(size) + " bytes", "at most " + std::to_string(most));
  }
  return file.read(0, static_cast<std::size_t>(size));
}

void write_whole(const std::string& path, std::span<const std::uint8_t> bytes) {
  WholeFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace palpate::scenario
