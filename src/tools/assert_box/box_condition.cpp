// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of two boxes.
#include "tools/assert_box/box_condition.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace link_bounds {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool isBox(const Aabb& box) {
  return box.min().allFinite() && box.max().allFinite() &&
         (box.min().array() <= box.max().array()).all();
}

std::string pointText(const Eigen::Vector3d& point) {
  char text[100];
  std::snprintf(text, sizeof(text), "[%.9g, %.9g, %.9g]", point.x(), point.y(), point.z());
  return text;
}

}  // namespace

double excess(const BoxCondition& condition, const Aabb& box) {
  if (!isBox(box)) return kInfinity;
  const Eigen::Vector3d below = condition.wanted.min() - box.min();
  const Eigen::Vector3d above = box.max() - condition.wanted.max();
  switch (condition.check) {
    case BoxCheck::kEqual:
      return below.cwiseAbs().cwiseMax(above.cwiseAbs()).maxCoeff();
    case BoxCheck::kInside:
      return below.cwiseMax(above).maxCoeff();
    case BoxCheck::kOutside:
      break;
  }
  const Eigen::Vector3d gap_below = condition.wanted.min() - box.max();
  const Eigen::Vector3d gap_above = box.min() - condition.wanted.max();
  return -gap_below.cwiseMax(gap_above).maxCoeff();
}

bool isSatisfied(const BoxCondition& condition, const std::vector<Aabb>& boxes) {
  const auto keeps_it = [&](const Aabb& box) {
    return excess(condition, box) <= condition.tolerance;
  };
  return !boxes.empty() && std::all_of(boxes.begin(), boxes.end(), keeps_it);
}

void Hold::update(bool is_true, double now) {
  longest_ = longest(now);
  was_kept_ = isKept(now);
  if (!is_true) {
    since_.reset();
  } else if (!since_) {
    since_ = now;
  }
}

bool Hold::isKept(double now) const {
  return was_kept_ || (since_ && now - *since_ >= seconds_);
}

double Hold::longest(double now) const {
  return since_ ? std::max(longest_, now - *since_) : longest_;
}

std::string boxText(const Aabb& box) {
  return pointText(box.min()) + " to " + pointText(box.max());
}

}  // namespace link_bounds
