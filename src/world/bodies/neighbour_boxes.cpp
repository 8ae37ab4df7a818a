// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A box of a message becomes a solid box in the frame of the message's header.
#include "world/bodies/neighbour_boxes.h"

#include <utility>

#include "link_bounds/geometry/box/rounding.h"
#include "world/bodies/number_limit.h"
#include "world/model/model.h"
#include "world/model/object_key.h"
#include "world/tf/nanoseconds.h"
#include "world/tf/tf_message.h"

namespace link_bounds {
namespace {

/// Why the box cannot be used; "" if it can.
std::string whyRefused(const AxisAlignedBox& box, const std::string& frame) {
  if (frame.empty()) return "header.frame_id is empty; name the frame of the boxes";
  if (!isTime(box.stamp))
    return "its stamp is no time that tf can handle; correct the publisher's clock";
  if (!isBelowLimit(box.min) || !isBelowLimit(box.max))
    return "min or max has a number that is not finite or above 1e29; correct what computes it";
  if (box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z)
    return "min is greater than max; min is the corner of the smallest x, y and z";
  return "";
}

/// The result contains both corners although center and size are rounded.
Shape boxBetween(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  const Eigen::Vector3d center = (min + max) / 2;
  Eigen::Vector3d size = 2 * (max - center).cwiseMax(center - min);
  for (int k = 0; k < 3; ++k)
    if (size[k] > 0) size[k] = nextUp(size[k]);
  return {nullptr, Solid::kBox, size, Eigen::Affine3d(Eigen::Translation3d(center))};
}

/// Collects the boxes and incomplete names of one message.
class Collector {
 public:
  Collector(const std::string& sender, std::string frame) : sender_(sender) {
    result_.frame = std::move(frame);
  }

  void add(const AxisAlignedBox& box) {
    if (isNeighbourName(box.name)) return;
    ObjectContent& content = contentOf(box.name);
    has_boxes_ = true;
    are_static_ = are_static_ && box.stamp.isZero();
    const std::string reason = whyRefused(box, result_.frame);
    if (reason.empty()) {
      cover(box, content);
    } else {
      content.bounded.missing = result_.refused[box.name] = reason;
    }
  }

  void addIncomplete(const std::string& name) {
    if (isNeighbourName(name)) return;
    std::string& missing = contentOf(name).bounded.missing;
    if (missing.empty()) missing = "it is incomplete at " + sender_;
  }

  /// A name without a box is static if the message has boxes and all of them are static.
  NeighbourBoxes take() {
    for (auto& [name, content] : result_.contents)
      content.is_static =
          content.bounded.shapes.empty() ? has_boxes_ && are_static_ : content.stamp == 0;
    return std::move(result_);
  }

 private:
  struct Corners {
    Eigen::Vector3d min;
    Eigen::Vector3d max;
  };

  ObjectContent& contentOf(const std::string& box) {
    ObjectContent& content = result_.contents[box];
    content.publisher = sender_;
    content.is_neighbour = true;
    return content;
  }

  void cover(const AxisAlignedBox& box, ObjectContent& content) {
    const Eigen::Vector3d min(box.min.x, box.min.y, box.min.z);
    const Eigen::Vector3d max(box.max.x, box.max.y, box.max.z);
    const auto stamp = nanosecondsOf(box.stamp);
    const auto [entry, is_first] = corners_.try_emplace(&content, Corners{min, max});
    Corners& around = entry->second;
    around = {around.min.cwiseMin(min), around.max.cwiseMax(max)};
    content.bounded.shapes = {boxBetween(around.min, around.max)};
    content.frame = result_.frame;
    content.stamp = is_first ? stamp : olderStamp(content.stamp, stamp);
  }

  const std::string& sender_;
  NeighbourBoxes result_;
  bool has_boxes_ = false;  ///< true also for refused boxes
  bool are_static_ = true;
  std::map<const ObjectContent*, Corners> corners_;  ///< around all boxes of one name
};

}  // namespace

NeighbourBoxes neighbourBoxes(const AxisAlignedBoxArray& array, const std::string& sender) {
  Collector collector(sender, tfName("", array.header.frame_id));
  for (const AxisAlignedBox& box : array.boxes)
    collector.add(box);
  for (const std::string& name : array.incomplete)
    collector.addIncomplete(name);
  return collector.take();
}

std::set<std::string> linksOf(const NeighbourBoxes& boxes) {
  std::set<std::string> links;
  for (const auto& [name, content] : boxes.contents)
    if (!parseObjectName(name)) links.insert(name);
  return links;
}

}  // namespace link_bounds
