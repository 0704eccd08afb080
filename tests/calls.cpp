// SPDX-License-Identifier: BSD-3-Clause
#include "calls.h"

#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

// in the executable's own thread storage, so that counting never allocates
thread_local palpate::testing::Calls calls;

}  // namespace

palpate::testing::Calls palpate::testing::count_calls_of_this_thread() noexcept { return calls; }

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define CALLS_ARE_COUNTED 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CALLS_ARE_COUNTED 0
#endif
#endif
#ifndef CALLS_ARE_COUNTED
#define CALLS_ARE_COUNTED 1
#endif

bool palpate::testing::calls_are_counted() noexcept { return CALLS_ARE_COUNTED; }

#if CALLS_ARE_COUNTED

namespace {

/// The C library's function of this name, behind the one defined here.
template <class Function>
Function* find_real(const char* name, std::atomic<Function*>& known) noexcept {
  Function* real = known.load(std::memory_order_relaxed);
  if (!real) {
    real = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
    known.store(real, std::memory_order_relaxed);
  }
  return real;
}

}  // namespace

#define COUNT_LOCK(name, type)                                   \
  extern "C" int name(type* lock) noexcept {                     \
    static constinit std::atomic<int (*)(type*)> known{nullptr}; \
    ++calls.locks;                                               \
    return find_real(#name, known)(lock);                        \
  }

COUNT_LOCK(pthread_mutex_lock, pthread_mutex_t)
COUNT_LOCK(pthread_mutex_trylock, pthread_mutex_t)
COUNT_LOCK(pthread_rwlock_rdlock, pthread_rwlock_t)
COUNT_LOCK(pthread_rwlock_wrlock, pthread_rwlock_t)

extern "C" {

int pthread_spin_lock(pthread_spinlock_t* lock) noexcept {
  static constinit std::atomic<int (*)(pthread_spinlock_t*)> known{nullptr};
  ++calls.locks;
  return find_real("pthread_spin_lock", known)(lock);
}

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++calls.allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  ++calls.allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  ++calls.allocations;
  return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  ++calls.allocations;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++calls.allocations;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** out, std::size_t alignment, std::size_t size) noexcept {
  ++calls.allocations;
  *out = __libc_memalign(alignment, size);
  return *out ? 0 : ENOMEM;
}

}  // extern "C"

#endif
