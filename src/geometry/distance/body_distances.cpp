// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Places each body once per pose, and keeps one memory per pair.
#include "link_bounds/geometry/distance/body_distances.h"

#include <algorithm>
#include <map>

#include "geometry/distance/placed_distance.h"

namespace link_bounds {

class BodyDistances::Memories {
 public:
  explicit Memories(const DistanceGoal& its_goal) : goal(its_goal) {}

  void set(std::size_t index, std::shared_ptr<const Body> body) {
    if (index >= slots_.size()) slots_.resize(index + 1);
    slots_[index] = {std::move(body), std::nullopt, ++last_version_};
    if (!slots_[index].body) forget(index);
  }

  void move(std::size_t index, const Eigen::Affine3d& world_from_body) {
    if (index >= slots_.size() || !slots_[index].body) return;
    slots_[index].placed = placedBody(*slots_[index].body, world_from_body);
  }

  std::optional<BodyDistance> find(std::size_t first, std::size_t second) {
    if (first > second) return swapped(find(second, first));
    if (second >= slots_.size()) return std::nullopt;
    const Slot& a = slots_[first];
    const Slot& b = slots_[second];
    if (!a.placed || !b.placed) return std::nullopt;
    if (const auto far = distanceBeyond(goal.limit, *a.placed, *b.placed)) return far;
    const auto entry = pairs_.try_emplace({first, second}).first;
    Pair& pair = entry->second;
    if (!pair.isOf(a, b)) pair = {PairMemory(), a.version, b.version};
    pair.round = round_;
    const BodyDistance result = placedDistance(*a.placed, *b.placed, goal, pair.memory);
    if (!pair.memory.is_known) pairs_.erase(entry);
    return result;
  }

  std::optional<BodyDistance> findOnce(std::size_t first, std::size_t second, double limit) const {
    if (first > second) return swapped(findOnce(second, first, limit));
    if (second >= slots_.size()) return std::nullopt;
    const Slot& a = slots_[first];
    const Slot& b = slots_[second];
    if (!a.placed || !b.placed) return std::nullopt;
    if (const auto far = distanceBeyond(limit, *a.placed, *b.placed)) return far;
    PairMemory memory;
    return placedDistance(*a.placed, *b.placed, {goal.accuracy, limit, goal.max_steps}, memory);
  }

  void forgetUnused() {
    for (auto pair = pairs_.begin(); pair != pairs_.end();)
      pair = pair->second.round == round_ ? std::next(pair) : pairs_.erase(pair);
    ++round_;
  }

  DistanceGoal goal;

 private:
  struct Slot {
    std::shared_ptr<const Body> body;
    std::optional<PlacedBody> placed;
    std::uint64_t version = 0;  ///< of the body; no other body ever has it
  };
  struct Pair {
    PairMemory memory;
    std::uint64_t first_version = 0;
    std::uint64_t second_version = 0;
    std::uint64_t round = 0;  ///< in which it was searched

    bool isOf(const Slot& first, const Slot& second) const {
      return first_version == first.version && second_version == second.version;
    }
  };

  void forget(std::size_t index) {
    for (auto pair = pairs_.begin(); pair != pairs_.end();) {
      const bool is_of_it = pair->first.first == index || pair->first.second == index;
      pair = is_of_it ? pairs_.erase(pair) : std::next(pair);
    }
  }

  std::vector<Slot> slots_;
  std::map<std::pair<std::size_t, std::size_t>, Pair> pairs_;
  std::uint64_t last_version_ = 0;
  std::uint64_t round_ = 0;  ///< ends with forgetUnused()
};

BodyDistances::BodyDistances(const DistanceGoal& goal)
    : memories_(std::make_unique<Memories>(goal)) {}
BodyDistances::BodyDistances(BodyDistances&&) noexcept = default;
BodyDistances& BodyDistances::operator=(BodyDistances&&) noexcept = default;
BodyDistances::~BodyDistances() = default;

void BodyDistances::set(std::size_t index, std::shared_ptr<const Body> body) {
  memories_->set(index, std::move(body));
}

void BodyDistances::move(std::size_t index, const Eigen::Affine3d& world_from_body) {
  memories_->move(index, world_from_body);
}

void BodyDistances::setGoal(const DistanceGoal& goal) {
  memories_->goal = goal;
}

std::optional<BodyDistance> BodyDistances::find(std::size_t first, std::size_t second) {
  return memories_->find(first, second);
}

std::optional<BodyDistance> BodyDistances::findOnce(std::size_t first, std::size_t second,
                                                    double limit) const {
  return memories_->findOnce(first, second, limit);
}

void BodyDistances::forgetUnused() {
  memories_->forgetUnused();
}

}  // namespace link_bounds
