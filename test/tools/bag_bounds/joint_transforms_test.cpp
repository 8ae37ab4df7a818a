// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// JointTransforms remembers where each joint was. In random sequences of messages, some of which
// are late or have positions that are not finite, and whose clock also jumps back, it gives what
// one that saw only this message and the newest finite position of a joint gives.
#include "tools/bag_bounds/scene/joint_transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "testing/brute_force.h"

namespace link_bounds {
namespace {

using JointMessage = sensor_msgs::JointState;

/// A chain of `count` joints of any kind. Each may follow one that is before it in a random order.
Robot randomRobot(brute_force::Random& random, std::size_t count) {
  Robot robot;
  robot.links.resize(count + 1);
  for (std::size_t i = 0; i <= count; ++i)
    robot.links[i].name = "link_" + std::to_string(i);
  for (std::size_t i = 0; i < count; ++i) {
    const double kind = random.uniform(0, 1);
    Joint joint{
        "joint_" + std::to_string(i),
        i,
        i + 1,
        kind < 0.7 ? Motion::kRotation : (kind < 0.9 ? Motion::kTranslation : Motion::kNone),
        Eigen::Isometry3d::Identity(),
        Eigen::Vector3d::UnitX(),
        {},
        {}};
    joint.parent_from_joint.translation().z() = random.uniform(0, 1);
    if (random.uniform(0, 1) < 0.4) joint.limits = Limits{-7, 7};
    if (i > 0 && random.uniform(0, 1) < 0.4) {
      const double factor = random.uniform(0, 1) < 0.5 ? -2 : random.uniform(-2, 2);
      const auto leader = static_cast<std::size_t>(random.uniform(0, static_cast<double>(i)));
      joint.mimic = Mimic{"joint_" + std::to_string(leader), factor, random.uniform(-1, 1)};
    }
    robot.joints.push_back(joint);
  }
  return robot;
}

/// What it tells of one link of the robot, from one message.
std::vector<TransformView> ofLink(const std::vector<TransformView>& views, const Link& link) {
  std::vector<TransformView> result;
  std::copy_if(views.begin(), views.end(), std::back_inserter(result),
               [&](const TransformView& view) { return view.child == link.name; });
  return result;
}

bool isFinite(const TransformView& view) {
  const auto& numbers = view.parent_from_child.numbers;
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

bool areSameViews(const TransformView& a, const TransformView& b) {
  return a.stamp == b.stamp && a.parent == b.parent &&
         (a.parent_from_child.numbers == b.parent_from_child.numbers ||
          !(isFinite(a) || isFinite(b)));
}

std::size_t lossesOf(const JointTransforms& transforms) {
  const std::string loss = transforms.loss();
  return loss.empty() ? 0 : std::stoul(loss);
}

class JointRecording {
 public:
  explicit JointRecording(std::uint64_t seed)
      : random_(seed),
        robot_(randomRobot(random_, 1 + seed % 8)),
        are_whole_(seed % 2 == 0),
        transforms_(robot_, "") {}

  void send() {
    const JointMessage message = nextMessage();
    const auto views = transforms_.of(message, stamp_);
    for (const Joint& joint : robot_.joints) {
      const Link& link = robot_.links[joint.child];
      const auto told = ofLink(views, link);
      const auto expected = withoutMemory(joint, message, link);
      ASSERT_EQ(told.size(), expected.size()) << joint.name;
      for (std::size_t i = 0; i < told.size(); ++i)
        EXPECT_TRUE(areSameViews(told[i], expected[i])) << joint.name << ", transform " << i;
      between_ += told.empty() ? 0 : told.size() - 1;
      if (told.empty() || !isFinite(told.back())) continue;
      const auto [last, is_new] = last_.try_emplace(joint.name, Sent{message, stamp_});
      if (!is_new && stamp_ > last->second.stamp) last->second = {message, stamp_};
    }
    countLosses(message);
  }

  std::size_t between() const { return between_; }
  std::size_t losses() const { return losses_; }

 private:
  struct Sent {
    JointMessage message;
    ros::Time stamp;
  };

  JointMessage nextMessage() {
    const double step = random_.uniform(-0.1, 1);
    now_ += ros::Duration(step < -0.05 ? -2 : std::max(step, 0.0));
    if (step < -0.05) forget();
    const bool is_late = !are_whole_ && random_.uniform(0, 1) < 0.2;
    stamp_ = now_ - ros::Duration(is_late ? random_.uniform(0, 2) : 0);
    JointMessage message;
    for (const Joint& joint : robot_.joints) {
      if (!are_whole_ && random_.uniform(0, 1) < 0.3) continue;
      message.name.push_back(joint.name);
      message.position.push_back(random_.uniform(0, 1) < 0.05 ? 1e4 : random_.uniform(-7, 7));
      if (!are_whole_ && random_.uniform(0, 1) < 0.2) message.position.back() = NAN;
    }
    return message;
  }

  void forget() {
    transforms_.forget();
    last_.clear();
    before_.reset();
  }

  /// Of one that saw only the message with the newest position of the joint. Its views are into
  /// names of `kept_`.
  std::vector<TransformView> withoutMemory(const Joint& joint, const JointMessage& message,
                                           const Link& link) {
    kept_.push_back(std::make_unique<JointTransforms>(robot_, ""));
    const auto last = last_.find(joint.name);
    if (last != last_.end()) kept_.back()->of(last->second.message, last->second.stamp);
    return ofLink(kept_.back()->of(message, stamp_), link);
  }

  /// Where all messages have all joints, the losses are those of each message and the one before.
  void countLosses(const JointMessage& message) {
    if (!are_whole_) return;
    JointTransforms fresh(robot_, "");
    if (before_) fresh.of(before_->message, before_->stamp);
    fresh.of(message, stamp_);
    losses_ += lossesOf(fresh);
    if (!before_ || stamp_ > before_->stamp) before_ = Sent{message, stamp_};
    EXPECT_EQ(lossesOf(transforms_), losses_);
  }

  brute_force::Random random_;
  const Robot robot_;
  const bool are_whole_;
  JointTransforms transforms_;
  ros::Time now_{1000};
  ros::Time stamp_;  ///< of the message that is sent
  std::map<std::string, Sent> last_;
  std::vector<std::unique_ptr<JointTransforms>> kept_;
  std::optional<Sent> before_;
  std::size_t between_ = 0;
  std::size_t losses_ = 0;
};

TEST(JointTransforms, RandomSequencesAreThoseOfOneWithoutMemory) {
  std::size_t between = 0, losses = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    JointRecording recording(seed);
    for (int i = 0; i < 30; ++i)
      recording.send();
    if (HasFailure()) break;
    between += recording.between();
    losses += recording.losses();
  }
  EXPECT_GT(between, 1000u);
  EXPECT_GT(losses, 100u);
}

}  // namespace
}  // namespace link_bounds
