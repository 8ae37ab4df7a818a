// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// No two spheres of random arms touch before the time that was said, however the joints move within
// their limits and however late tf is.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "testing/contact_times_testing.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr int kJoints = 6;
constexpr double kRadius = 0.08;
constexpr int kStates = 12;

/// A chain of spheres with joints in random directions, some of which slide.
std::string randomArm(Random& random) {
  std::string urdf = "<robot name=\"arm\">" + sphere("l0", kRadius);
  for (int i = 1; i <= kJoints; ++i) {
    const Eigen::Vector3d axis = random.vector(1).normalized();
    const Eigen::Vector3d origin = random.vector(1).normalized() * random.uniform(0.2, 0.4);
    std::ostringstream content;
    content << "<origin xyz=\"" << origin.transpose() << "\"/><axis xyz=\"" << axis.transpose()
            << "\"/><limit lower=\"-2\" upper=\"2\" effort=\"1\" velocity=\""
            << random.uniform(0.3, 2) << "\"/>";
    const std::string name = "l" + std::to_string(i);
    urdf += sphere(name, kRadius) + joint(i % 3 == 0 ? "prismatic" : "revolute",
                                          "l" + std::to_string(i - 1), name, content.str());
  }
  return urdf + "</robot>";
}

/// Of two links, exactly: all are spheres.
double gapOf(const std::vector<Eigen::Isometry3d>& poses, std::size_t a, std::size_t b) {
  return (poses[a].translation() - poses[b].translation()).norm() - 2 * kRadius;
}

/// The smallest one of all that are joined by two joints or more.
double smallestGap(const Robot& robot, const Values& values) {
  double smallest = 1e9;
  const auto poses = linkPoses(robot, values);
  for (std::size_t a = 0; a < poses.size(); ++a) {
    for (std::size_t b = a + 2; b < poses.size(); ++b)
      smallest = std::min(smallest, gapOf(poses, a, b));
  }
  return smallest;
}

std::size_t linkNamed(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&name](const Link& link) { return link.name == name; });
  return static_cast<std::size_t>(found - robot.links.begin());
}

/// All joints at full speed, in the direction that brings two links nearer: their worst case.
Values bangBang(const Robot& robot, const Values& values, std::size_t a, std::size_t b,
                double step) {
  constexpr double kProbe = 1e-4;
  Values next = values;
  const double gap = gapOf(linkPoses(robot, values), a, b);
  for (std::size_t j = 0; j < values.size(); ++j) {
    Values probe = values;
    probe[j] += kProbe;
    const double sign = gapOf(linkPoses(robot, probe), a, b) < gap ? 1 : -1;
    const Limits limits = *robot.joints[j].limits;
    next[j] += sign * step * *robot.joints[j].max_speed;
    next[j] = std::min(std::max(next[j], limits.lower), limits.upper);
  }
  return next;
}

Values randomValues(const Robot& robot, Random& random) {
  Values values;
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    values.push_back(random.uniform(-1.8, 1.8));
  return values;
}

/// How many pairs touched before the time that was said, and how early the median is, as a share.
struct WorstCases {
  int too_late = 0;
  std::vector<double> shares;
};

WorstCases tryWorstCases(double faster, int states) {
  constexpr double kStep = 0.004;   // s
  constexpr double kLongest = 1.5;  // s; who touches later is not waited for
  Random random(7);
  WorstCases result;
  for (int i = 0; i < states; ++i) {
    MovingRobot robot(randomArm(random), parametersOf("l0", 5));
    const Values values = randomValues(robot.robot(), random);
    stand(robot, values);
    const EarliestContactArray array = robot.earliest();
    for (const EarliestContact& contact : array.contacts) {
      const double earliest = contact.earliest.toSec() - kStamp;
      Values then = values;
      double time = 0;
      const std::size_t a = linkNamed(robot.robot(), contact.first);
      const std::size_t b = linkNamed(robot.robot(), contact.second);
      while (time < kLongest && gapOf(linkPoses(robot.robot(), then), a, b) > 0) {
        then = bangBang(robot.robot(), then, a, b, kStep * faster);
        time += kStep;
      }
      if (time >= kLongest || time == 0) continue;
      result.too_late += time < earliest;
      result.shares.push_back(earliest / time);
    }
  }
  std::sort(result.shares.begin(), result.shares.end());
  return result;
}

TEST(ContactTimes, AreNeverLaterThanBangBang) {
  const WorstCases found = tryWorstCases(1, kStates);
  EXPECT_EQ(found.too_late, 0);
  ASSERT_GT(found.shares.size(), 20u);
  std::cout << found.shares.size() << " worst cases touched; the times said are "
            << found.shares[found.shares.size() / 2] << " (median) and " << found.shares.back()
            << " (latest) of theirs\n";
  EXPECT_GT(found.shares.back(), 0.7);  // not by being far too early
}

/// A robot whose joints are faster than they say touches earlier.
TEST(ContactTimes, FasterJointsTouchEarlier) {
  EXPECT_GT(tryWorstCases(1.3, kStates).too_late, 0);
}

/// A message of tf on its way.
struct Sent {
  double stamp;
  double arrival;
  Values values;
};

/// A random motion at full speed, told by tf that is late, lossy and out of order. Whenever
/// something arrives: what is said then is true of all that follows.
TEST(ContactTimes, HoldHoweverLateTfIs) {
  constexpr double kStep = 0.01;
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(repetitions(20)); ++seed) {
    Random random(seed);
    MovingRobot robot(randomArm(random), parametersOf("l0", 5));
    Values values = randomValues(robot.robot(), random);
    std::vector<Sent> sent;
    std::vector<double> gaps;  // the smallest, by step
    Values signs(values.size(), 1);
    constexpr int kSteps = 150;
    const double begin = kStamp - kSteps * kStep;
    for (int i = 0; i < kSteps; ++i) {
      const double stamp = begin + i * kStep;
      gaps.push_back(smallestGap(robot.robot(), values));
      if (random.uniform(0, 1) < 0.7)
        sent.push_back({stamp, stamp + random.uniform(0, 0.1), values});
      for (std::size_t j = 0; j < values.size(); ++j) {
        if (random.uniform(0, 1) < 0.1) signs[j] = -signs[j];
        if (std::abs(values[j]) > 1.95) signs[j] = values[j] > 0 ? -1 : 1;
        values[j] += signs[j] * kStep * *robot.robot().joints[j].max_speed;
      }
    }
    std::sort(sent.begin(), sent.end(),
              [](const Sent& a, const Sent& b) { return a.arrival < b.arrival; });
    for (const Sent& message : sent) {
      robot.send(message.stamp, message.values);
      const EarliestContactArray array = robot.earliest(message.arrival);
      for (int i = 0; i < kSteps; ++i) {
        const double time = begin + i * kStep;
        if (time < array.header.stamp.toSec() || time >= untilOf(array)) continue;
        EXPECT_GT(gaps[static_cast<std::size_t>(i)], 0) << seed << " at " << time;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, repetitions(1000));
}

}  // namespace
}  // namespace link_bounds
