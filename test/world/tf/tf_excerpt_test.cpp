// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses in an excerpt have the bits of those in the buffer that it was copied from.
#include "world/tf/tf_excerpt.h"

#include <iostream>

#include "testing/beside_tf2.h"
#include "testing/sanitized.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {
namespace {

using Frame = TransformBuffer::Frame;

constexpr std::int64_t kSecond = 1000000000;
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min();
constexpr std::chrono::nanoseconds kAtOnce = std::chrono::hours(1);
constexpr std::chrono::nanoseconds kStep(0);  // one edge, or a part of it, at a time

bool hasSameBits(const Tf2Pose& a, const Tf2Pose& b) {
  return std::memcmp(a.numbers.data(), b.numbers.data(), sizeof(a.numbers)) == 0;
}

/// The number of a frame that an excerpt has.
Frame frameOf(const TransformBuffer& copy, const std::string& name) {
  Frame frame = 0;
  while (copy.name(frame) != name)
    ++frame;
  return frame;
}

/// Frames of a buffer, and what it says of them at some times.
class Excerpts {
 public:
  Excerpts(std::uint64_t seed, Oddity oddity) : random_(seed, oddity), times_(seed) {}

  void receive() { both_.add(random_.next()); }

  void clear() {
    both_.tf2.clear();
    both_.ours.clear();
  }

  /// Returns how many poses were known.
  int expectSamePoses() {
    const std::int64_t span = pick(2) * static_cast<std::int64_t>(times_.uniform(0, 3e9));
    const std::int64_t end = pickTime();
    TfExcerpt excerpt(end, span, kNever);
    const std::vector<Pair> pairs = addPairs(excerpt);
    copy(excerpt);
    int known = 0;
    for (const Pair& pair : pairs) {
      for (const double part : {0.0, times_.uniform(0, 1), 1.0}) {
        const auto before = static_cast<std::int64_t>(part * static_cast<double>(span));
        known += expectSamePose(excerpt, pair, end - before);
      }
    }
    return known;
  }

  int expectSameLatest() {
    TfExcerpt excerpt(0, 0, kNever);
    const std::vector<Pair> pairs = addPairs(excerpt);
    copy(excerpt);
    int known = 0;
    for (const Pair& pair : pairs) {
      FrameTracker ours(excerpt.buffer());
      FrameTracker theirs(both_.ours);
      ours.setTarget(pair.target_copy, 0, ros::Time(1));
      theirs.setTarget(pair.target, 0, ros::Time(1));
      const auto handle = ours.follow(pair.source_copy);
      const auto expected_handle = theirs.follow(pair.source);
      const FramePose& pose = handle.pose();
      const FramePose& expected = expected_handle.pose();
      EXPECT_EQ(pose.problem, expected.problem);
      if (expected.problem != TransformProblem::kNone) continue;
      EXPECT_EQ(pose.stamp, expected.stamp);
      EXPECT_TRUE(pose.fixed_from_frame.affine.matrix() ==
                  expected.fixed_from_frame.affine.matrix());
      ++known;
    }
    return known;
  }

 private:
  struct Pair {
    Frame target;
    Frame source;
    Frame target_copy;
    Frame source_copy;
  };

  int pick(int count) { return random_.pick(count); }

  /// Half of them are stamps, where tf2 does not always interpolate.
  std::int64_t pickTime() {
    const std::optional<std::int64_t> stamp = both_.pickStamp(random_);
    if (!stamp) return kSecond;
    return *stamp + pick(2) * static_cast<std::int64_t>(times_.uniform(-1e7, 1e7));
  }

  Frame pickFrame() { return both_.ours.frame(frameName(pick(random_.frames()))); }

  std::vector<Pair> addPairs(TfExcerpt& excerpt) {
    std::vector<Pair> pairs(4);
    for (Pair& pair : pairs) {
      pair.target = pickFrame();
      pair.source = pickFrame();
      pair.target_copy = excerpt.add(both_.ours, pair.target);
      pair.source_copy = excerpt.add(both_.ours, pair.source);
    }
    return pairs;
  }

  /// At once, or in pieces with a clock jump before the last of them.
  void copy(TfExcerpt& excerpt) {
    if (pick(2) == 0) {
      EXPECT_TRUE(excerpt.copy(both_.ours, kAtOnce));
      return;
    }
    for (int i = pick(10); i > 0; --i) {
      if (excerpt.copy(both_.ours, kStep)) return;
    }
    if (pick(40) == 0) {
      clear();
      for (int i = 0; i < 4; ++i)
        receive();
    }
    while (!excerpt.copy(both_.ours, kStep)) {
    }
  }

  bool expectSamePose(TfExcerpt& excerpt, const Pair& pair, std::int64_t stamp) {
    const auto pose = excerpt.buffer().pose(pair.target_copy, pair.source_copy, stamp);
    const auto expected = both_.ours.pose(pair.target, pair.source, stamp);
    EXPECT_EQ(pose.has_value(), expected.has_value());
    if (!pose || !expected) return false;
    EXPECT_TRUE(hasSameBits(*pose, *expected));
    if (pair.target == pair.source) return true;
    const auto in_tf2 = both_.lookUp(both_.ours.name(pair.target), both_.ours.name(pair.source),
                                     ros::Time().fromNSec(static_cast<std::uint64_t>(stamp)));
    EXPECT_TRUE(in_tf2);
    if (in_tf2) expectSame(MatrixPose(*pose).affine, *in_tf2);
    return true;
  }

