// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whose objects are whose, where several topics have some.
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

/// Objects of two topics are different ones, as in rviz, and none replaces or deletes those of
/// another topic. But a scene tells them apart by name alone: of two that have the same name, the
/// later one is left out, which is a loss.
class ObjectTopics {
 public:
  using Markers = std::vector<visualization_msgs::Marker>;

  /// The objects must outlive this.
  explicit ObjectTopics(const LiveObjects& objects) : objects_(objects) {}

  /// Leaves of a message what is about objects of its topic alone. To be called before these are
  /// taken.
  void keepOwn(Markers& markers, const std::string& topic, const std::string& publisher);

  /// False if boxes of another node are not to be taken, because they would replace those of
  /// another topic.
  bool isOwn(const AxisAlignedBoxArray& boxes, const std::string& topic,
             const std::string& publisher);

  /// What was left out, in words; "" if nothing.
  std::string loss() const;

  /// Topics with messages that had drawings of nodes of link_bounds alone, which are ignored.
  const std::set<std::string>& ignored() const { return ignored_; }

 private:
  /// The boxes of one node.
  struct Sender {
    std::map<std::string, std::string> topics;  ///< by frame and link
  };

  void noteUse(const Markers& markers, const std::string& topic);
  const std::string& topicOf(const ObjectKey& key) const;
  void keepOwn(visualization_msgs::Marker& marker, const std::string& topic, Markers& own);
  void addDeletions(const std::string& topic, const std::string* publisher, Markers& own) const;
  void leaveOut(const std::string& name, const std::string& topic, const std::string& by);
  void forgetDeleted();

  const LiveObjects& objects_;
  std::string first_;                         ///< topic that had markers
  std::map<ObjectKey, std::string> further_;  ///< topics of objects that are not from that one
  std::map<std::string, Sender> senders_;
  std::set<std::string> used_;
  std::set<std::string> ignored_;
  std::uint64_t left_out_ = 0;
  std::string first_left_out_;
};

}  // namespace link_bounds
