// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Stamps of single boxes are not compared: they say when an object was placed, not where.
#include "node/load/storm_answers.h"

#include <algorithm>
#include <map>
#include <utility>

namespace link_bounds {
namespace {

using Pair = std::pair<std::string, std::string>;

constexpr double kAccuracy = 1e-4;       // m, the default of distance_accuracy
constexpr double kDistanceLimit = 0.05;  // m, as storm_test.py sets it

template <class Message>
ros::Subscriber keepNewest(ros::NodeHandle& node, const std::string& topic,
                           boost::shared_ptr<const Message>& newest) {
  return node.subscribe<Message>(
      topic, 1, [&newest](const boost::shared_ptr<const Message>& message) { newest = message; });
}

bool areEqual(const AxisAlignedBox& a, const AxisAlignedBox& b) {
  return a.name == b.name && a.min == b.min && a.max == b.max;
}

std::map<Pair, Distance> byNames(const DistanceArray& array) {
  std::map<Pair, Distance> result;
  for (const Distance& pair : array.distances)
    result[{pair.first, pair.second}] = pair;
  return result;
}

/// Pairs of the first that the second lacks, or knows to be elsewhere. A pair at the limit may be
/// in one message only.
std::string difference(const DistanceArray& first, const DistanceArray& second) {
  const std::map<Pair, Distance> others = byNames(second);
  for (const Distance& a : first.distances) {
    const auto found = others.find({a.first, a.second});
    const std::string name = "the distance of " + a.first + " and " + a.second;
    if (found == others.end()) {
      if (a.distance_max < kDistanceLimit - kAccuracy) return name + " is missing";
    } else if (std::max(a.distance, found->second.distance) >
               std::min(a.distance_max, found->second.distance_max) + 1e-9) {
      return name + " is another one";
    }
  }
  return "";
}

}  // namespace

StormAnswers::StormAnswers(ros::NodeHandle& node, const std::string& publisher)
    : publisher_(publisher),
      boxes_subscriber_(keepNewest(node, publisher + "/boxes", boxes_)),
      overlaps_subscriber_(keepNewest(node, publisher + "/overlaps", overlaps_)),
      distances_subscriber_(keepNewest(node, publisher + "/distances", distances_)) {}

bool StormAnswers::areOf(ros::Time stamp) const {
  return boxes_ && overlaps_ && distances_ && boxes_->header.stamp == stamp &&
         overlaps_->header.stamp == stamp && distances_->header.stamp == stamp &&
         boxes_->incomplete.empty();
}

std::string StormAnswers::differenceTo(const StormAnswers& other) const {
  if (boxes_->boxes.size() != other.boxes_->boxes.size()) return "other numbers of boxes";
  for (std::size_t i = 0; i < boxes_->boxes.size(); ++i) {
    if (!areEqual(boxes_->boxes[i], other.boxes_->boxes[i]))
      return "the box of " + boxes_->boxes[i].name;
  }
  if (overlaps_->overlaps != other.overlaps_->overlaps) return "overlaps";
  const std::string missing = difference(*distances_, *other.distances_);
  return missing.empty() ? difference(*other.distances_, *distances_) : missing;
}

std::string StormAnswers::counts() const {
  const auto count = [](const auto& message, auto member) {
    return message ? std::to_string(((*message).*member).size()) : "no";
  };
  return publisher_ + ": " + count(boxes_, &AxisAlignedBoxArray::boxes) + " boxes, " +
         count(boxes_, &AxisAlignedBoxArray::incomplete) + " incomplete, " +
         count(overlaps_, &BoxOverlapArray::overlaps) + " overlaps, " +
         count(distances_, &DistanceArray::distances) + " distances";
}

}  // namespace link_bounds
