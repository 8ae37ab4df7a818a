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

struct BodyDistances::Memories {
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
              const std::optional<RelativeMotion>& motion) {
    if (!pair.isOf(a, b)) {
      pair = Pair();
      pair.first_version = a.version;
      pair.second_version = b.version;
      pair.round = round;
    }
    pair.lease.reset();
    const BodyDistance found =
        placedDistance(*a.placed(), *b.placed(), goal, pair.memory, room, motion);
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
    for (auto pair = pairs.begin(); pair != pairs.end();) {
      const bool is_of_it = pair->first >> 32 == index || (pair->first & 0xffffffff) == index;
      pair = is_of_it ? pairs.erase(pair) : std::next(pair);
    }
  }

  DistanceGoal goal;
  std::vector<Slot> slots;
  std::unordered_map<std::uint64_t, Pair> pairs;  ///< by both indices
  std::uint64_t last_version = 0;
  std::uint64_t round = 0;  ///< a round ends with forgetUnused()
  SearchRoom room;
};

BodyDistances::BodyDistances(const DistanceGoal& goal) : memories_(std::make_unique<Memories>()) {
  memories_->goal = goal;
}
BodyDistances::BodyDistances(BodyDistances&&) noexcept = default;
BodyDistances& BodyDistances::operator=(BodyDistances&&) noexcept = default;
BodyDistances::~BodyDistances() = default;

void BodyDistances::set(std::size_t index, std::shared_ptr<const Body> body) {
  Memories& own = *memories_;
  Memories::Slot slot;  // everything that may throw comes before the first change
  slot.body = std::move(body);
  slot.with_cores = withCores(slot.body);
  if (slot.body) slot.ball = ballOf(*slot.with_cores);
  if (index >= own.slots.size()) own.slots.resize(index + 1);
  slot.version = ++own.last_version;
  own.slots[index] = std::move(slot);
  if (!own.slots[index].body) own.forget(index);
}

void BodyDistances::move(std::size_t index, const Eigen::Affine3d& world_from_body) {
  Memories& own = *memories_;
  if (index >= own.slots.size() || !own.slots[index].body) return;
  Memories::Slot& slot = own.slots[index];
  if (slot.pose && slot.pose->matrix() == world_from_body.matrix()) return;
  slot.pose = world_from_body;
  slot.pose_version = ++own.last_version;
  slot.is_placed = false;
  const bool had_cores = slot.usesCores();
  slot.rigid = slot.ball ? rigidBody(*slot.ball, world_from_body) : std::nullopt;
  const bool is_other_form = slot.with_cores != slot.body && slot.usesCores() != had_cores;
  if (is_other_form) slot.version = ++own.last_version;
}

void BodyDistances::setGoal(const DistanceGoal& goal) {
  memories_->goal = goal;
}

std::optional<BodyDistance> BodyDistances::find(std::size_t first, std::size_t second) {
  if (first > second) return swapped(find(second, first));
  Memories& own = *memories_;
  if (second >= own.slots.size()) return std::nullopt;
  const Memories::Slot& a = own.slots[first];
  const Memories::Slot& b = own.slots[second];
  if (!a.placed() || !b.placed()) return std::nullopt;
  if (const auto far = distanceBeyond(own.goal.limit, *a.placed(), *b.placed())) return far;
  const auto entry = own.pairs.try_emplace(own.keyOf(first, second)).first;
  Memories::Pair& pair = entry->second;
  if (!own.isLastOf(pair, a, b) || !own.reachesGoal(pair.last)) {
    const std::optional<PosePair> now = own.posesOf(a, b);
    own.search(pair, a, b, now, own.motionOf(pair, a, b, now));
  }
  pair.round = own.round;
  const BodyDistance result = pair.last;
  if (!pair.memory.is_known) own.pairs.erase(entry);
  return result;
}

std::optional<BodyDistance> BodyDistances::follow(std::size_t first, std::size_t second) {
  if (first > second) return swapped(follow(second, first));
  Memories& own = *memories_;
  if (second >= own.slots.size()) return std::nullopt;
  const Memories::Slot& a = own.slots[first];
  const Memories::Slot& b = own.slots[second];
  if (!a.pose || !b.pose) return std::nullopt;
  const auto known = own.pairs.find(own.keyOf(first, second));
  if (known == own.pairs.end() && !(a.placed() && b.placed())) return std::nullopt;
  Memories::Pair& pair =
      known != own.pairs.end() ? known->second : own.pairs[own.keyOf(first, second)];
  pair.round = own.round;
  if (own.isLastOf(pair, a, b) && own.reachesGoal(pair.last)) return pair.last;
  const std::optional<PosePair> now = own.posesOf(a, b);
  const std::optional<RelativeMotion> motion = own.motionOf(pair, a, b, now);
  if (motion) {
    own.show(pair, pair.lease->carried(*motion, *a.rigid, *b.rigid), a, b);
    if (own.reachesGoal(pair.last)) return pair.last;
  }
  if (!a.placed() || !b.placed()) return std::nullopt;
  own.search(pair, a, b, now, motion);
  return pair.last;
}

std::optional<BodyDistance> BodyDistances::findOnce(std::size_t first, std::size_t second,
                                                    double limit) const {
  if (first > second) return swapped(findOnce(second, first, limit));
  Memories& own = *memories_;
  if (second >= own.slots.size()) return std::nullopt;
  const Memories::Slot& a = own.slots[first];
  const Memories::Slot& b = own.slots[second];
  if (!a.placed() || !b.placed()) return std::nullopt;
  PairMemory memory;
  DistanceGoal goal_once = own.goal;
  goal_once.limit = limit;
  return placedDistance(*a.placed(), *b.placed(), goal_once, memory, own.room);
}

void BodyDistances::forgetUnused() {
  Memories& own = *memories_;
  for (auto pair = own.pairs.begin(); pair != own.pairs.end();)
    pair = pair->second.round == own.round ? std::next(pair) : own.pairs.erase(pair);
  ++own.round;
}

}  // namespace link_bounds
