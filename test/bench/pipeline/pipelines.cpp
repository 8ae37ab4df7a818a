// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All of them work on the thread that calls them.
#include "bench/pipeline/pipelines.h"

#include <boost/make_shared.hpp>

#include "bench/common/usual_tf2.h"
#include "bench/pipeline/node_update.h"
#include "bench/pipeline/tf2_pipelines.h"

namespace link_bounds::bench {
namespace {

class Deserialize : public Pipeline {
 public:
  void receive(Bytes& bytes, ros::Time) override { deserialize(bytes, message_); }
  void answer(Bytes& bytes, ros::Time) override { deserialize(bytes, message_); }

 private:
  tf2_msgs::TFMessage message_;
};

class Relay : public Pipeline {
 public:
  explicit Relay(const TfRobot& robot) {
    answer_.header.frame_id = robot.base;
    for (const std::string& link : robot.links) {
      answer_.boxes.emplace_back();
      answer_.boxes.back().name = link;
    }
  }

  void receive(Bytes&, ros::Time) override {}

  void answer(Bytes& bytes, ros::Time) override {
    const auto message = boost::make_shared<tf2_msgs::TFMessage>();
    deserialize(bytes, *message);
    answer_.header.stamp = message->transforms.back().header.stamp;
    for (AxisAlignedBox& box : answer_.boxes)
      box.stamp = answer_.header.stamp;
  }

 private:
  AxisAlignedBoxArray answer_;
};

class UsualTf2 : public Pipeline {
 public:
  UsualTf2(const TfRobot& robot, const MeasuredMeshes& meshes) : base_(robot.base) {
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      links_.push_back({robot.links[i], Aabb()});
      for (const Eigen::Vector3f& vertex : meshes[i % meshes.size()].mesh.vertices)
        links_.back().resting.extend(vertex.cast<double>());
    }
  }

  void receive(Bytes& bytes, ros::Time) override {
    const auto message = boost::make_shared<tf2_msgs::TFMessage>();
    deserialize(bytes, *message);
    for (const geometry_msgs::TransformStamped& transform : message->transforms)
      buffer_.setTransform(transform, "/robot_state_publisher");
  }

  void answer(Bytes& bytes, ros::Time now) override {
    receive(bytes, now);
    const auto markers = usualMarkers(buffer_, base_, links_);
    if (markers.markers.size() != links_.size()) throw std::runtime_error("tf2 lacks a link");
  }

 private:
  std::string base_;
  std::vector<UsualLink> links_;
  tf2::BufferCore buffer_;
};

class Ours : public Pipeline {
 public:
  explicit Ours(const std::shared_ptr<const Model>& model) : update_(model) {}

  void receive(Bytes& bytes, ros::Time now) override { update_.receive(bytes, now); }
  void answer(Bytes& bytes, ros::Time now) override { update_.answer(bytes, now); }
  const AxisAlignedBoxArray* boxes() const override { return &update_.boxes(); }

 private:
  NodeUpdate update_;
};

}  // namespace

std::vector<NamedPipeline> makePipelines(const TfRobot& robot, const MeasuredMeshes& meshes) {
  const std::shared_ptr<const Model> model = modelOf(robot, meshes);
  std::vector<NamedPipeline> result;
  const auto add = [&result](const char* method, bool moves, std::unique_ptr<Pipeline> pipeline) {
    result.push_back({method, moves, std::move(pipeline)});
  };
  add("deserialize", true, std::make_unique<Deserialize>());
  add("relay", true, std::make_unique<Relay>(robot));
  add("ours", true, std::make_unique<Ours>(model));
  add("ours_standing", false, std::make_unique<Ours>(model));
  add("time_cache", true, makeTimeCachePipeline(robot, *model));
  add("buffer_core", true, makeBufferCorePipeline(robot, *model));
  add("usual_tf2", true, std::make_unique<UsualTf2>(robot, meshes));
  return result;
}

}  // namespace link_bounds::bench
