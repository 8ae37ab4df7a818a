// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Frames that nobody needs are forgotten; those that are needed, and what others read, stay.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "testing/live_boxes_testing.h"
#include "testing/sanitized.h"
#include "world/tf/frame_tracker.h"
#include "world/tf/tf_excerpt.h"

namespace link_bounds {
namespace {

const Eigen::Quaterniond kTurn(Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()));

/// A buffer that the update thread looks after, as the node does.
class Kept {
 public:
  explicit Kept(std::size_t kept) : kept_(kept) { tracker_.setTarget("base", 0, time()); }

  void send(const std::string& parent, const std::string& child, double x, bool is_static = false,
            double age = 0) {
    const geometry_msgs::TransformStamped transform =
        edge(parent, child, seconds_ - age, kTurn, {x, 0, 0});
    TransformView view(transform);
    const std::string names = parent + " " + child;
    view.names = names;
    tf.add({view}, is_static, time());
  }

  /// Ticks for so long.
  void pass(double seconds, double tick = 0.05) {
    for (double end = seconds_ + seconds; seconds_ < end;) {
      seconds_ += tick;
      this->tick();
    }
  }

  void tick() {
    tracker_.update(time());
    tracker_.expire(time());
    tf.forgetQuiet(ros::SteadyTime(seconds_), kept_);
  }

  /// The same without any news of tf.
  void rest(double seconds) {
    for (double end = seconds_ + seconds; seconds_ < end;) {
      seconds_ += 1;
      tracker_.expire(time());
      tf.forgetQuiet(ros::SteadyTime(seconds_), kept_);
    }
  }

  FrameTracker& tracker() { return tracker_; }
  ros::Time time() const { return ros::Time(seconds_); }

  TransformBuffer tf;

 private:
  std::size_t kept_;
  double seconds_ = 1000;
  FrameTracker tracker_{tf};
};

std::string name(const char* kind, int i) {
  return kind + std::to_string(i);
}

TEST(ForgottenFrames, MemoryDoesNotGrowWithTheNamesOfStrangers) {
  constexpr int kNames = 20000;                  // in each round
  constexpr std::size_t kFrames = 2 * 1000 + 3;  // static ones, their parents, and ours
  Kept kept(1000);
  kept.send("base", "mount", 1, true);
  const FrameTracker::Handle camera = kept.tracker().follow("camera");
  for (int round = 0; round < 8; ++round) {
    for (int i = 0; i < kNames; ++i)
      kept.send(i % 2 == 0 ? "mount" : name("stranger", round * kNames + i - 1),
                name("stranger", round * kNames + i), i, i % 3 == 0);
    kept.send("mount", "camera", round + 1);
    kept.pass(130);
    kept.tracker().setTarget("base", 0, kept.time());  // looks at all edges again
    EXPECT_LE(kept.tf.inUse(), kFrames) << "round " << round;
    EXPECT_LE(kept.tf.size(), 2 * kNames + kFrames) << "round " << round;
    EXPECT_EQ(camera.pose().problem, TransformProblem::kNone);
    const Eigen::Vector3d expected =
        Eigen::Vector3d(1, 0, 0) + kTurn * Eigen::Vector3d(round + 1, 0, 0);
    EXPECT_TRUE(camera.pose().fixed_from_frame.affine.translation().isApprox(expected));
  }
}

TEST(ForgottenFrames, FramesThatNobodyFollowsAnyMoreNeedNoNewsToBeForgotten) {
  Kept kept(10);
  const FrameTracker::Handle camera = kept.tracker().follow("camera");
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 500; ++i) {
      const TransformBuffer::Hold hold(kept.tf, name("stranger", 500 * round + i));
      kept.tracker().follow(hold.frame());
    }
    kept.rest(200);
    EXPECT_LE(kept.tf.inUse(), 20u) << "round " << round;
  }
}

