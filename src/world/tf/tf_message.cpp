// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A TFMessage is a count, then per transform: seq, stamp, frame_id, child_frame_id, translation,
// rotation.
#include "world/tf/tf_message.h"

#include <boost/make_shared.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace link_bounds {
namespace {

using ros::serialization::IStream;

constexpr std::size_t kLarge = 1 << 20;  // bytes, about five thousand transforms

std::string_view stripped(std::string_view name) {
  if (!name.empty() && name.front() == '/') name.remove_prefix(1);
  return name;
}

std::string_view readName(IStream& stream) {
  std::uint32_t size = 0;
  stream.next(size);
  return stripped({reinterpret_cast<const char*>(stream.advance(size)), size});
}

/// QUATERNION_NORMALIZATION_TOLERANCE of tf2, for the squared length.
constexpr double kNormTolerance = 0.01;

/// tf2 adds its ten seconds of history to a stamp and throws if the seconds exceed 32 bits.
constexpr std::uint32_t kLastSecond = UINT32_MAX - 11;
constexpr std::uint32_t kLastNanosecond = 999999999;

/// A sum of squares is NaN only if one of them is.
bool hasNan(const Tf2Pose& pose) {
  return std::isnan(pose.rotation().length2() + pose.translation().length2());
}

bool isUnit(const tf2::Quaternion& q) {
  return std::abs(q.length2() - 1) < kNormTolerance;
}

}  // namespace

TransformView::TransformView(const geometry_msgs::TransformStamped& transform)
    : parent(stripped(transform.header.frame_id)),
      child(stripped(transform.child_frame_id)),
      stamp(transform.header.stamp) {
  const auto& q = transform.transform.rotation;
  const auto& t = transform.transform.translation;
  parent_from_child.numbers = {t.x, t.y, t.z, q.x, q.y, q.z, q.w};
}

/// The checks of tf2's setTransform, without its line of output per refused transform.
const char* whyRefused(const TransformView& transform) {
  if (transform.child.empty()) return "child_frame_id is empty; name the frame";
  if (transform.parent.empty()) return "header.frame_id is empty; name the parent frame";
  if (hasNan(transform.parent_from_child))
    return "it has a NaN (not a number); correct the publisher";
  if (!isUnit(transform.parent_from_child.rotation())) {
    return "the length of its quaternion is not 1; normalise it";
  }
  if (!isTime(transform.stamp))
    return "its stamp is no time that tf can handle; correct the publisher's clock";
  return nullptr;
}

bool isTime(const ros::Time& stamp) {
  return stamp.sec <= kLastSecond && stamp.nsec <= kLastNanosecond;
}

void TfMessage::read(const std::uint8_t* data, std::uint32_t size) {
  transforms.clear();
  if (is_skipped) return;
  bytes.assign(data, data + size);
  IStream stream(bytes.data(), size);
  std::uint32_t count = 0;
  for (stream.next(count); count > 0; --count) {
    std::uint32_t seq = 0;
    ros::Time stamp;
    stream.next(seq);
    stream.next(stamp);
    const auto* const begin = reinterpret_cast<const char*>(stream.getData());
    const std::string_view parent = readName(stream);
    const std::string_view child = readName(stream);
    const auto* const end = reinterpret_cast<const char*>(stream.getData());
    const std::string_view names(begin, static_cast<std::size_t>(end - begin));
    Tf2Pose& pose = transforms.emplace_back(parent, child, names, stamp).parent_from_child;
    std::memcpy(pose.numbers.data(), stream.advance(sizeof(pose.numbers)), sizeof(pose.numbers));
  }
}

boost::shared_ptr<TfMessage> TfMessageMemory::lend() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!message_ || !message_.unique()) message_ = boost::make_shared<TfMessage>();
  message_->is_skipped = skips_;
  return message_;
}

void TfMessageMemory::skip(bool skips) {
  const std::lock_guard<std::mutex> lock(mutex_);
  skips_ = skips;
}

void TfMessageMemory::giveBack() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (message_ && message_->capacity() > kLarge) message_.reset();
}

}  // namespace link_bounds
