// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes a bag of a robot whose joints all swing, at 100 Hz: BAG LINKS SECONDS
#include "bench/common/processes.h"
#include "bench/common/tf_robot.h"
#include "testing/bag_testing.h"

namespace link_bounds::bench {
namespace {

constexpr std::int64_t kPeriod = 10000000;            // ns
constexpr std::int64_t kBegin = 1700000000000000000;  // ns
constexpr std::size_t kDepth = 10;
constexpr std::size_t kBagPoses = 1000;

void writeTf(const TfRobot& robot, const std::string& file, std::int64_t seconds) {
  std::vector<tf2_msgs::TFMessage> messages = swing(robot, kBagPoses);
  BagWriter writer(file);
  const std::uint32_t topic =
      writer.addTopic({"/tf", ros::message_traits::datatype<tf2_msgs::TFMessage>(),
                       ros::message_traits::md5sum<tf2_msgs::TFMessage>(),
                       ros::message_traits::definition<tf2_msgs::TFMessage>(), "/bench", false});
  for (std::int64_t i = 0; i < seconds * 1000000000 / kPeriod; ++i) {
    const std::int64_t time = kBegin + i * kPeriod;
    tf2_msgs::TFMessage& message = messages[static_cast<std::size_t>(i) % kBagPoses];
    for (geometry_msgs::TransformStamped& transform : message.transforms)
      transform.header.stamp.fromNSec(static_cast<std::uint64_t>(time));
    const std::string data = recorded("/tf", time, message).data;
    writer.write(topic, time, reinterpret_cast<const std::uint8_t*>(data.data()),
                 static_cast<std::uint32_t>(data.size()));
  }
  writer.close();
}

}  // namespace

void makeBag(const Words& words) {
  writeTf(tfRobot(std::stoul(words[1]), kDepth), words[0], std::stol(words[2]));
}

}  // namespace link_bounds::bench
