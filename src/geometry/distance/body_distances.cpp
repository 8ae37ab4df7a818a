// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Places a body once per pose, and only if a search needs it. Keeps a memory per pair, and a lease
// on its last result. Only search() renews them, so both are of the same poses. If it throws, the
// pair has no lease, and the next search trusts no bound of the memory. Both end when a body is
// replaced. A search at a pose that is not rigid ends the lease and the bounds of the memory.
#include "link_bounds/geometry/distance/body_distances.h"

#include <unordered_map>

#include "geometry/distance/capsules.h"
#include "geometry/distance/lease.h"
#include "geometry/distance/placed_distance.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr double kLargestBallDefect = 3e-14;  // the defect of poses of tf is below 1e-14

}  // namespace

class BodyDistances::Memories {
 public:
  explicit Memories(const DistanceGoal& its_goal) : goal(its_goal) {}

  void set(std::size_t index, std::shared_ptr<const Body> body) {
    Slot slot;  // everything that may throw comes before the first change
    slot.body = std::move(body);
    slot.with_cores = withCores(slot.body);
    if (slot.body) slot.ball = ballOf(*slot.with_cores);
    if (index >= slots_.size()) slots_.resize(index + 1);
    slot.version = ++last_version_;
    slots_[index] = std::move(slot);
    if (!slots_[index].body) forget(index);
  }

  void move(std::size_t index, const Eigen::Affine3d& world_from_body) {
    if (index >= slots_.size() || !slots_[index].body) return;
    Slot& slot = slots_[index];
    if (slot.pose && slot.pose->matrix() == world_from_body.matrix()) return;
    slot.pose = world_from_body;
    slot.pose_version = ++last_version_;
    slot.is_placed = false;
    const bool had_cores = slot.usesCores();
    slot.rigid = slot.ball ? rigidBody(*slot.ball, world_from_body) : std::nullopt;
    const bool is_other_form = slot.with_cores != slot.body && slot.usesCores() != had_cores;
    if (is_other_form) slot.version = ++last_version_;
  }

  std::optional<BodyDistance> find(std::size_t first, std::size_t second) {
    if (first > second) return swapped(find(second, first));
    if (second >= slots_.size()) return std::nullopt;
    const Slot& a = slots_[first];
    const Slot& b = slots_[second];
    if (!a.placed() || !b.placed()) return std::nullopt;
    if (const auto far = distanceBeyond(goal.limit, *a.placed(), *b.placed())) return far;
    const auto entry = pairs_.try_emplace(keyOf(first, second)).first;
    Pair& pair = entry->second;
    if (!isLastOf(pair, a, b) || !reachesGoal(pair.last)) {
      const std::optional<PosePair> now = posesOf(a, b);
      search(pair, a, b, now, motionOf(pair, a, b, now));
    }
    pair.round = round_;
    const BodyDistance result = pair.last;
    if (!pair.memory.is_known) pairs_.erase(entry);
    return result;
  }

  std::optional<BodyDistance> follow(std::size_t first, std::size_t second) {
    if (first > second) return swapped(follow(second, first));
    if (second >= slots_.size()) return std::nullopt;
    const Slot& a = slots_[first];
    const Slot& b = slots_[second];
    if (!a.pose || !b.pose) return std::nullopt;
    const auto known = pairs_.find(keyOf(first, second));
    if (known == pairs_.end() && !(a.placed() && b.placed())) return std::nullopt;
    Pair& pair = known != pairs_.end() ? known->second : pairs_[keyOf(first, second)];
    pair.round = round_;
    if (isLastOf(pair, a, b) && reachesGoal(pair.last)) return pair.last;
    const std::optional<PosePair> now = posesOf(a, b);
    const std::optional<RelativeMotion> motion = motionOf(pair, a, b, now);
    if (motion) {
      show(pair, pair.lease->carried(*motion, *a.rigid, *b.rigid), a, b);
      if (reachesGoal(pair.last)) return pair.last;
    }
    if (!a.placed() || !b.placed()) return std::nullopt;
    search(pair, a, b, now, motion);
    return pair.last;
  }

