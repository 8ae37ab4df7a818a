// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene that recorded messages move. All times are record times.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tools/bag_bounds/bag/bag_reader.h"
#include "tools/bag_bounds/scene/joint_transforms.h"
#include "tools/bag_bounds/scene/object_topics.h"
#include "tools/bag_bounds/scene/record_time.h"
#include "world/bodies/scene_feed.h"
#include "world/model/model.h"

namespace link_bounds {

class RecordedScene {
 public:
  /// Loads the mesh of an object.
  using LoadMesh = std::function<LoadedMesh(const std::string& uri)>;
  /// See SceneFeed::Handlers::on_news; `now` is the record time [ns].
  using OnNews = std::function<void(std::int64_t now)>;
  /// Called after each message and tick, at the record time [ns].
  using OnStep = std::function<void(std::int64_t now, bool is_tick)>;

  /// `tf_topic` has the moving transforms; static ones are on the same name with "_static".
  RecordedScene(LoadMesh load_mesh, OnNews on_news, OnStep on_step,
                const std::string& tf_topic = "/tf");

  /// Call it before the first message; `now` is the time of that message.
  void adopt(std::shared_ptr<const Model> model, std::int64_t now);

  /// Lets time pass up to the message, with the ticks on the way, then takes the message. False if
  /// it was interrupted: the message was taken in part or not at all, and no more messages may be
  /// taken. Throws UsageError if the topic has messages of a type that a scene does not take.
  bool take(const BagMessage& message);

  /// Takes the positions of joints on this topic as transforms, and the fixed joints at once. Call
  /// it before the first message. `joints` must outlive this.
  void takeJoints(const std::string& topic, JointTransforms& joints);

  /// Takes static transforms at once, whatever their topic and time. Do not call it after take().
  void takeStatic(const BagMessage& message);

  /// Lets time pass, with its ticks, without a message. False if it was interrupted on the way.
  bool passTo(std::int64_t time);

  std::int64_t now() const { return now_; }

  Scene& scene() { return feed_.scene(); }
  const Scene& scene() const { return feed_.scene(); }
  TransformBuffer& tf() { return feed_.tf(); }
  const TransformBuffer& tf() const { return feed_.tf(); }

  /// Number of messages with transforms or joint states that were taken.
  std::uint64_t transforms() const { return transforms_; }

  /// Whether a message at that time would make the clock jump back, and tf forget.
  bool goesBackTo(std::int64_t time) const { return feed_.clock().isJumpBack(toRosTime(time)); }

  /// Number of messages that could not be read.
  std::uint64_t damaged() const { return damaged_; }

  const ObjectTopics& objectTopics() const { return object_topics_; }

  /// Number of joint states that have not one position per name.
  std::uint64_t unfit() const { return unfit_; }

 private:
  ros::SteadyTime passed() const;
  void tick(std::int64_t time);
  void takeTransforms(const BagMessage& message, bool is_static);
  void takeJointState(const BagMessage& message);
  bool takeObjects(const BagMessage& message);
  bool feedMarkers(std::vector<visualization_msgs::Marker>& markers, const std::string& publisher);
  bool loadMeshes();

  const std::string tf_topic_;
  const std::string static_topic_;
  std::string joints_topic_;
  JointTransforms* joints_ = nullptr;
  LoadMesh load_mesh_;
  OnNews on_news_;
  OnStep on_step_;
  std::int64_t now_ = 0;        ///< record time [ns]
  std::int64_t next_tick_ = 0;  ///< record time [ns]
  std::int64_t passed_ = 0;     ///< sum of the forward steps of record time [ns]
  SceneFeed feed_;
  ObjectTopics object_topics_{feed_.scene().objects};
  TfMessage tf_message_;
  std::vector<MeshRequest> wanted_meshes_;
  std::uint64_t transforms_ = 0;
  std::uint64_t damaged_ = 0;
  std::uint64_t unfit_ = 0;
};

}  // namespace link_bounds
