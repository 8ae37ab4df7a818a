// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Feeds the histories and the frame tree side by side.
#include "node/tf/transform_source.h"

#include <algorithm>
#include <limits>

#include "node/tf/transform_refusal.h"

namespace link_bounds {
namespace {

constexpr std::int64_t kSilence = 1000000000;  // ns without a transform that is worth a warning
constexpr const char* kOwnParent = "the frame is its own parent; correct one of the names";
constexpr const char* kTooOld =
    "its stamp is more than 10 s older than the newest one of the frame; synchronise the clocks, "
    "and if that newest one is wrong, call ~reload";

std::int64_t nanoseconds(ros::Time time) {
  return static_cast<std::int64_t>(time.toNSec());
}

}  // namespace

std::vector<Refusal> TransformSource::add(const std::vector<TransformView>& transforms,
                                          bool is_static, ros::Time now) {
  std::vector<Refusal> refusals;
  tree_.beginMessage();
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const char* reason = whyRefused(transforms[i]);
    if (reason) ++intake_.unusable;
    if (!reason) reason = insert(transforms[i], is_static, nanoseconds(now));
    if (reason) refusals.push_back({i, reason});
  }
  return refusals;
}

/// Returns why it was refused, if that is worth telling.
const char* TransformSource::insert(const TransformView& transform, bool is_static,
                                    std::int64_t now) {
  const auto [child, parent] = tree_.next(transform.parent, transform.child, transform.names);
  if (child == parent) {
    ++intake_.unusable;
    return kOwnParent;
  }
  const std::int64_t stamp = nanoseconds(transform.stamp);
  const Tf2Pose& pose = transform.parent_from_child;
  if (!histories_.insert(child, parent, stamp, pose, is_static)) {
    if (!tree_.isDistrusted(child) || !isTooOld(child, stamp)) return refuse(child, stamp, now);
    tree_.forget(child);
    histories_.clear(child);
    histories_.insert(child, parent, stamp, pose, is_static);
  }
  ++intake_.taken;
  if (stamp < tree_.newest(child)) ++intake_.late;
  tree_.heard(child, parent, is_static, stamp, now);
  return nullptr;
}

/// Else its stamp is there already.
bool TransformSource::isTooOld(Frame child, std::int64_t stamp) const {
  return stamp + EdgeHistory::kLength < tree_.newest(child);
}

const char* TransformSource::refuse(Frame child, std::int64_t stamp, std::int64_t now) {
  if (!isTooOld(child, stamp)) {
    ++intake_.repeated;
    return nullptr;
  }
  ++intake_.too_old;
  return now - tree_.lastHeard(child) > kSilence ? kTooOld : nullptr;
}

/// tf2's rule: the least of the newest stamps that are not 0. A frame in itself has the stamp of
/// its own edge.
std::int64_t TransformSource::latestCommonTime(Frame source, const std::vector<Frame>& path) const {
  if (path.empty()) return tree_.newest(source);
  std::int64_t common = std::numeric_limits<std::int64_t>::max();
  for (const Frame edge : path) {
    if (tree_.newest(edge) != 0) common = std::min(common, tree_.newest(edge));
  }
  return common == std::numeric_limits<std::int64_t>::max() ? 0 : common;
}

bool TransformSource::wasPath(const std::vector<Frame>& path, std::int64_t stamp) const {
  if (stamp != 0 && stamp < tree_.settled()) return false;
  EdgeSample scratch;
  return std::all_of(path.begin(), path.end(),
                     [&](Frame edge) { return histories_.at(edge, stamp, scratch); });
}

std::optional<StampedPose> TransformSource::latest(Frame target, Frame source,
                                                   const std::vector<Frame>& path) const {
  const std::int64_t stamp = latestCommonTime(source, path);
  const std::optional<Eigen::Isometry3d> pose = at(target, source, stamp);
  if (!pose) return std::nullopt;
  return StampedPose{*pose, stamp};
}

std::optional<Eigen::Isometry3d> TransformSource::at(Frame target, Frame source,
                                                     std::int64_t stamp) const {
  const std::optional<Tf2Pose> pose = histories_.pose(target, source, stamp);
  if (!pose) return std::nullopt;
  return Eigen::Isometry3d(MatrixPose(*pose).affine.matrix());
}

void TransformSource::clear() {
  histories_.clear();
  tree_.forgetDynamic();
}

void TransformSource::distrustStampsAhead(ros::Time now) {
  tree_.distrustStampsAfter(nanoseconds(now) + EdgeHistory::kLength);
}

}  // namespace link_bounds