  std::optional<BodyDistance> findOnce(std::size_t first, std::size_t second, double limit) const {
    if (first > second) return swapped(findOnce(second, first, limit));
    if (second >= slots_.size()) return std::nullopt;
    const Slot& a = slots_[first];
    const Slot& b = slots_[second];
    if (!a.placed() || !b.placed()) return std::nullopt;
    PairMemory memory;
    DistanceGoal goal_once = goal;
    goal_once.limit = limit;
    return placedDistance(*a.placed(), *b.placed(), goal_once, memory, room_);
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
    std::shared_ptr<const Body> with_cores;  ///< see usesCores()
    std::optional<Ball> ball;
    std::optional<Eigen::Affine3d> pose;
    std::optional<RigidBody> rigid;  ///< at this pose
    std::uint64_t version = 0;       ///< unique to this body in this form
    std::uint64_t pose_version = 0;
    mutable std::optional<PlacedBody> its_placed;
    mutable bool is_placed = false;

    /// True if a ball is still a ball at this pose, so exactly that distances lose no accuracy.
    bool usesCores() const { return rigid && rigid->defect <= kLargestBallDefect; }

    /// Nothing without a usable pose.
    const std::optional<PlacedBody>& placed() const {
      if (pose && !is_placed) {
        its_placed = placedBody(usesCores() ? *with_cores : *body, *pose);
        if (its_placed) its_placed->rigid = rigid;
      }
      is_placed = pose.has_value();
      return its_placed;
    }
  };
  struct Pair {
    PairMemory memory;
    std::uint64_t first_version = 0;
    std::uint64_t second_version = 0;
    std::uint64_t round = 0;  ///< the last one in which the pair was asked for
    std::optional<Lease> lease;
    BodyDistance last{};           ///< the last result
    std::uint64_t first_pose = 0;  ///< version of the pose of the first body in `last`
    std::uint64_t second_pose = 0;

    bool isOf(const Slot& first, const Slot& second) const {
      return first_version == first.version && second_version == second.version;
    }
  };

  static_assert(sizeof(Pair) < 1000);  // as body_distances.h promises

  static std::uint64_t keyOf(std::size_t first, std::size_t second) {
    return std::uint64_t{first} << 32 | std::uint64_t{second};
  }

  static std::optional<PosePair> posesOf(const Slot& a, const Slot& b) {
    if (!a.rigid || !b.rigid) return std::nullopt;
    return PosePair(*a.rigid, *b.rigid);
  }

  /// How the bodies have moved since the lease of the pair began, if it has one.
  static std::optional<RelativeMotion> motionOf(const Pair& pair, const Slot& a, const Slot& b,
                                                const std::optional<PosePair>& now) {
    if (!pair.isOf(a, b) || !pair.lease || !now) return std::nullopt;
    return pair.lease->motion(*now, *a.rigid, *b.rigid);
  }

  /// Searches, and begins a lease on what is found if both poses are rigid. Forgets all of a pair
  /// with a body that was replaced. `motion` is motionOf() this pair.
  void search(Pair& pair, const Slot& a, const Slot& b, const std::optional<PosePair>& now,
              const std::optional<RelativeMotion>& motion) const {
    if (!pair.isOf(a, b)) {
      pair = Pair();
      pair.first_version = a.version;
      pair.second_version = b.version;
      pair.round = round_;
    }
    pair.lease.reset();
    const BodyDistance found =
        placedDistance(*a.placed(), *b.placed(), goal, pair.memory, room_, motion);
    if (now) pair.lease.emplace(found, *now, *a.rigid, *b.rigid);
    show(pair, found, a, b);
  }

  static void show(Pair& pair, const BodyDistance& distance, const Slot& a, const Slot& b) {
    pair.last = distance;
    pair.first_pose = a.pose_version;
    pair.second_pose = b.pose_version;
  }

  /// Whether `pair.last` is the result for the current poses.
  static bool isLastOf(const Pair& pair, const Slot& a, const Slot& b) {
    return pair.isOf(a, b) && pair.first_pose == a.pose_version &&
           pair.second_pose == b.pose_version;
  }

  bool reachesGoal(const BodyDistance& distance) const {
    return distance.lower > goal.limit ||
           distance.upper - distance.lower <= goal.tolerance(distance.upper);
  }

  void forget(std::size_t index) {
    for (auto pair = pairs_.begin(); pair != pairs_.end();) {
      const bool is_of_it = pair->first >> 32 == index || (pair->first & 0xffffffff) == index;
      pair = is_of_it ? pairs_.erase(pair) : std::next(pair);
    }
  }

  std::vector<Slot> slots_;
  std::unordered_map<std::uint64_t, Pair> pairs_;  ///< by both indices
  std::uint64_t last_version_ = 0;
  std::uint64_t round_ = 0;  ///< a round ends with forgetUnused()
  mutable SearchRoom room_;
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

std::optional<BodyDistance> BodyDistances::follow(std::size_t first, std::size_t second) {
  return memories_->follow(first, second);
}

std::optional<BodyDistance> BodyDistances::findOnce(std::size_t first, std::size_t second,
                                                    double limit) const {
  return memories_->findOnce(first, second, limit);
}

void BodyDistances::forgetUnused() {
  memories_->forgetUnused();
}

}  // namespace link_bounds
