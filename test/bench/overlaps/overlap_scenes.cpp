// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes are as large as those of links, 0.2 m. No scene ends.
#include "bench/overlaps/overlap_scenes.h"

#include <cmath>

#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

using brute_force::Random;

constexpr double kSide = 0.2;  // mean [m]
constexpr double kOverlapsPerBox = 2;
constexpr std::size_t kLinksPerArm = 50;

/// The width of a cube in which each of `count` random boxes overlaps two others on average. Along
/// one axis a box overlaps the fraction 2 r - r^2 of the others, with r = side / width.
double clutterWidth(std::size_t count) {
  const double on_one_axis = std::cbrt(kOverlapsPerBox / static_cast<double>(count - 1));
  return kSide / (1 - std::sqrt(1 - on_one_axis));
}

/// A box that flies straight and bounces off the walls.
struct Flyer {
  Eigen::Vector3d center, half, step;

  void advance(double wall) {
    for (int k = 0; k < 3; ++k) {
      if (std::abs(center[k] + step[k]) > wall) step[k] = -step[k];
      center[k] += step[k];
    }
  }
};

std::vector<Flyer> makeFlyers(std::size_t count, double step) {
  Random random(1);
  std::vector<Flyer> flyers;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d center = random.vector(clutterWidth(count) / 2);
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(kSide / 2) + random.vector(kSide / 4);
    flyers.push_back({center, half, random.rotation() * Eigen::Vector3d(step, 0, 0)});
  }
  return flyers;
}

OverlapScene clutter(const std::string& name, std::size_t count, double step) {
  const double wall = clutterWidth(count) / 2;
  return {name, [wall, flyers = makeFlyers(count, step)](SceneBoxes& boxes) mutable {
            boxes.clear();
            for (Flyer& flyer : flyers) {
              flyer.advance(wall);
              boxes.emplace_back(flyer.center - flyer.half, flyer.center + flyer.half);
            }
          }};
}

/// Clutter, and a box around all of it that grows and shrinks.
OverlapScene covered(std::size_t count) {
  const double width = clutterWidth(count);
  return {"cover",
          [width, step = 0, rest = clutter("", count, 0.01 * kSide)](SceneBoxes& boxes) mutable {
            rest.advance(boxes);
            const double half = width * (1 + 0.1 * std::sin(0.01 * ++step));
            boxes[boxes.size() / 2] =
                Aabb(Eigen::Vector3d::Constant(-half), Eigen::Vector3d::Constant(half));
          }};
}

/// A row of boxes, each overlapping the next one. They drift and swing by about 1 % of a box in
/// each step.
OverlapScene line(std::size_t count) {
  return {"line", [count, step = 0](SceneBoxes& boxes) mutable {
            boxes.clear();
            ++step;
            const Eigen::Vector3d half = Eigen::Vector3d::Constant(kSide / 2);
            for (std::size_t i = 0; i < count; ++i) {
              const double place = static_cast<double>(i);
              const double swing = 0.1 * kSide * std::sin(0.1 * step + place);
              const Eigen::Vector3d center(swing, 0.7 * kSide * place + 0.002 * step, -swing);
              boxes.emplace_back(center - half, center + half);
            }
          }};
}

/// A joint that swings about its middle position.
struct SwingingJoint {
  double middle, phase, speed;

  double angle(int step) const { return middle + 0.3 * std::sin(speed * step + phase); }
};

Eigen::Isometry3d armBase(std::size_t arm, std::size_t arms) {
  const auto row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(arms))));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << 2.0 * static_cast<double>(arm % row), 2.0 * static_cast<double>(arm / row),
      0;
  return pose;
}

void addArm(Eigen::Isometry3d pose, const SwingingJoint* joints, int step, SceneBoxes& boxes) {
  const Aabb link(Eigen::Vector3d(-0.03, -0.03, -0.02), Eigen::Vector3d(0.03, 0.03, 0.12));
  for (std::size_t i = 0; i < kLinksPerArm; ++i) {
    const Eigen::Vector3d axis = i % 2 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    pose.rotate(Eigen::AngleAxisd(joints[i].angle(step), axis));
    Aabb box;
    for (const Eigen::Vector3d& corner : corners(link))
      box.extend(pose * corner);
    boxes.push_back(box);
    pose.translate(Eigen::Vector3d(0, 0, 0.1));
  }
}

/// Arms of 50 links and at most 5 m length, 2 m apart.
OverlapScene arms(std::size_t count) {
  Random random(2);
  const std::size_t arm_count = count / kLinksPerArm;
  std::vector<SwingingJoint> joints;
  for (std::size_t i = 0; i < arm_count * kLinksPerArm; ++i)
    joints.push_back(
        {random.uniform(-0.6, 0.6), random.uniform(-3, 3), random.uniform(0.01, 0.04)});
  return {"arms", [arm_count, joints, step = 0](SceneBoxes& boxes) mutable {
            boxes.clear();
            ++step;
            for (std::size_t arm = 0; arm < arm_count; ++arm)
              addArm(armBase(arm, arm_count), &joints[arm * kLinksPerArm], step, boxes);
          }};
}

}  // namespace

std::vector<OverlapScene> overlapScenes(std::size_t count) {
  return {clutter("clutter_1_percent", count, 0.01 * kSide),
          clutter("clutter_50_percent", count, 0.5 * kSide), arms(count), line(count),
          covered(count)};
}

}  // namespace link_bounds::bench
