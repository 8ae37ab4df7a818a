// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The bodies of one moment after another, which come, move, change and go.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "link_bounds/geometry/distance/body_distances.h"
#include "world/moment/moment.h"
#include "world/moment/triangle_trees.h"

namespace link_bounds {

class LiveBodies {
 public:
  explicit LiveBodies(TreeRequests requests) : trees_(std::move(requests)) {}

  /// Takes the bodies of a moment over.
  void update(const MomentPtr& moment, TriangleTrees::Time now);

  /// The distance of two bodies, given by their indices in the last moment.
  std::optional<BodyDistance> find(std::size_t first, std::size_t second) {
    return distances_.find(slots_of_bodies_[first], slots_of_bodies_[second]);
  }

  /// As find(), but carries along what was found before where that is good enough.
  std::optional<BodyDistance> follow(std::size_t first, std::size_t second) {
    return distances_.follow(slots_of_bodies_[first], slots_of_bodies_[second]);
  }

  /// The shapes of a body, given by its index in the last moment.
  const Body& body(std::size_t index) const { return *slots_[slots_of_bodies_[index]].body; }

  /// The same, which stays when the body is gone.
  const std::shared_ptr<const Body>& sharedBody(std::size_t index) const {
    return slots_[slots_of_bodies_[index]].body;
  }

  /// As find(), with another limit [m], and remembers nothing of the pair.
  std::optional<BodyDistance> findOnce(std::size_t first, std::size_t second, double limit) const {
    return distances_.findOnce(slots_of_bodies_[first], slots_of_bodies_[second], limit);
  }

  /// Forgets the pairs that were not searched since the last call.
  void forgetUnused() { distances_.forgetUnused(); }

  void setGoal(const DistanceGoal& goal) { distances_.setGoal(goal); }

  TriangleTrees& trees() { return trees_; }

 private:
  /// Where BodyDistances has a body.
  struct Slot {
    std::shared_ptr<const ObjectContent> object;  ///< null for links
    std::shared_ptr<const Body> body;
    std::optional<Eigen::Affine3d> pose;  ///< the last one
    bool lacks_trees = false;
    std::uint64_t seen = 0;  ///< number of the last moment that had the body
  };

  void adopt(const std::shared_ptr<const Model>& model);
  std::size_t slotOf(const Moment::Body& body);
  void set(std::size_t index, const Moment::Body& body, TriangleTrees::Time now);
  Body linkBody(const BoundedLink& link);
  Body objectBodyOf(const std::shared_ptr<const ObjectContent>& content, TriangleTrees::Time now);
  void removeUnseen();

  TriangleTrees trees_;
  std::uint64_t trees_version_ = 0;
  BodyDistances distances_;
  std::shared_ptr<const Model> model_;
  std::map<const PointSet*, const std::string*> mesh_uris_;  ///< of links
  std::vector<Slot> slots_;                                  ///< links first, then objects
  std::map<std::string, std::size_t> objects_;               ///< slots by name
  std::vector<std::size_t> free_slots_;
  std::vector<std::size_t> slots_of_bodies_;  ///< of the last moment
  std::uint64_t moment_ = 0;
};

}  // namespace link_bounds
