// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The searches of many pairs, in turns, within bounded memory.
//
// A search is made when its turn comes. Each turn of a pair has twice as many slices of work as
// the one before, however long they take. Between two turns a search is kept where memory allows;
// otherwise it is stored and begins again with the next turn, which costs at most as much as all
// turns before.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <queue>
#include <vector>

#include "robot/pairs/pair_proofs.h"

namespace link_bounds {

/// Both are called by several threads, but for one pair one call after the other.
struct PairWork {
  /// Null if the pair cannot be searched.
  std::function<std::unique_ptr<PairSearch>(std::size_t pair)> begin;
  /// Stores what is known of a pair so far; a later call knows more.
  std::function<void(std::size_t pair, const PairSearch& search)> store;
};

class PairQueue {
 public:
  PairQueue(const std::vector<std::size_t>& pairs, PairWork work, const ProofControl& control);

  /// Works on all threads, until no task is left or the control says that it is over. Rethrows an
  /// exception of any thread.
  void run();

 private:
  struct Task {
    std::size_t pair = 0;
    std::unique_ptr<PairSearch> search = nullptr;
    std::size_t stored_slices = 0;  ///< slices that the stored search had done
    int turns = 0;
    bool is_decided = false;
  };
  /// True if `a` comes after `b`.
  struct IsLater {
    bool operator()(const Task* a, const Task* b) const;
  };

  void work();
  Task* take();
  void advance(Task& task) const;
  void giveBack(Task& task);
  void note(Task& task);
  void store(Task& task) const;

  PairWork work_;
  const ProofControl& control_;
  std::vector<Task> tasks_;
  std::mutex mutex_;
  std::priority_queue<Task*, std::vector<Task*>, IsLater> waiting_;
  std::size_t kept_bytes_ = 0;  ///< of the searches of `waiting_`
  std::size_t decided_ = 0;
};

}  // namespace link_bounds