  RandomTf random_;
  brute_force::Random times_;
  BesideTf2 both_;
};

TEST(TfExcerpt, PosesHaveTheBitsOfTheOriginal) {
  constexpr int kHistories = repetitions(100);
  constexpr int kMessages = 100;
  int known = 0;
  int latest = 0;
  for (std::uint64_t seed = 1; seed <= kHistories && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Excerpts excerpts(seed, seed % 3 == 0 ? Oddity::kLoops : Oddity::kUneven);
    for (int i = 0; i < kMessages; ++i) {
      excerpts.receive();
      if (i == kMessages / 2) excerpts.clear();
      known += excerpts.expectSamePoses();
      if (i % 4 == 0) latest += excerpts.expectSameLatest();
    }
  }
  std::cout << known << " poses and " << latest << " latest poses were known\n";
  EXPECT_GT(known, kHistories * kMessages);
  EXPECT_GT(latest, kHistories * kMessages / 4);
}

/// One edge with a long history.
class LongHistoryTest : public testing::Test {
 protected:
  static constexpr int kSamples = 10000;

  LongHistoryTest() {
    tf_.add({edge("map", "base", 0, Eigen::Quaterniond::Identity(), {0, 0, 1})}, true,
            ros::Time(1));
    for (int i = 0; i < kSamples; ++i)
      send(i);
  }

  void send(int i) {
    tf_.add(
        {edge("base", "arm", 1000 + 0.001 * i, Eigen::Quaterniond::Identity(), {1.0 * i, 0, 0})},
        false, ros::Time(1));
  }

  int pieces(TfExcerpt& excerpt) {
    excerpt.add(tf_, tf_.frame("arm"));
    int result = 1;
    for (; !excerpt.copy(tf_, kStep); ++result)
      send(next_++);
    return result;
  }

  std::size_t copied(const TfExcerpt& excerpt) const {
    return excerpt.buffer().history(frameOf(excerpt.buffer(), "arm"))->samples().size();
  }

  TransformBuffer tf_;
  int next_ = kSamples;
};

TEST_F(LongHistoryTest, IsCopiedInPiecesWhileTfGoesOn) {
  TfExcerpt excerpt(1009 * kSecond, 9 * kSecond, kNever);
  EXPECT_GT(pieces(excerpt), 20);
  const TransformBuffer& copy = excerpt.buffer();
  for (std::int64_t i = 1000; i < 9000; ++i) {
    const std::int64_t stamp = 1000 * kSecond + i * 1000000 + 300000;
    const auto pose = copy.pose(frameOf(copy, "map"), frameOf(copy, "arm"), stamp);
    const auto expected = tf_.pose(tf_.frame("map"), tf_.frame("arm"), stamp);
    ASSERT_TRUE(pose && expected);
    ASSERT_TRUE(hasSameBits(*pose, *expected));
  }
}

TEST_F(LongHistoryTest, OnlyWhatIsNeededIsCopied) {
  TfExcerpt one_time(1005 * kSecond, 0, kNever);
  EXPECT_LE(pieces(one_time), 8);
  EXPECT_EQ(copied(one_time), 1u);
  TfExcerpt latest(0, 0, kNever);
  pieces(latest);
  EXPECT_LE(copied(latest), 12u);
  TfExcerpt latest_span(0, kSecond / 10, kNever);
  pieces(latest_span);
  EXPECT_LE(copied(latest_span), 115u);
}

// Else a joint that was switched off would make each request copy everything.
TEST_F(LongHistoryTest, AStaleEdgeDoesNotDecideHowMuchIsCopied) {
  tf_.add({edge("base", "leg", 10, Eigen::Quaterniond::Identity(), {1, 0, 0})}, false,
          ros::Time(0.5));
  TfExcerpt excerpt(0, 0, kSecond * 3 / 4);
  excerpt.add(tf_, tf_.frame("leg"));
  pieces(excerpt);
  EXPECT_LE(copied(excerpt), 12u);
}

TEST_F(LongHistoryTest, AfterAClockJumpNothingOfBeforeIsLeft) {
  TfExcerpt excerpt(1009 * kSecond, 9 * kSecond, kNever);
  excerpt.add(tf_, tf_.frame("arm"));
  for (int i = 0; i < 10; ++i)
    ASSERT_FALSE(excerpt.copy(tf_, kStep));
  tf_.clear();
  send(5);
  while (!excerpt.copy(tf_, kStep)) {
  }
  EXPECT_EQ(copied(excerpt), 1u);
}

TEST_F(LongHistoryTest, AnEdgeThatAppearsMeanwhileMayBeMissing) {
  TfExcerpt excerpt(1009 * kSecond, 9 * kSecond, kNever);
  const Frame late = excerpt.add(tf_, tf_.frame("late"));
  const Frame arm = excerpt.add(tf_, tf_.frame("arm"));
  ASSERT_FALSE(excerpt.copy(tf_, kStep));
  tf_.add({edge("arm", "late", 1009, Eigen::Quaterniond::Identity(), {1, 0, 0})}, false,
          ros::Time(1));
  while (!excerpt.copy(tf_, kStep)) {
  }
  EXPECT_FALSE(excerpt.buffer().pose(arm, late, 1009 * kSecond));
}

TEST(FindFrame, LeavesTheBufferAsItIs) {
  TransformBuffer tf;
  EXPECT_FALSE(tf.find("a"));
  EXPECT_EQ(tf.size(), 0u);
  const Frame frame = tf.frame("a");
  EXPECT_EQ(tf.find("a"), frame);
  EXPECT_FALSE(tf.isMet(frame));
  tf.add({edge("b", "a", 1, Eigen::Quaterniond::Identity(), {0, 0, 0})}, false, ros::Time(1));
  EXPECT_TRUE(tf.isMet(frame));
  EXPECT_TRUE(tf.isMet(*tf.find("b")));
}

}  // namespace
}  // namespace link_bounds
