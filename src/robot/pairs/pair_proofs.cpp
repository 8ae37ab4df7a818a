// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The pair that has had least time is searched next, pairs without a verdict before others.
#include "robot/pairs/pair_proofs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>
#include <thread>
#include <tuple>

#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/urdf/simple_joints.h"

namespace link_bounds {
namespace {

struct Task {
  std::size_t first;
  std::size_t second;
  std::unique_ptr<PairSearch> search;
  bool is_decided = false;
  bool is_taken = false;  ///< a thread works on it
  double seconds = 0;     ///< spent on it
};

class TaskQueue {
 public:
  TaskQueue(std::vector<Task>& tasks, const ProofControl& control)
      : tasks_(tasks), control_(control) {
    for (Task& task : tasks_) {
      pending_.push_back(&task);
      update(task);
    }
  }

  /// What each thread does.
  void work() {
    while (Task* task = take()) {
      const auto start = std::chrono::steady_clock::now();
      task->search->advance();
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      giveBack(*task, spent.count());
    }
  }

 private:
  /// Null if there is nothing left that no other thread works on.
  Task* take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (control_.is_over()) return nullptr;
    const auto order = [](const Task* task) {
      return std::make_tuple(task->is_taken, task->is_decided, task->seconds);
    };
    const auto next =
        std::min_element(pending_.begin(), pending_.end(),
                         [&](const Task* a, const Task* b) { return order(a) < order(b); });
    if (next == pending_.end() || (*next)->is_taken) return nullptr;
    (*next)->is_taken = true;
    return *next;
  }

  void giveBack(Task& task, double seconds) {
    const std::lock_guard<std::mutex> lock(mutex_);
    task.is_taken = false;
    task.seconds += seconds;
    if (task.search->isDone()) pending_.erase(std::find(pending_.begin(), pending_.end(), &task));
    update(task);
  }

  void update(Task& task) {
    if (task.is_decided || !task.search->isDecided()) return;
    task.is_decided = true;
    ++decided_;
    if (control_.progress) control_.progress(decided_, tasks_.size());
  }

  std::vector<Task>& tasks_;
  const ProofControl& control_;
  std::mutex mutex_;
  std::vector<Task*> pending_;
  std::size_t decided_ = 0;
};

/// Waits for all threads; throws what one of them threw.
void workOn(std::vector<Task>& tasks, const ProofControl& control) {
  TaskQueue queue(tasks, control);
  const unsigned threads =
      control.threads > 0 ? control.threads : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::future<void>> workers;
  for (unsigned i = 0; i < threads; ++i)
    workers.push_back(std::async(std::launch::async, [&queue] { queue.work(); }));
  for (std::future<void>& worker : workers)
    worker.get();
}

Verdict verdictOf(const PairSearch& search, bool is_whole) {
  if (search.alwaysCollides()) return Verdict::kAlways;
  if (search.collides()) return Verdict::kSometimes;
  return search.isFree() && is_whole ? Verdict::kNever : Verdict::kUndecided;
}

PairProof proofOf(const Task& task, const Robot& robot, const BoundedRobot& bounded) {
  const PairSearch& search = *task.search;
  const bool is_whole = bounded.links[task.first].isWhole() && bounded.links[task.second].isWhole();
  PairProof proof;
  proof.first = task.first;
  proof.second = task.second;
  proof.verdict = verdictOf(search, is_whole);
  // Without a finite distance in any pose, nothing is known.
  proof.nearest = std::isfinite(search.nearest().upper) ? search.nearest().upper : 0;
  if (is_whole) proof.clearance = std::min(search.clearance(), proof.nearest);
  for (std::size_t i = 0; i < search.path().variables.size(); ++i) {
    const Joint& joint = robot.joints[search.path().variables[i]];
    proof.pose[joint.name] = search.nearest().values[i];
  }
  proof.has_free_pose = search.hasFreePose();
  if (!search.path().unknown.empty()) {
    proof.reason = missingRanges(robot, search.path().unknown);
    proof.pose.clear();
  }
  return proof;
}

}  // namespace

std::vector<PairProof> provePairs(const Robot& robot, const BoundedRobot& bounded,
                                  const std::vector<JointRange>& ranges, const PairGoal& goal,
                                  const ProofControl& control) {
  std::vector<PairBody> bodies;
  for (const Body& body : bounded.bodies)
    bodies.push_back(pairBody(body));
  const RigidBodies rigid = rigidBodies(robot);
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const std::size_t first = bounded.indices[i], second = bounded.indices[j];
      if (areJoined(rigid, first, second)) continue;
      if (bounded.bodies[i].shapes.empty() || bounded.bodies[j].shapes.empty()) continue;
      tasks.push_back({i, j,
                       std::make_unique<PairSearch>(jointPath(robot, ranges, first, second),
                                                    bodies[i], bodies[j], goal)});
    }
  }
  workOn(tasks, control);
  std::vector<PairProof> proofs;
  for (const Task& task : tasks)
    proofs.push_back(proofOf(task, robot, bounded));
  return proofs;
}

}  // namespace link_bounds
