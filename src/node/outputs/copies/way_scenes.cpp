// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The stop rules are computed once per model.
#include "node/outputs/copies/way_scenes.h"

#include <utility>

#include "world/history/past_boxes.h"
#include "world/stopping/body_ways.h"

namespace link_bounds {

std::optional<WayScenes::Copy> WayScenes::copy(Worker& worker) {
  const std::shared_ptr<const Model> model = scenes_.model();
  if (!model || !model->robot) return std::nullopt;
  std::unique_ptr<PastScene> scene = scenes_.copy(worker, wayRequest(model->parameters));
  if (!scene || !whyRefused(*scene).empty() || worker.isStopping() || !scene->model->robot)
    return std::nullopt;
  if (model_ != scene->model) {
    rules_.emplace(scene->model);
    model_ = scene->model;
  }
  const JointStates* states = nullptr;
  if (model_->parameters.joint_states)
    states = &joint_states_.read(scene->excerpt.epoch());
  else
    joint_states_.rest();
  return Copy{std::move(scene), &*rules_, states};
}

std::string WayScenes::problem() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return problem_;
}

void WayScenes::setProblem(std::string problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  problem_ = std::move(problem);
}

void WayScenes::rest() {
  joint_states_.rest();
  rules_.reset();
  model_.reset();
  setProblem("");
}

}  // namespace link_bounds
