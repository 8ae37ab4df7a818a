// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies what a request needs of the scene, in pieces.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/bodies/scene.h"
#include "world/history/past_scene.h"

namespace link_bounds {

/// Made on any thread. The other functions are for the thread that owns the scene.
class SceneCopy {
 public:
  SceneCopy(BoxRequest request, std::shared_ptr<const Model> model);

  /// Copies for about that time; true when everything is there. It must always be the same scene;
  /// between two calls it may change in any way.
  bool proceed(const Scene& scene, ros::Time now, std::chrono::nanoseconds budget);

  /// After proceed() returned true.
  std::unique_ptr<PastScene> take() { return std::move(past_); }

 private:
  void findNames();
  void begin(const Scene& scene, ros::Time now);
  void observeEpoch(const TransformBuffer& tf, ros::Time now);
  bool copyNext(const Scene& scene);
  bool copyNextBody(const Scene& scene);
  void copyFrame(const Scene& scene, const Link& link);
  void copyLink(const Scene& scene, std::size_t link);
  void copyObject(const Scene& scene, const LiveObject& object);
  bool isNeighbourElsewhere(const Scene& scene, const LiveObject& object) const;
  bool isHeldSince(const Scene& scene, const LiveObject& object) const;
  std::optional<HeldPlace> heldPlace(const Scene& scene, const PastBody& body) const;

  BoxRequest request_;
  std::shared_ptr<const Model> model_;
  std::vector<std::size_t> links_;  ///< that are asked for
  std::vector<ObjectKey> keys_;     ///< of the objects that are asked for by name
  std::vector<std::string> unknown_names_;
  std::vector<std::size_t> holders_;  ///< rigid body of each link; empty if nothing is attached
  std::unique_ptr<PastScene> past_;
  std::uint64_t epoch_ = 0;               ///< of tf, to which PastScene::now belongs
  std::size_t next_link_ = 0;             ///< in links_
  std::size_t next_key_ = 0;              ///< in keys_
  std::optional<ObjectKey> last_object_;  ///< if all are asked for
  std::size_t next_frame_ = 0;            ///< of the links of the robot
};

}  // namespace link_bounds
