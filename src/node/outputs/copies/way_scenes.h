// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The inputs of ~stopping and ~earliest: a copy of the scene, the limits on joint motion, and
// joint_states.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "node/inputs/joint_state_receiver.h"
#include "node/outputs/copies/scene_copier.h"
#include "world/stopping/stop_rules.h"

namespace link_bounds {

/// Used by the thread of one worker only; problem() may be called on any thread.
class WayScenes {
 public:
  explicit WayScenes(const SceneCopier& scenes) : scenes_(scenes) {}

  struct Copy {
    std::unique_ptr<PastScene> scene;
    const StopRules* rules;     ///< valid until the next copy()
    const JointStates* states;  ///< valid until the next copy(); null unless the parameter
                                ///< joint_states is set
  };

  /// nullopt if there is no robot, if no boxes can be computed for the scene, or if the worker is
  /// stopping.
  std::optional<Copy> copy(Worker& worker);

  /// Why a body of the last copy is incomplete; "" if all are complete, and after rest().
  std::string problem() const;
  void setProblem(std::string problem);

  /// Call when the last subscriber has gone: frees the rules and unsubscribes from joint_states.
  void rest();

 private:
  const SceneCopier& scenes_;
  JointStateReceiver joint_states_;
  std::shared_ptr<const Model> model_;
  std::optional<StopRules> rules_;  ///< rules of model_
  mutable std::mutex mutex_;
  std::string problem_;  ///< guarded by mutex_
};

}  // namespace link_bounds
