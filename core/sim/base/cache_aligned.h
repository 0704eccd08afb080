// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace palpate {

/// Memory that begins with a cache line, so that no vector of up to 64 bytes lies across two.
template <class T>
struct CacheAlignedAllocator {
  using value_type = T;
  static constexpr std::align_val_t kCacheLine{64};

  CacheAlignedAllocator() = default;
  template <class U>
  CacheAlignedAllocator(const CacheAlignedAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), kCacheLine));
  }
  void deallocate(T* memory, std::size_t) noexcept { ::operator delete(memory, kCacheLine); }
  friend bool operator==(const CacheAlignedAllocator&, const CacheAlignedAllocator&) = default;
};

template <class T>
using CacheAligned = std::vector<T, CacheAlignedAllocator<T>>;

}  // namespace palpate
