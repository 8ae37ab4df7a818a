// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Keeps the objects of several topics apart.
#pragma once

#include <link_bounds/AxisAlignedBoxArray.h>
#include <visualization_msgs/Marker.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "world/bodies/live_objects.h"

namespace link_bounds {

/// Objects of two topics are different ones, as in rviz: no topic replaces or deletes objects of
/// another one. But a scene tells objects apart by name alone. If two topics have an object of the
/// same name, the later one is left out, which is a loss.
class ObjectTopics {
 public:
  using Markers = std::vector<visualization_msgs::Marker>;

  /// The objects must outlive this.
  explicit ObjectTopics(const LiveObjects& objects) : objects_(objects) {}

  /// Removes the markers that are not about objects of this topic. Call it before the scene takes
  /// them.
  void keepOwn(Markers& markers, const std::string& topic, const std::string& publisher);

  /// Whether the scene may take boxes of another node; false if they would replace those of another
  /// topic.
  bool isOwn(const AxisAlignedBoxArray& boxes, const std::string& topic,
             const std::string& publisher);

  /// A message about objects that were left out; "" if there are none.
  std::string loss() const;

  /// Topics that had only markers drawn by nodes of link_bounds, which are ignored.
  const std::set<std::string>& ignored() const { return ignored_; }

 private:
  /// The boxes of one node.
  struct Sender {
    std::map<std::string, std::string> topics;  ///< of its boxes, by frame and link
  };

  void noteUse(const Markers& markers, const std::string& topic);
  const std::string& topicOf(const ObjectKey& key) const;
  void keepOwn(visualization_msgs::Marker& marker, const std::string& topic, Markers& own);
  void addDeletions(const std::string& topic, const std::string* publisher, Markers& own) const;
  void leaveOut(const std::string& name, const std::string& topic, const std::string& by);
  void forgetDeleted();

  const LiveObjects& objects_;
  std::string first_;                         ///< first topic that had markers
  std::map<ObjectKey, std::string> further_;  ///< topics of objects from other topics
  std::map<std::string, Sender> senders_;
  std::set<std::string> used_;
  std::set<std::string> ignored_;
  std::uint64_t left_out_ = 0;
  std::string first_left_out_;
};

}  // namespace link_bounds
