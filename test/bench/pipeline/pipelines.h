// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ways from the bytes of a TFMessage to an answer; what a node does between receiving and sending.
#pragma once

#include <link_bounds/AxisAlignedBoxArray.h>
#include <ros/serialization.h>

#include <memory>
#include <string>
#include <vector>

#include "bench/common/measured_mesh.h"
#include "bench/common/tf_robot.h"
#include "world/model/model.h"

namespace link_bounds::bench {

using Bytes = std::vector<std::uint8_t>;

class Pipeline {
 public:
  virtual ~Pipeline() = default;

  /// Takes the transforms and computes nothing; to fill histories.
  virtual void receive(Bytes& bytes, ros::Time now) = 0;

  /// Receives and answers.
  virtual void answer(Bytes& bytes, ros::Time now) = 0;

  /// The last answer if it is exact, else null.
  virtual const AxisAlignedBoxArray* boxes() const { return nullptr; }
};

template <class Message>
void deserialize(Bytes& bytes, Message& message) {
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, message);
}

struct NamedPipeline {
  std::string method;
  bool moves = true;  ///< whether it is fed with a robot that moves
  std::unique_ptr<Pipeline> pipeline;
};

/// `deserialize`: into a message that is used again. `relay`: a fresh message, as roscpp makes it,
/// answered by stamps in an AxisAlignedBoxArray of as many boxes. `usual_tf2`: a fresh message,
/// tf2, loose boxes in a fresh MarkerArray. `ours`: the node from its subscription to the filled
/// ~boxes and ~groups; `ours_standing` the same for a robot that only sends new stamps. The others
/// are those of tf2_pipelines.h.
std::vector<NamedPipeline> makePipelines(const TfRobot& robot, const MeasuredMeshes& meshes);

}  // namespace link_bounds::bench
