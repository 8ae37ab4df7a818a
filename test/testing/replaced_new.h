// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Replaces operator new of a test program, to count requests or to let memory run out. To be
// included by one source of the program.
#pragma once

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace link_bounds::replaced_new {

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

inline std::atomic<std::size_t> limit{kNoLimit};  ///< bytes; a larger request throws std::bad_alloc
inline std::atomic<long*> counter{nullptr};       ///< unless null, is increased by each request

/// So many requests go well, then all throw std::bad_alloc; negative: all go well.
inline std::atomic<long> until_failure{-1};

inline void* allocate(std::size_t size) {
  if (long* const count = counter) ++*count;
  const bool fails = size > limit || until_failure == 0;
  if (until_failure > 0) --until_failure;
  void* const memory = fails ? nullptr : std::malloc(size);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace link_bounds::replaced_new

// Not inlined, or GCC takes new and delete for a mismatched pair.
__attribute__((noinline)) void* operator new(std::size_t size) {
  return link_bounds::replaced_new::allocate(size);
}

// std::stable_sort calls it. A sanitizer has one of its own.
__attribute__((noinline)) void* operator new(std::size_t size, const std::nothrow_t&) noexcept try {
  return link_bounds::replaced_new::allocate(size);
} catch (const std::bad_alloc&) {
  return nullptr;
}

__attribute__((noinline)) void operator delete(void* memory) noexcept {
  std::free(memory);
}

__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

// The tests ask for no more than malloc's alignment.
__attribute__((noinline)) void* operator new(std::size_t size, std::align_val_t) {
  return link_bounds::replaced_new::allocate(size);
}

__attribute__((noinline)) void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}

__attribute__((noinline)) void operator delete(void* memory, std::size_t,
                                               std::align_val_t) noexcept {
  std::free(memory);
}
