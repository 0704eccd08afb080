// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate::authoring {

/// What write_mesh puts at the head of its files: read_mesh finds unit and up axis stated by it.
inline constexpr const char* kFileSignature = "palpate: unit m, up z";

}  // namespace palpate::authoring
