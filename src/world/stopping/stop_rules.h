// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a model says about how its joints brake.
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

/// How a joint may move on. A joint that mimics another one counts as independent. Its limits and
/// its max speed come from its leader, and so do values that the parameters do not set for it.
struct JointRule {
  const Joint* joint;
  Lead lead;                       ///< how it follows its leader
  const Joint* leader;             ///< the joint that it mimics, or itself
  Braking braking{0};              ///< deceleration 0: not known
  std::string why_no_stop;         ///< why its stopping distance is not known, with the remedy
  std::string why_no_speed_limit;  ///< why its max speed is not known, with the remedy
  std::optional<Limits> limits;
};

/// Made once per model, which it keeps alive. The model must have a robot.
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

  /// The rigid body of a link of the robot, and that to which the parameters attach an object.
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