TEST(ForgottenFrames, LoopsOfStrangersAreForgottenToo) {
  Kept kept(10);
  for (int i = 0; i < 500; ++i) {
    kept.send(name("b", i), name("a", i), 1);
    kept.send(name("a", i), name("b", i), 1);
  }
  kept.pass(130);
  EXPECT_LE(kept.tf.inUse(), 10u);
}

TEST(ForgottenFrames, NoneIsForgottenWithinAMinute) {
  Kept kept(10);
  for (int i = 0; i < 500; ++i)
    kept.send("base", name("a", i), 1);
  const std::size_t before = kept.tf.inUse();
  kept.pass(55);
  EXPECT_EQ(kept.tf.inUse(), before);
}

TEST(ForgottenFrames, FewAreNeverForgotten) {
  Kept kept(1000);
  for (int i = 0; i < 500; ++i)
    kept.send("base", name("a", i), 1, i % 2 == 0);
  const std::size_t before = kept.tf.inUse();
  kept.pass(1000, 0.5);
  EXPECT_EQ(kept.tf.inUse(), before);
}

/// As those of a camera that no link needs, beside strangers.
class StaticFrames : public testing::Test {
 protected:
  StaticFrames() {
    kept_.send("base", "mount", 1, true);
    kept_.send("mount", "camera", 2, true);
    kept_.send("base", "shelf", 3, true);
  }

  /// Strangers come in so many rounds, and all become quiet.
  void beAmongStrangers(int rounds, bool is_static = false) {
    for (int round = 0; round < rounds; ++round) {
      for (int i = 0; i < 500; ++i)
        kept_.send("base", name(is_static ? "static" : "moving", 500 * round + i), 1, is_static);
      kept_.pass(130);
    }
  }

  bool isPlaced(const std::string& frame) {
    const auto base = kept_.tf.find("base"), source = kept_.tf.find(frame);
    return base && source && kept_.tf.pose(*base, *source, 0);
  }

  Kept kept_{10};
};

TEST_F(StaticFrames, StayWhereOnlyTheirEndIsHeld) {
  const TransformBuffer::Hold camera(kept_.tf, "camera");  // as that of a marker
  beAmongStrangers(3);
  EXPECT_TRUE(isPlaced("camera"));
}

TEST_F(StaticFrames, StayWhereNobodyNeedsThemYet) {
  beAmongStrangers(3);
  ASSERT_TRUE(isPlaced("shelf"));
  kept_.tracker().setTarget(*kept_.tf.find("shelf"), 0, kept_.time());
  const FrameTracker::Handle camera = kept_.tracker().follow("camera");
  EXPECT_EQ(camera.pose().problem, TransformProblem::kNone);
}

TEST_F(StaticFrames, OfStrangersStayIfTheyAreFew) {
  beAmongStrangers(3, true);
  EXPECT_TRUE(isPlaced("camera"));
  EXPECT_TRUE(isPlaced("static0"));
  EXPECT_FALSE(isPlaced("static1000"));
  EXPECT_LE(kept_.tf.inUse(), 2 * 10u + 1);
}

TEST(ForgottenFrames, ATickForgetsFewLongHistories) {
  constexpr int kEdges = 40, kSamples = 700;
  Kept kept(10);
  for (int i = 0; i < kSamples; ++i)
    for (int k = 0; k < kEdges; ++k)
      kept.send("base", name("a", k), i, false, 0.01 * (kSamples - i));
  const auto count = [&] {
    int histories = 0;
    for (int k = 0; k < kEdges; ++k) {
      const auto frame = kept.tf.find(name("a", k));
      histories += frame && kept.tf.history(*frame);
    }
    return histories;
  };
  int most = 0;
  for (int before = count(); before > 10 && kept.time().toSec() < 1200;) {
    kept.pass(0.05);
    const int after = count();
    most = std::max(most, std::exchange(before, after) - after);
  }
  EXPECT_GT(most, 0);
  EXPECT_LE(most, 2);
}

