// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the node does between receiving and sending, stage by stage.
#pragma once

#include <array>
#include <memory>

#include "bench/pipeline/pipelines.h"
#include "world/bodies/scene.h"
#include "world/model/model.h"
#include "world/tf/tf_message.h"

namespace link_bounds::bench {

/// A robot whose links share the meshes; one group has all of them.
std::shared_ptr<const Model> modelOf(const TfRobot& robot, const MeasuredMeshes& meshes);

/// Not copyable: its scene refers to its transforms.
class NodeUpdate {
 public:
  explicit NodeUpdate(const std::shared_ptr<const Model>& model);
  NodeUpdate(const NodeUpdate&) = delete;
  NodeUpdate& operator=(const NodeUpdate&) = delete;

  struct Stage {
    const char* name;
    void (NodeUpdate::*run)(Bytes& bytes, ros::Time now);
  };

  /// One update is all of them in this order. None is inlined, so that a profiler sees them.
  static const std::array<Stage, 7> kStages;

  /// The first two stages.
  void receive(Bytes& bytes, ros::Time now);

  /// All stages. Throws if a box is missing or old.
  void answer(Bytes& bytes, ros::Time now);

  const AxisAlignedBoxArray& boxes() const { return boxes_; }

 private:
  void readMessage(Bytes& bytes, ros::Time now);
  void insertTransforms(Bytes& bytes, ros::Time now);
  void updatePoses(Bytes& bytes, ros::Time now);
  void updateBoxes(Bytes& bytes, ros::Time now);
  void updateObjects(Bytes& bytes, ros::Time now);
  void fillBoxMessage(Bytes& bytes, ros::Time now);
  void fillGroupMessage(Bytes& bytes, ros::Time now);

  TfMessage message_;
  TransformBuffer tf_;
  Scene scene_{tf_};
  bool is_changed_ = false;
  AxisAlignedBoxArray boxes_;
  AxisAlignedBoxArray groups_;
};

}  // namespace link_bounds::bench
