// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two storages with the same interface below one computation.
#include "bench/pipeline/tf2_pipelines.h"

#include <tf2/buffer_core.h>
#include <tf2/time_cache.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <stdexcept>

#include "node/outputs/messages/box_message.h"
#include "world/tf/frame_names.h"
#include "world/tf/tf_message.h"

namespace link_bounds::bench {
namespace {

struct StampedEdge {
  Tf2Pose parent_from_child;
  ros::Time stamp;
};

class BufferCoreEdges {
 public:
  explicit BufferCoreEdges(const TfRobot& robot) : parents_(robot.parents), frames_(robot.frames) {}

  void receive(Bytes& bytes) {
    const auto message = boost::make_shared<tf2_msgs::TFMessage>();
    deserialize(bytes, *message);
    for (const geometry_msgs::TransformStamped& transform : message->transforms)
      buffer_.setTransform(transform, "/robot_state_publisher");
  }

  StampedEdge latest(std::size_t i) const {
    const auto transform = buffer_.lookupTransform(parents_[i], frames_[i], ros::Time(0));
    return {TransformView(transform).parent_from_child, transform.header.stamp};
  }

 private:
  std::vector<std::string> parents_;
  std::vector<std::string> frames_;
  tf2::BufferCore buffer_;
};

class TimeCacheEdges {
 public:
  explicit TimeCacheEdges(const TfRobot& robot) : caches_(robot.frames.size() + 1) {
    for (const std::string& frame : robot.frames)
      edges_.push_back(names_.frame(frame));
    names_.frame(robot.base);
  }

  void receive(Bytes& bytes) {
    deserialize(bytes, message_);
    names_.beginMessage();
    for (const TransformView& transform : message_.transforms) {
      const auto [child, parent] = names_.next(transform.parent, transform.child, transform.names);
      tf2::TransformStorage storage;
      storage.stamp_ = transform.stamp;
      storage.frame_id_ = static_cast<tf2::CompactFrameID>(parent);
      storage.child_frame_id_ = static_cast<tf2::CompactFrameID>(child);
      storage.rotation_ = transform.parent_from_child.rotation();
      storage.translation_ = transform.parent_from_child.translation();
      caches_[child].insertData(storage);
    }
  }

  StampedEdge latest(std::size_t i) {
    tf2::TransformStorage storage;
    if (!caches_[edges_[i]].getData(ros::Time(0), storage)) throw std::runtime_error("no data");
    return {{storage.rotation_, storage.translation_}, storage.stamp_};
  }

 private:
  TfMessage message_;
  FrameNames names_;
  std::vector<FrameNames::Frame> edges_;
  std::vector<tf2::TimeCache> caches_;
};

template <class Edges>
class ComposingPipeline : public Pipeline {
 public:
  ComposingPipeline(const TfRobot& robot, const Model& model)
      : edges_(robot),
        model_(model),
        poses_(robot.frames.size()),
        states_(model.links.size()),
        link_boxes_(model.links) {
    for (const std::string& parent : robot.parents) {
      const auto found = std::find(robot.frames.begin(), robot.frames.end(), parent);
      parents_.push_back(static_cast<std::size_t>(found - robot.frames.begin()));
    }
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      moved_.push_back({i, &poses_[firstLink() + i].affine});
      states_[i].incomplete = false;
    }
  }

  void receive(Bytes& bytes, ros::Time) override { edges_.receive(bytes); }

  void answer(Bytes& bytes, ros::Time now) override {
    receive(bytes, now);
    place();
    link_boxes_.update(moved_);
    BoxFiller boxes(boxes_, model_.fixed_frame);
    for (std::size_t i = 0; i < states_.size(); ++i) {
      states_[i].box = link_boxes_.box(i);
      boxes.add(model_.links[i].name, states_[i]);
    }
    boxes.finish();
    BoxFiller groups(groups_, model_.fixed_frame);
    for (const SceneGroup& group : model_.groups)
      groups.add(group.name, groupState(group, states_));
    groups.finish();
  }

  const AxisAlignedBoxArray* boxes() const override { return &boxes_; }

 private:
  /// Its pose among those of all frames; only the last frames are links.
  std::size_t firstLink() const { return poses_.size() - model_.links.size(); }

  void place() {
    const MatrixPose base;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const StampedEdge edge = edges_.latest(i);
      const bool is_on_base = parents_[i] == poses_.size();
      poses_[i].setProduct(is_on_base ? base : poses_[parents_[i]], edge.parent_from_child);
      if (i >= firstLink())
        states_[i - firstLink()].stamp = static_cast<std::int64_t>(edge.stamp.toNSec());
    }
  }

  Edges edges_;
  const Model model_;
  std::vector<std::size_t> parents_;  ///< places of the parents' poses; past the end: the base
  std::vector<MatrixPose> poses_;     ///< of all frames, parents first
  std::vector<BoxState> states_;
  LinkBoxes link_boxes_;
  std::vector<MovedLink> moved_;
  AxisAlignedBoxArray boxes_;
  AxisAlignedBoxArray groups_;
};

}  // namespace

std::unique_ptr<Pipeline> makeBufferCorePipeline(const TfRobot& robot, const Model& model) {
  return std::make_unique<ComposingPipeline<BufferCoreEdges>>(robot, model);
}

std::unique_ptr<Pipeline> makeTimeCachePipeline(const TfRobot& robot, const Model& model) {
  return std::make_unique<ComposingPipeline<TimeCacheEdges>>(robot, model);
}

}  // namespace link_bounds::bench
