// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <new>
#include <vector>

namespace palpate {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
// Eigen aligns what fills whole vector registers, and how wide those are depends on the flags of
// the program: such a type in a public struct would lie elsewhere in a program than in the library.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;
using Mat34 = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>;

/// Points or vectors, one after the other in memory, so NumPy sees (n, 3) without a copy.
using Vec3Array = std::vector<Vec3>;

/// Three particle indices, counter-clockwise from outside.
using Triangle = std::array<int, 3>;

static_assert(sizeof(Vec3) == 3 * sizeof(double), "a Vec3Array must be contiguous (n, 3)");
static_assert(alignof(Vec3) == alignof(double) && alignof(Mat3) == alignof(double));
static_assert(sizeof(Quaternion) == 4 * sizeof(double) && alignof(Quaternion) == alignof(double));
static_assert(sizeof(Mat34) == 12 * sizeof(double) && alignof(Mat34) == alignof(double));

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