TEST(ForgottenFrames, AHeldOneStaysAsLongAsItIsHeld) {
  Kept kept(10);
  auto hold = std::make_unique<TransformBuffer::Hold>(kept.tf, "held");
  const auto frame = hold->frame();
  kept.send("base", "held", 1);
  for (int i = 0; i < 500; ++i)
    kept.send("base", name("a", i), 1);
  kept.pass(200);
  EXPECT_EQ(kept.tf.find("held"), frame);
  EXPECT_TRUE(kept.tf.hasParent(frame));
  for (int i = 0; i < 500; ++i)
    kept.send("base", name("c", i), 1);
  hold.reset();
  kept.pass(200);
  EXPECT_FALSE(kept.tf.find("held"));
}

TEST(ForgottenFrames, ANumberIsNotTakenForThatOfAnotherName) {
  Kept kept(10);
  const TransformBuffer::Hold before(kept.tf, "before"), child(kept.tf, "child");
  // The search for the second edge of a message begins with the one that followed the first before.
  const auto send = [&](const std::string& parent, double age) {
    const std::string names[] = {"base before", parent + " child"};
    std::vector<TransformView> views;
    const auto first = edge("base", "before", kept.time().toSec(), kTurn, {1, 0, 0});
    const auto second = edge(parent, "child", kept.time().toSec() - age, kTurn, {1, 0, 0});
    views.emplace_back(first).names = names[0];
    views.emplace_back(second).names = names[1];
    kept.tf.add(views, false, kept.time());
  };
  send("base", 0);
  send("other", 20);  // is refused as too old, but its names are known now
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 500 * (round + 1); ++i)  // more than numbers are free
      kept.send("base", name("a", round * 5000 + i), 1);
    kept.pass(130);
  }
  send("other", 0);
  EXPECT_EQ(kept.tf.name(kept.tf.parent(child.frame())), "other");
  EXPECT_EQ(kept.tf.find("other"), kept.tf.parent(child.frame()));
}

TEST(ForgottenFrames, WhatAnExcerptReadsStaysUntilItEnds) {
  Kept kept(10);
  kept.send("base", "seen", 1);
  auto excerpt = std::make_unique<TfExcerpt>(0, 0, 0);
  const auto seen = excerpt->add(kept.tf, *kept.tf.find("seen"));
  while (!excerpt->copy(kept.tf, std::chrono::seconds(1))) {
  }
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 500; ++i)
      kept.send("base", name("a", round * 500 + i), 1);
    kept.pass(130);
    EXPECT_EQ(excerpt->buffer().name(seen), "seen");
  }
  EXPECT_FALSE(kept.tf.find("seen"));
  const std::size_t before = kept.tf.size() + 500;
  EXPECT_GT(before, 2000u);  // no number was used again
  excerpt.reset();
  for (int i = 0; i < 500; ++i)
    kept.send("base", name("d", i), 1);
  kept.pass(200);
  for (int i = 0; i < 500; ++i)
    kept.send("base", name("e", i), 1);
  EXPECT_LE(kept.tf.size(), before);
}

/// Parents that change, static and late transforms, silence; beside a buffer that forgets nothing.
/// Without loops, and without frames that are both static and not: there, what was forgotten
/// counts.
class RandomLife : public testing::TestWithParam<std::uint64_t> {
 protected:
  static constexpr int kFrames = 60;

  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

  void send() {
    std::vector<geometry_msgs::TransformStamped> transforms;
    const bool is_static = pick(10) == 0;
    const int first = 1 + pick(kFrames - 1);
    for (int i = first; i < std::min(kFrames, first + 1 + pick(8)); ++i) {
      if ((i % 7 == 0) != is_static) continue;
      const int parent = pick(12) == 0 ? pick(i) : parents_[static_cast<std::size_t>(i)];
      if (pick(3) > 0) parents_[static_cast<std::size_t>(i)] = parent;
      const double age = pick(10) == 0 ? 0.1 * pick(120) : 0;
      transforms.push_back(
          edge(name("f", parent), name("f", i), seconds_ - age, kTurn, random_.vector(1)));
    }
    std::vector<TransformView> views(transforms.begin(), transforms.end());
    std::vector<std::string> names;
    for (const auto& transform : transforms)
      names.push_back(transform.header.frame_id + " " + transform.child_frame_id);
    for (std::size_t i = 0; i < views.size(); ++i)
      views[i].names = names[i];
    for (TransformBuffer* tf : {&forgetful_, &complete_})
      tf->add(views, is_static, ros::Time(seconds_));
  }

