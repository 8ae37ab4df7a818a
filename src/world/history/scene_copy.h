// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies in several steps the part of the scene that a request needs.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/bodies/scene.h"
#include "world/history/past_scene.h"

namespace link_bounds {

/// The constructor may run on any thread, the other functions only on the scene's thread.
class SceneCopy {
 public:
  SceneCopy(BoxRequest request, std::shared_ptr<const Model> model);

  /// Copies for about `budget`; true when the copy is complete. All calls must get the same scene,
  /// which may change in any way between them.
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
  std::vector<std::size_t> links_;  ///< indices in the model of the requested links
  std::vector<ObjectKey> keys_;     ///< of the objects that are requested by name
  std::vector<std::string> unknown_names_;
  std::vector<std::size_t> holders_;  ///< rigid body of each link; empty if nothing is attached
  std::unique_ptr<PastScene> past_;
  std::uint64_t epoch_ = 0;               ///< epoch of tf when PastScene::now was set
  std::size_t next_link_ = 0;             ///< in links_
  std::size_t next_key_ = 0;              ///< in keys_
  std::optional<ObjectKey> last_object_;  ///< the last one copied, if all are requested
  std::size_t next_frame_ = 0;            ///< index of the robot's link whose frame comes next
};

}  // namespace link_bounds
