// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the box of a name in each message and keeps the last one for the report.
#include "tools/assert_box/box_watch.h"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace link_bounds {
namespace {

std::string secondsText(double seconds) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.3g s", seconds);
  return text;
}

std::string metresText(double metres) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.3g m", metres);
  return text;
}

Eigen::Vector3d vectorOf(const geometry_msgs::Point& point) {
  return {point.x, point.y, point.z};
}

std::vector<Aabb> boxesOf(const AxisAlignedBoxArray& message, const std::string& name) {
  std::vector<Aabb> result;
  for (const AxisAlignedBox& box : message.boxes) {
    if (box.name == name) result.emplace_back(vectorOf(box.min), vectorOf(box.max));
  }
  return result;
}

bool isIncomplete(const AxisAlignedBoxArray& message, const std::string& name) {
  return std::count(message.incomplete.begin(), message.incomplete.end(), name) > 0;
}

std::string namesOf(const AxisAlignedBoxArray& message) {
  std::string result;
  for (const AxisAlignedBox& box : message.boxes)
    result += (result.empty() ? "" : ", ") + box.name;
  return result.empty() ? "none" : result;
}

/// Of several boxes the one that is farthest from what was asked for.
std::string worstText(const BoxAssertion& assertion, const AxisAlignedBoxArray& message) {
  const std::vector<Aabb> boxes = boxesOf(message, assertion.name);
  const auto is_better = [&](const Aabb& a, const Aabb& b) {
    return excess(assertion.condition, a) < excess(assertion.condition, b);
  };
  const Aabb& worst = *std::max_element(boxes.begin(), boxes.end(), is_better);
  std::string text = boxText(worst) + " in frame \"" + message.header.frame_id + "\"";
  const double off = excess(assertion.condition, worst);
  if (off > assertion.condition.tolerance) text += ", off by " + metresText(off);
  return text + (isIncomplete(message, assertion.name) ? ", incomplete" : "");
}

}  // namespace

void BoxWatch::see(const AxisAlignedBoxArray::ConstPtr& message, double now) {
  const std::vector<Aabb> boxes = boxesOf(*message, assertion_.name);
  last_ = message;
  if (!boxes.empty()) last_with_ = message;
  has_lost_publisher_ = false;
  const bool is_complete = !isIncomplete(*message, assertion_.name);
  hold_.update(is_complete && isSatisfied(assertion_.condition, boxes), now);
}

void BoxWatch::losePublisher(double now) {
  has_lost_publisher_ = true;
  hold_.update(false, now);
}

std::string BoxWatch::failure(double now) const {
  std::string text = "box \"" + assertion_.name + "\" of " + assertion_.topic + " was not " +
                     assertion_.check + (assertion_.check == "equal" ? " to " : " ") +
                     boxText(assertion_.condition.wanted) + " (tolerance " +
                     metresText(assertion_.condition.tolerance) + ")";
  if (assertion_.hold > 0) {
    text += " for " + secondsText(assertion_.hold) + " without a break, at most for " +
            secondsText(hold_.longest(now)) + ",";
  }
  return text + " within " + secondsText(assertion_.deadline) + "\n" + lastSeen();
}

std::string BoxWatch::lastSeen() const {
  if (!last_) return "no message came; is the topic's name right?";
  std::string text;
  if (last_ != last_with_) {
    text = "the last message has no such box; it is " +
           std::string(isIncomplete(*last_, assertion_.name) ? "" : "not ") +
           "named in incomplete. Boxes: " + namesOf(*last_) + "\n";
  }
  if (last_with_) text += "last box: " + worstText(assertion_, *last_with_) + "\n";
  if (has_lost_publisher_) text += "nobody publishes this topic any more\n";
  text.pop_back();
  return text;
}

}  // namespace link_bounds
