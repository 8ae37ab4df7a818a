// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What outputs need that look ahead: the scene, how its joints may move, and /joint_states.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "node/inputs/joint_state_receiver.h"
#include "node/outputs/copies/scene_copier.h"
#include "world/stopping/stop_rules.h"

namespace link_bounds {

/// Only the thread of one worker may use it; any thread may call problem().
class WayScenes {
 public:
  explicit WayScenes(const SceneCopier& scenes) : scenes_(scenes) {}

  struct Copy {
    std::unique_ptr<PastScene> scene;
    const StopRules* rules;     ///< until the next copy()
    const JointStates* states;  ///< until the next copy(); null without the parameter joint_states
  };

  /// Nothing if there is no robot, if the scene has no answer, or if the worker is stopping.
  std::optional<Copy> copy(Worker& worker);

  /// Why a body of the last copy is incomplete; "" if none is, or after rest().
  std::string problem() const;
  void setProblem(std::string problem);

  /// To be called when nobody listens any more.
  void rest();

 private:
  const SceneCopier& scenes_;
  JointStateReceiver joint_states_;
  std::shared_ptr<const Model> model_;
  std::optional<StopRules> rules_;  ///< of the model
  mutable std::mutex mutex_;
  std::string problem_;  ///< guarded by mutex_
};

}  // namespace link_bounds
