// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A TFMessage is a count, then per transform: seq, stamp, frame_id, child_frame_id, seven doubles.
#include "tf_traffic.h"

#include <cstring>

namespace link_bounds::bench {
namespace {

constexpr double kAnglePerMessage = 0.01;  // rad
const ros::Duration kPeriod(0.001);
constexpr std::size_t kWord = sizeof(std::uint32_t);
constexpr std::size_t kNumbers = 7 * sizeof(double);

Bytes bytesOf(const tf2_msgs::TFMessage& message) {
  Bytes bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

std::vector<std::size_t> stampOffsets(const tf2_msgs::TFMessage& message) {
  std::vector<std::size_t> offsets;
  std::size_t end = kWord;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    offsets.push_back(end + kWord);
    end +=
        5 * kWord + transform.header.frame_id.size() + transform.child_frame_id.size() + kNumbers;
  }
  return offsets;
}

}  // namespace

TfTraffic::TfTraffic(const TfRobot& robot, bool moves) : stamps_(kMessages) {
  for (std::size_t i = 0; i < kMessages; ++i) {
    const double angle = moves ? kAnglePerMessage * static_cast<double>(i) : 0;
    const tf2_msgs::TFMessage message = transformsOf(robot, angle, now_);
    bytes_.push_back(bytesOf(message));
    stamp_offsets_ = stampOffsets(message);
  }
}

void TfTraffic::prepare() {
  for (std::size_t i = 0; i < kMessages; ++i) {
    now_ += kPeriod;
    stamps_[i] = now_;
    for (const std::size_t offset : stamp_offsets_) {
      std::memcpy(&bytes_[i][offset], &now_.sec, kWord);
      std::memcpy(&bytes_[i][offset + kWord], &now_.nsec, kWord);
    }
  }
}

}  // namespace link_bounds::bench
