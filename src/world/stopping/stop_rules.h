// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How the joints of a model brake, accelerate and are limited.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "robot/stopping/stop_offsets.h"
#include "robot/urdf/joint_ranges.h"
#include "world/model/model.h"

namespace link_bounds {

/// The rule of one joint. A mimic joint has a rule of its own: its limits, and the values that the
/// parameters do not give for it, come from the joint that it follows.
struct JointRule {
  const Joint* joint;
  Lead lead;                       ///< to the joint that it follows, or to itself
  const Joint* leader;             ///< the joint of `lead`
  Braking braking{0};              ///< deceleration 0: not known
  std::string why_no_stop;         ///< why its stopping distance is unknown, with the remedy, or ""
  std::string why_no_speed_limit;  ///< why its max speed is unknown, with the remedy, or ""
  std::optional<Limits> limits;
};

/// Made once per model, which must have a robot. Keeps the model alive.
class StopRules {
 public:
  explicit StopRules(std::shared_ptr<const Model> model);

  const Model& model() const { return *model_; }
  const JointRule& rule(std::size_t joint) const { return rules_[joint]; }

  /// The joint above a link of the robot; nothing for the root.
  std::optional<std::size_t> jointAbove(std::size_t link) const { return above_[link]; }

  /// The tf name of each link of the robot.
  const std::string& frameName(std::size_t link) const { return frames_[link]; }

  /// The link of the robot with that tf name.
  std::optional<std::size_t> linkOf(std::string_view frame) const;

  /// The rigid body of a link of the robot, and the one to which ~attached attaches an object.
  std::size_t bodyOfLink(std::size_t link) const { return bodies_.of_links[link]; }
  std::optional<std::size_t> bodyOfObject(const std::string& object) const {
    return bodyOf(*model_, {&object, std::nullopt});
  }

  Reaction reaction() const;

 private:
  std::shared_ptr<const Model> model_;
  std::vector<JointRule> rules_;
  std::vector<std::optional<std::size_t>> above_;
  std::vector<std::string> frames_;
  std::unordered_map<std::string_view, std::size_t> links_;  ///< by tf name
  RigidBodies bodies_;
};

}  // namespace link_bounds
