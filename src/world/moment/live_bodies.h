// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Tracks the bodies of successive moments, which appear, move, change and disappear.
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

  /// Takes over the bodies of a moment.
  void update(const MomentPtr& moment, TriangleTrees::Time now);

  /// The distance of two bodies, given by their indices in the last moment.
  std::optional<BodyDistance> find(std::size_t first, std::size_t second) {
    return distances_.find(slots_of_bodies_[first], slots_of_bodies_[second]);
  }

  /// As find(), but reuses the previous result for the pair if it is still accurate enough.
  std::optional<BodyDistance> follow(std::size_t first, std::size_t second) {
    return distances_.follow(slots_of_bodies_[first], slots_of_bodies_[second]);
  }

  /// The shapes of a body, given by its index in the last moment.
  const Body& body(std::size_t index) const { return *slots_[slots_of_bodies_[index]].body; }

  /// As body(), but the shapes outlive the body.
  const std::shared_ptr<const Body>& sharedBody(std::size_t index) const {
    return slots_[slots_of_bodies_[index]].body;
  }

  /// As find(), with another limit [m], and caches nothing about the pair.
  std::optional<BodyDistance> findOnce(std::size_t first, std::size_t second, double limit) const {
    return distances_.findOnce(slots_of_bodies_[first], slots_of_bodies_[second], limit);
  }

  /// Forgets the pairs that were not searched since the last call.
  void forgetUnused() { distances_.forgetUnused(); }

  void setGoal(const DistanceGoal& goal) { distances_.setGoal(goal); }

  TriangleTrees& trees() { return trees_; }

 private:
  /// The entry of a body in BodyDistances; both have the same index.
  struct Slot {
    std::shared_ptr<const ObjectContent> object;  ///< null for links
    std::shared_ptr<const Body> body;
    std::optional<Eigen::Affine3d> pose;  ///< the latest one
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
  std::map<const PointSet*, const std::string*>
      mesh_uris_;                               ///< URIs of the links' meshes, by points
  std::vector<Slot> slots_;                     ///< links first, then objects
  std::map<std::string, std::size_t> objects_;  ///< slots by name
  std::vector<std::size_t> free_slots_;
  std::vector<std::size_t> slots_of_bodies_;  ///< one per body of the last moment
  std::uint64_t moment_ = 0;
};

}  // namespace link_bounds
