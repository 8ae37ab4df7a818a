// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Good messages are read as by roscpp; others take no more memory than their own bytes deserve.
#include <gtest/gtest.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/GetBoxes.h"
#include "node/inputs/incomplete_messages.h"
#include "testing/message_bytes.h"
#include "testing/replaced_new.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;
using Bytes = std::vector<std::uint8_t>;

/// An empty text of 4 bytes becomes a string of 32.
constexpr std::size_t kMaxGrowth = 8;

/// As roscpp does.
template <class Message>
Received<Message> received(Bytes bytes) {
  Received<Message> message;
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, message);
  return message;
}

Marker marker(const std::string& name) {
  Marker result;
  result.header.frame_id = name;
  result.ns = "ns of " + name;
  result.points.resize(3);
  result.points[1].y = 1.5;
  result.colors.resize(2);
  result.colors[0].g = 0.5F;
  result.text = "text";
  result.mesh_resource = "package://a/b.stl";
  return result;
}

MarkerArray markers() {
  MarkerArray result;
  result.markers = {marker("a"), Marker(), marker("b")};
  return result;
}

AxisAlignedBoxArray boxes() {
  AxisAlignedBoxArray result;
  result.header.frame_id = "base";
  result.boxes.resize(2);
  result.boxes[1].name = "arm";
  result.incomplete = {"", "hand"};
  return result;
}

GetBoxes::Request request() {
  GetBoxes::Request result;
  result.frame = "base";
  result.names = {"arm", "", "hand"};
  return result;
}

/// Calls use(message) for one message of each type.
template <class Use>
void forEachType(Use&& use) {
  use(markers());
  use(marker("a"));
  use(boxes());
  use(request());
}

/// Reads bytes while no list may take more memory than they deserve.
template <class Message>
bool isReadWithinBounds(const Bytes& bytes) {
  replaced_new::limit = bytes.size() * kMaxGrowth + 64;  // and texts in words
  bool is_complete = false;
  EXPECT_NO_THROW(is_complete = received<Message>(bytes).is_complete) << "of " << bytes.size();
  replaced_new::limit = replaced_new::kNoLimit;
  return is_complete;
}

template <class Message>
bool isReadByRoscpp(Bytes bytes) {
  replaced_new::limit = std::size_t{1} << 20;
  bool result = true;
  try {
    Message message;
    ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    ros::serialization::deserialize(stream, message);
  } catch (const std::exception&) {
    result = false;
  }
  replaced_new::limit = replaced_new::kNoLimit;
  return result;
}

TEST(Received, IsReadAsRoscppReadsIt) {
  forEachType([](const auto& sent) {
    using Message = std::decay_t<decltype(sent)>;
    const Received<Message> message = received<Message>(messageBytes(sent));
    EXPECT_TRUE(message.is_complete);
    EXPECT_EQ(messageBytes<Message>(message), messageBytes(sent));
  });
}

TEST(Received, ItsTypeIsThatOfTheMessage) {
  namespace traits = ros::message_traits;
  forEachType([](const auto& sent) {
    using Message = std::decay_t<decltype(sent)>;
    EXPECT_STREQ(traits::md5sum<Received<Message>>(), traits::md5sum<Message>());
    EXPECT_STREQ(traits::datatype<Received<Message>>(), traits::datatype<Message>());
    EXPECT_EQ(traits::hasHeader<Received<Message>>(), traits::hasHeader<Message>());
  });
}

TEST(Received, CutOffAnywhereIsIncompleteAndEmpty) {
  forEachType([](const auto& sent) {
    using Message = std::decay_t<decltype(sent)>;
    for (Bytes bytes = messageBytes(sent); !bytes.empty();) {
      bytes.pop_back();
      const Received<Message> message = received<Message>(bytes);
      ASSERT_FALSE(message.is_complete) << bytes.size();
      EXPECT_EQ(messageBytes<Message>(message), messageBytes(Message()));
    }
  });
}

/// Each four bytes of a message, whatever they mean, become huge.
TEST(Received, LyingLengthsTakeNoMemory) {
  for (const std::uint8_t high : Bytes{0x01, 0x7f, 0xff}) {
    forEachType([high](const auto& sent) {
      using Message = std::decay_t<decltype(sent)>;
      const Bytes good = messageBytes(sent);
      int refused = 0;
      for (std::size_t i = 0; i + 4 <= good.size(); ++i) {
        Bytes bytes = good;
        std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(i), 4, high);
        refused += !isReadWithinBounds<Message>(bytes);
      }
      EXPECT_GT(refused, 3);
    });
  }
}

TEST(Received, FiftyMillionNamesIn24BytesAreRefused) {
  Bytes bytes(24);
  const std::uint32_t count = 50'000'000;
  std::memcpy(&bytes[20], &count, sizeof count);  // behind stamp, span and an empty frame
  EXPECT_FALSE(isReadWithinBounds<GetBoxes::Request>(bytes));
}

TEST(Received, ManyEmptyElementsAreRead) {
  GetBoxes::Request names;
  names.names.resize(10000);
  EXPECT_TRUE(isReadWithinBounds<GetBoxes::Request>(messageBytes(names)));
  MarkerArray array;
  array.markers.resize(1000);
  EXPECT_TRUE(isReadWithinBounds<MarkerArray>(messageBytes(array)));
  AxisAlignedBoxArray boxes;
  boxes.boxes.resize(1000);
  boxes.incomplete.resize(10000);
  EXPECT_TRUE(isReadWithinBounds<AxisAlignedBoxArray>(messageBytes(boxes)));
}

/// Random bytes, and good messages with some of them changed.
TEST(Received, RandomBytesTakeNoMemory) {
  std::mt19937 random(1);
  const auto below = [&random](std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
  };
  const auto random_byte = [&] { return static_cast<std::uint8_t>(below(256) >> below(9)); };
  int counts[2] = {};
  for (int round = 0; round < repetitions(20000); ++round) {
    forEachType([&](const auto& sent) {
      using Message = std::decay_t<decltype(sent)>;
      Bytes bytes = round % 2 == 0 ? messageBytes(sent) : Bytes(below(400));
      for (std::size_t i = round % 2 == 0 ? below(4) : bytes.size(); i > 0; --i)
        bytes[below(bytes.size())] = random_byte();
      const bool is_complete = isReadWithinBounds<Message>(bytes);
      EXPECT_EQ(is_complete, isReadByRoscpp<Message>(bytes));
      ++counts[is_complete ? 1 : 0];
    });
  }
  EXPECT_GT(counts[0], repetitions(10000));
  EXPECT_GT(counts[1], repetitions(10000));
}

}  // namespace
}  // namespace link_bounds
