// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>

#include "palpate/authoring/scene_stream.h"

namespace palpate::authoring {

/// Writes a scene in the form of scene_stream.h.
void write_scene(const ImportedScene& scene, std::FILE* out);

/// Writes where, got and expected of a refusal.
void write_refusal(const FileError& refusal, std::FILE* out);

}  // namespace palpate::authoring
