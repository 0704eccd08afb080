// SPDX-License-Identifier: BSD-3-Clause
// The kernels once more without vector code.
#include <bit>

#define PALPATE_TREE_PLAIN
#include "palpate/sim/tree/private/four_targets.h"

// first of all: it is what the others are made of
#include "palpate/sim/tree/private/four_plain.h"
//
#include "palpate/sim/tree/private/tree_queries-inl.h"

namespace palpate::tree_kernels {

const Kernels& plain() noexcept {
  static const Kernels kernels = plain_code::list_kernels("plain");
  return kernels;
}

}  // namespace palpate::tree_kernels
