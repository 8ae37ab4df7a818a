// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which subscriber gets which message, and what waits for one that does not read.
#include "node/outputs/topic/output.h"

#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include <cstdio>
#include <future>
#include <thread>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "testing/own_master.h"
#include "testing/patience.h"
#include "testing/process_census.h"
#include "testing/sanitized.h"
#include "testing/tcpros_reader.h"

namespace link_bounds {
namespace {

/// Its serialisation waits until the test lets it go on.
struct SlowMessage {
  inline static std::promise<void> begins;
  inline static std::promise<void> may_end;
};

}  // namespace
}  // namespace link_bounds

namespace ros {
namespace message_traits {
using link_bounds::SlowMessage;
template <>
struct MD5Sum<SlowMessage> : MD5Sum<std_msgs::String> {
  static const char* value(const SlowMessage&) { return MD5Sum<std_msgs::String>::value(); }
  using MD5Sum<std_msgs::String>::value;
};
template <>
struct DataType<SlowMessage> : DataType<std_msgs::String> {};
template <>
struct Definition<SlowMessage> : Definition<std_msgs::String> {};
}  // namespace message_traits
namespace serialization {
template <>
struct Serializer<link_bounds::SlowMessage> {
  static std::uint32_t serializedLength(const link_bounds::SlowMessage&) { return 4; }
  template <class Stream>
  static void write(Stream& stream, const link_bounds::SlowMessage&) {
    link_bounds::SlowMessage::begins.set_value();
    link_bounds::SlowMessage::may_end.get_future().wait();
    stream.next(std::uint32_t{0});
  }
};
}  // namespace serialization
}  // namespace ros

namespace link_bounds {
namespace {

using Message = AxisAlignedBoxArray;
using Reader = TcprosReader;

constexpr std::uint32_t kQueue = 200;
constexpr char kTopic[] = "/output_test/topic";
constexpr char kCaller[] = "/reader";
constexpr int kNothing = 200;  // ms in which nothing may come

Message message(std::uint32_t number, std::size_t bytes = 0) {
  Message result;
  result.header.stamp.sec = number;
  result.header.frame_id.resize(bytes);
  return result;
}

Message parsed(Reader::Bytes bytes) {
  Message result;
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, result);
  return result;
}

/// The number of the next message.
std::optional<std::uint32_t> next(Reader& reader, int patience = 20'000) {
  const auto bytes = reader.read(patience);
  return bytes ? std::optional(parsed(*bytes).header.stamp.sec) : std::nullopt;
}

/// Reads on until a message has this number; all numbers.
std::vector<std::uint32_t> numbersUntil(Reader& reader, std::uint32_t last) {
  std::vector<std::uint32_t> numbers;
  while (numbers.empty() || numbers.back() != last) {
    const auto number = next(reader);
    if (!number) break;
    numbers.push_back(*number);
  }
  return numbers;
}

/// A process can be a node only once.
class Node : public testing::Environment {
  void SetUp() override { master_ = std::make_unique<OwnMaster>("output_test"); }
  void TearDown() override { master_.reset(); }

  std::unique_ptr<OwnMaster> master_;
};

const testing::Environment* const kNode = testing::AddGlobalTestEnvironment(new Node);

class OutputTest : public testing::Test {
 protected:
  std::unique_ptr<Reader> reader() {
    return std::make_unique<Reader>(kTopic, kCaller, ros::spinOnce);
  }

  ros::NodeHandle node_;
};

class PlainOutputTest : public OutputTest {
 protected:
  /// Returns when the output knows of it.
  std::unique_ptr<Reader> connected() {
    const int before = subscribers_;
    auto result = reader();
    EXPECT_TRUE(isServed([&] { return subscribers_ > before; }));
    return result;
  }

