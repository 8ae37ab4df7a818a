// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A TFMessage is a count, then per transform: seq, stamp, frame_id, child_frame_id, seven doubles.
#include "bench/pipeline/tf_traffic.h"

#include <cstring>

#include "testing/message_bytes.h"

namespace link_bounds::bench {
namespace {

const ros::Duration kBetweenMessages(0.001);
constexpr std::size_t kWord = sizeof(std::uint32_t);
constexpr std::size_t kNumbers = 7 * sizeof(double);

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
  const std::vector<tf2_msgs::TFMessage> messages = swing(robot, kMessages);
  for (std::size_t i = 0; i < kMessages; ++i)
    bytes_.push_back(messageBytes(messages[moves ? i : 0]));
  stamp_offsets_ = stampOffsets(messages.front());
}

void TfTraffic::prepare() {
  for (std::size_t i = 0; i < kMessages; ++i) {
    now_ += kBetweenMessages;
    stamps_[i] = now_;
    for (const std::size_t offset : stamp_offsets_) {
      std::memcpy(&bytes_[i][offset], &now_.sec, kWord);
      std::memcpy(&bytes_[i][offset + kWord], &now_.nsec, kWord);
    }
  }
}

}  // namespace link_bounds::bench
