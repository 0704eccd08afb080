// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/version.h"

namespace palpate {

const char* library_version() noexcept { return PALPATE_VERSION_STRING; }

}  // namespace palpate
