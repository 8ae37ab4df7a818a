// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Places each body once per pose, and keeps one memory per pair.
#include "link_bounds/geometry/distance/body_distances.h"

#include <algorithm>
#include <map>

#include "geometry/distance/pair_search.h"

namespace link_bounds {

class BodyDistances::Memories {
 public:
  explicit Memories(const DistanceGoal& its_goal) : goal(its_goal) {}

  void set(std::size_t index, std::shared_ptr<const Body> body) {
    if (index >= slots_.size()) slots_.resize(index + 1);
    slots_[index] = {std::move(body), std::nullopt, ++last_version_};
  }

  void move(std::size_t index, const Eigen::Affine3d& world_from_body) {
    if (index >= slots_.size() || !slots_[index].body) return;
    slots_[index].placed = placedBody(*slots_[index].body, world_from_body);
  }

  std::optional<BodyDistance> find(std::size_t first, std::size_t second) {
    if (std::max(first, second) >= slots_.size()) return std::nullopt;
    const Slot& a = slots_[first];
    const Slot& b = slots_[second];
    if (!a.placed || !b.placed) return std::nullopt;
    const auto known = pairs_.find({first, second});
    PairMemory memory;
    if (known != pairs_.end() && known->second.isOf(a, b)) memory = known->second.memory;
    const BodyDistance result = placedDistance(*a.placed, *b.placed, goal, memory);
    if (memory.is_known) {
      pairs_[{first, second}] = {memory, a.version, b.version};
    } else if (known != pairs_.end()) {
      pairs_.erase(known);
    }
    return result;
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
    std::uint64_t first_version;
    std::uint64_t second_version;

    bool isOf(const Slot& first, const Slot& second) const {
      return first_version == first.version && second_version == second.version;
    }
  };

  std::vector<Slot> slots_;
  std::map<std::pair<std::size_t, std::size_t>, Pair> pairs_;
  std::uint64_t last_version_ = 0;
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

}  // namespace link_bounds