  void tick() {
    for (FrameTracker* tracker : {&tracker_, &complete_tracker_}) {
      tracker->update(ros::Time(seconds_));
      tracker->expire(ros::Time(seconds_));
    }
    forgetful_.forgetQuiet(ros::SteadyTime(seconds_), 5);
  }

  /// The same as that of the complete buffer, or none where a frame on the way was forgotten.
  void expectNoOtherPose(int a, int b, double stamp) {
    const auto time = static_cast<std::int64_t>(stamp * 1e9);
    const auto target = forgetful_.find(name("f", a)), source = forgetful_.find(name("f", b));
    if (!target || !source) return;
    const auto pose = forgetful_.pose(*target, *source, time);
    if (!pose) return;
    const auto all_target = complete_.find(name("f", a)), all_source = complete_.find(name("f", b));
    if (a == b && !all_target) return;  // nothing was sent of a frame that is only held
    ASSERT_TRUE(all_target && all_source);
    const auto expected = complete_.pose(*all_target, *all_source, time);
    ASSERT_TRUE(expected);
    ASSERT_EQ(pose->translation(), expected->translation());
    ASSERT_EQ(pose->rotation(), expected->rotation());
    ++found_;
  }

  brute_force::Random random_{GetParam()};
  double seconds_ = 1000;
  std::vector<int> parents_ = std::vector<int>(kFrames, 0);
  TransformBuffer forgetful_, complete_;
  FrameTracker tracker_{forgetful_}, complete_tracker_{complete_};
  int found_ = 0;
};

TEST_P(RandomLife, GivesTheSamePosesOrNone) {
  for (FrameTracker* tracker : {&tracker_, &complete_tracker_})
    tracker->setTarget("f0", 0, ros::Time(seconds_));
  std::vector<TransformBuffer::Hold> robot;  // as those of a model's links
  for (int i = 0; i <= 20; ++i)
    robot.emplace_back(forgetful_, name("f", i));
  std::vector<FrameTracker::Handle> handles, complete_handles;
  for (const int i : {6, 13, 20}) {
    handles.push_back(tracker_.follow(name("f", i)));
    complete_handles.push_back(complete_tracker_.follow(name("f", i)));
  }
  std::size_t fewest = 1000;
  for (int step = 0; step < 3000; ++step) {
    seconds_ += pick(40) == 0 ? 20.0 * pick(5) : 0.05;
    if (pick(3) == 0) send();
    tick();
    fewest = std::min(fewest, forgetful_.inUse());
    for (std::size_t i = 0; i < handles.size(); ++i) {
      const FramePose &pose = handles[i].pose(), &expected = complete_handles[i].pose();
      ASSERT_EQ(pose.problem, expected.problem) << step;
      if (pose.problem != TransformProblem::kNone) continue;
      ASSERT_EQ(pose.stamp, expected.stamp) << step;
      ASSERT_EQ(pose.fixed_from_frame.affine.matrix(), expected.fixed_from_frame.affine.matrix());
    }
    expectNoOtherPose(pick(kFrames), pick(kFrames), pick(2) == 0 ? 0 : seconds_ - 0.1 * pick(100));
  }
  EXPECT_GT(found_, 20);
  EXPECT_LT(fewest, static_cast<std::size_t>(kFrames));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomLife, testing::Range<std::uint64_t>(1, 1 + repetitions(40)));

}  // namespace
}  // namespace link_bounds
