// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The update thread copies in short pieces. Between two pieces it handles the callbacks that wait.
#include "node/outputs/copies/scene_copier.h"

#include <utility>

namespace link_bounds {
namespace {

/// The max time of a piece: about the time of one update of 200 links.
constexpr std::chrono::microseconds kPiece(50);

}  // namespace

void SceneCopier::adopt(std::shared_ptr<const Model> model) {
  const std::lock_guard<std::mutex> lock(mutex_);
  model_ = std::move(model);
}

std::shared_ptr<const Model> SceneCopier::model() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return model_;
}

std::unique_ptr<PastScene> SceneCopier::copy(Worker& worker, const BoxRequest& request,
                                             Time deadline) const {
  SceneCopy copy(request, model());
  const auto piece = [&] {
    bool is_complete = false;
    measure_([&] { is_complete = copy.proceed(scene_, ros::Time::now(), kPiece); });
    return is_complete;
  };
  if (!worker.await(update_queue_, piece, deadline)) return nullptr;
  return copy.take();
}

}  // namespace link_bounds