  std::function<void(OutputTopic::Subscriber&)> greet_ = [](auto&) {};
  int subscribers_ = 0;
  Output<Message> output_{node_, kTopic, kQueue, [this](const OutputTopic::SubscriberPtr& one) {
                            ++subscribers_;
                            greet_(*one);
                          }};
};

TEST_F(PlainOutputTest, EverySubscriberGetsEachMessageWithTheNumbersOfRoscpp) {
  std::vector<std::uint32_t> here;
  const auto subscriber = node_.subscribe<Message>(
      kTopic, kQueue, [&](const auto& received) { here.push_back(received->header.seq); });
  ASSERT_TRUE(isServed([&] { return subscribers_ == 1; }));
  output_.publish(message(0));
  const auto first = connected();
  const auto second = connected();
  EXPECT_EQ(first->field("latching"), "0");
  for (std::uint32_t i = 1; i <= 3; ++i)
    output_.publish(message(i));
  for (Reader* one : {first.get(), second.get()}) {
    for (std::uint32_t i = 1; i <= 3; ++i) {
      const Message received = parsed(one->read().value());
      EXPECT_EQ(received.header.stamp.sec, i);
      EXPECT_EQ(received.header.seq, i);
    }
  }
  EXPECT_TRUE(isServed([&] { return here.size() == 4; }));
  EXPECT_EQ(here, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST_F(PlainOutputTest, AMessageWithoutHeaderIsSentAsItIs) {
  Output<std_msgs::String> texts(node_, "/output_test/texts", kQueue);
  Reader one("/output_test/texts", kCaller, ros::spinOnce);
  ASSERT_TRUE(isServed([&] { return texts.hasSubscribers(); }));
  std_msgs::String text;
  text.data = "as it is";
  texts.publish(text);
  const auto bytes = one.read().value();
  EXPECT_EQ(std::string(bytes.begin() + 4, bytes.end()), text.data);
}

TEST_F(PlainOutputTest, CountsWhatIsSentToNobody) {
  output_.publish(message(1));
  output_.publish(message(2));
  const auto one = connected();
  output_.publish(message(3));
  EXPECT_EQ(parsed(one->read().value()).header.seq, 2U);
}

TEST_F(PlainOutputTest, KnowsWhoIsThere) {
  EXPECT_FALSE(output_.hasSubscribers());
  auto first = connected();
  auto second = connected();
  EXPECT_TRUE(output_.hasSubscribers());
  first.reset();
  output_.publish(message(1));
  EXPECT_EQ(next(*second), 1U);
  second.reset();
  EXPECT_TRUE(isServed([&] { return !output_.hasSubscribers(); }));
  auto third = connected();
  output_.publish(message(2));
  EXPECT_EQ(next(*third), 2U);
  EXPECT_EQ(next(*third, kNothing), std::nullopt);
}

TEST_F(PlainOutputTest, AMessageOfItsOwnIsOlderThanTheFirstOfTheTopic) {
  greet_ = [&](OutputTopic::Subscriber& one) {
    output_.publish(message(9));
    output_.publishTo(one, message(7));
  };
  const auto first = connected();
  EXPECT_EQ(next(*first), 9U);
  EXPECT_EQ(next(*first, kNothing), std::nullopt) << "older than what it has got";
}

TEST_F(PlainOutputTest, ANewSubscriberAloneMayGetAMessageOfItsOwn) {
  const auto first = connected();
  greet_ = [&](OutputTopic::Subscriber& one) { output_.publishTo(one, message(7)); };
  const auto second = connected();
  output_.publish(message(8));
  EXPECT_EQ(numbersUntil(*first, 8), (std::vector<std::uint32_t>{8}));
  EXPECT_EQ(numbersUntil(*second, 8), (std::vector<std::uint32_t>{7, 8}));
  greet_ = [&](OutputTopic::Subscriber& one) {
    output_.publish(message(9));
    output_.publishTo(one, message(7));
  };
  const auto third = connected();
  EXPECT_EQ(next(*third), 9U);
  EXPECT_EQ(next(*third, kNothing), std::nullopt) << "older than what it has got";
}

TEST_F(PlainOutputTest, AStoppedSubscriberCostsBoundedMemoryAndGetsTheNewest) {
  constexpr std::size_t kSize = 1'000'000;
  constexpr std::uint32_t kCount = 150;  // fewer messages than the queue holds
  const auto stopped = connected();
  const auto other = connected();
  const long before = residentBytes();
  for (std::uint32_t i = 1; i <= kCount; ++i) {
    output_.publish(message(i, kSize));
    ASSERT_EQ(next(*other), i) << "others lose nothing";
  }
  const long growth = residentBytes() - before;
  std::printf("%.1f MB waited\n", static_cast<double>(growth) / 1e6);
  if (kIsSanitized) {
    std::printf("skipped: memory of a stopped subscriber, a sanitizer needs more\n");
  } else {
    EXPECT_LT(growth, 5 * static_cast<long>(OutputTopic::kMaxBytes));
  }
  const auto numbers = numbersUntil(*stopped, kCount);
  ASSERT_FALSE(numbers.empty());
  EXPECT_EQ(numbers.back(), kCount);
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
  EXPECT_LT(numbers.size(), 30U) << "what waits and what the kernel holds";
}

TEST_F(PlainOutputTest, TellsWhenASubscriberThatMissedMessagesReadsAgain) {
  const auto one = connected();
  const auto stopped = connected();
  for (std::uint32_t i = 1; i <= 40; ++i) {
    output_.publish(message(i, 1'000'000));
    ASSERT_EQ(next(*one), i);
  }
  EXPECT_FALSE(output_.takeLoss()) << "nobody has missed a message and reads";
  numbersUntil(*stopped, 40);
  EXPECT_TRUE(output_.takeLoss());
  EXPECT_FALSE(output_.takeLoss());
}

TEST_F(OutputTest, MessagesThatRoscppDropsAreMissed) {
  Output<Message> output(node_, kTopic, 3);
  const auto one = reader();
  ASSERT_TRUE(isServed([&] { return output.hasSubscribers(); }));
  std::uint32_t sent = 0;
  while (sent < 200)
    output.publish(message(++sent, 100'000));  // more than the kernel buffers
  ASSERT_TRUE(isServed([&] {
    output.publish(message(++sent, 100'000));
    return !output.takeLoss();
  })) << "it reads nothing";
  numbersUntil(*one, sent);
  EXPECT_TRUE(isServed([&] {
    output.publish(message(++sent));
    return output.takeLoss();
  }));
}

TEST_F(PlainOutputTest, ALargerMessageIsSentWhileNothingWaits) {
  constexpr std::size_t kSize = 2 * OutputTopic::kMaxBytes;
  const auto one = connected();
  for (std::uint32_t i = 1; i <= 4; ++i)
    output_.publish(message(i, kSize));
  EXPECT_EQ(next(*one), 1U);
  EXPECT_EQ(next(*one), 4U);
}

class LatchedOutputTest : public OutputTest {
 protected:
  static constexpr std::uint32_t kLongQueue = 100'000;  // longer than a busy machine stops a reader

  Output<Message> output_{node_, kTopic, kLongQueue, Output<Message>::Latched()};
};

TEST_F(LatchedOutputTest, NothingIsSentBeforeTheFirstMessage) {
  const auto one = reader();
  EXPECT_EQ(one->field("latching"), "1");
  ASSERT_TRUE(isServed([&] { return output_.hasSubscribers(); }));
  EXPECT_EQ(next(*one, kNothing), std::nullopt);
  output_.publish(message(1));
  EXPECT_EQ(next(*one), 1U);
}

TEST_F(LatchedOutputTest, EachNewSubscriberGetsTheLastMessageOnce) {
  output_.publish(message(1));
  output_.publish(message(2));
  auto one = reader();
  EXPECT_EQ(next(*one), 2U);
  EXPECT_EQ(next(*one, kNothing), std::nullopt);
  one.reset();
  ASSERT_TRUE(isServed([&] { return !output_.hasSubscribers(); }));
  one = reader();
  EXPECT_EQ(next(*one), 2U);
  std::vector<std::uint32_t> here;
  const auto subscriber = node_.subscribe<Message>(
      kTopic, kQueue, [&](const auto& received) { here.push_back(received->header.stamp.sec); });
  ASSERT_TRUE(isServed([&] { return !here.empty(); }));
  output_.publish(message(3));
  ASSERT_TRUE(isServed([&] { return here.size() > 1; }));
  EXPECT_EQ(here, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(next(*one), 3U);
}

TEST_F(LatchedOutputTest, WhoConnectsWhileMessagesAreSentMissesNoneFromThenOn) {
  std::atomic<bool> ends{false};
  std::atomic<std::uint32_t> sent{0};
  std::thread sender([&] {
    while (!ends) {
      output_.publish(message(sent + 1));
      ++sent;
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  });
  for (int i = 0; i < repetitions(100); ++i) {
    const auto one = reader();
    const auto from = next(*one).value_or(0);
    for (std::uint32_t k = 1; k <= 5; ++k)
      EXPECT_EQ(next(*one), from + k);
  }
  ends = true;
  sender.join();
  const auto one = reader();
  EXPECT_EQ(next(*one), sent.load());
}

TEST_F(PlainOutputTest, DoesNotWaitForAMessageOfAnotherTopic) {
  const auto one = connected();
  Output<SlowMessage> output(node_, "/output_test/slow", kQueue, Output<SlowMessage>::Latched());
  std::thread slow([&] { output.publish({}); });
  SlowMessage::begins.get_future().wait();
  auto sent = std::async(std::launch::async, [&] {
    output_.publish(message(1));
    return output_.hasSubscribers();
  });
  EXPECT_EQ(sent.wait_for(deadline()), std::future_status::ready);
  SlowMessage::may_end.set_value();
  slow.join();
  EXPECT_EQ(next(*one), 1U);
}

}  // namespace
}  // namespace link_bounds
