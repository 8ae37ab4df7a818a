// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Memory for histories: what one gives back the next one takes, so that full ones take nothing from
// the heap.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <new>

namespace link_bounds {

/// Keeps what is given back, if it has the size of a block; not for several threads.
class BlockStore : public std::pmr::memory_resource {
 public:
  /// That in which std::deque keeps its elements.
  static constexpr std::size_t kBlock = 512;

  BlockStore() = default;
  BlockStore(const BlockStore&) = delete;
  BlockStore& operator=(const BlockStore&) = delete;

  ~BlockStore() override {
    while (free_)
      heap_->deallocate(pop(), kBlock);
  }

 private:
  struct Block {
    Block* next;
  };

  void* pop() {
    Block* block = free_;
    free_ = block->next;
    return block;
  }

  static bool isBlock(std::size_t bytes, std::size_t alignment) {
    return bytes <= kBlock && bytes > kBlock / 2 && alignment <= alignof(std::max_align_t);
  }

  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    if (!isBlock(bytes, alignment)) return heap_->allocate(bytes, alignment);
    return free_ ? pop() : heap_->allocate(kBlock);
  }

  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
    if (!isBlock(bytes, alignment)) return heap_->deallocate(memory, bytes, alignment);
    free_ = new (memory) Block{free_};
  }

  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  std::pmr::memory_resource* heap_ = std::pmr::new_delete_resource();
  Block* free_ = nullptr;
};

}  // namespace link_bounds
