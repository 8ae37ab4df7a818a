// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Does the steps of the node, in record time.
#include "tools/bag_bounds/scene/recorded_scene.h"

#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <utility>

#include "node/inputs/checked_stream.h"
#include "tools/bag_bounds/scene/record_time.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"

namespace link_bounds {
namespace {

constexpr std::int64_t kTick = static_cast<std::int64_t>(SceneFeed::kTick * 1e9);

/// In a gap between two messages, ticks become rarer: the next one comes after the length of the
/// gap so far, divided by this. So a recorder's clock that jumps by thirty years costs only two
/// thousand ticks.
constexpr std::int64_t kTicksPerGap = 100;

constexpr std::size_t kMarkersPerGlance = 256;      // between two checks for an interrupt
constexpr std::int64_t kFirstTime = 1'000'000'000;  // ns
constexpr char kMarkerArray[] = "visualization_msgs/MarkerArray";
constexpr char kBoxArray[] = "link_bounds/AxisAlignedBoxArray";

void checkType(const BagMessage& message, std::initializer_list<const char*> types) {
  for (const char* type : types) {
    if (*message.type == type) return;
  }
  throw UsageError("the messages on " + *message.topic + " are of type " + *message.type +
                   ", not " + *types.begin() + "; name another topic or another bag");
}

/// Throws the exceptions of ros::serialization.
template <class Message>
void deserialize(const BagMessage& message, Message& result) {
  if (!readComplete(message.data, message.size, result)) ros::serialization::throwStreamOverrun();
}

void moveFromZero(std::vector<TransformView>& transforms) {
  for (TransformView& transform : transforms)
    transform.stamp = std::max(transform.stamp, kStampOfZero);
}

}  // namespace

RecordedScene::RecordedScene(LoadMesh load_mesh, OnNews on_news, OnStep on_step,
                             const std::string& tf_topic)
    : tf_topic_(tf_topic),
      static_topic_(tf_topic + "_static"),
      load_mesh_(std::move(load_mesh)),
      on_news_(std::move(on_news)),
      on_step_(std::move(on_step)),
      feed_({[this](const auto& request) { wanted_meshes_.push_back(request); },
             [this] { on_news_(now_); }},
            [this] { return passed(); }) {
  feed_.scene().objects.needPlaces();
}

/// Never 0, because 0 stands for "no jump".
ros::SteadyTime RecordedScene::passed() const {
  return ros::SteadyTime().fromNSec(static_cast<std::uint64_t>(kFirstTime + passed_));
}

void RecordedScene::adopt(std::shared_ptr<const Model> model, std::int64_t now) {
  now_ = now;
  next_tick_ = now + kTick;
  feed_.adopt(std::move(model), toRosTime(now));
}

bool RecordedScene::take(const BagMessage& message) {
  if (!passTo(message.time)) return false;
  try {
    const bool is_static = *message.topic == static_topic_;
    if (joints_ && *message.topic == joints_topic_) {
      takeJointState(message);
      ++transforms_;
    } else if (is_static || *message.topic == tf_topic_) {
      takeTransforms(message, is_static);
      ++transforms_;
    } else if (!takeObjects(message)) {
      return false;
    }
  } catch (const ros::Exception&) {
    ++damaged_;
  }
  on_step_(now_, false);
  return true;
}

/// If time goes back, a tick comes before the message, so that everybody sees tf after the jump.
bool RecordedScene::passTo(std::int64_t time) {
  const std::int64_t begin = now_;
  if (joints_ && goesBackTo(time)) joints_->forget();
  if (time < begin) {
    tick(time);
    next_tick_ = time + kTick;
  }
  while (next_tick_ < time) {
    if (isInterrupted()) return false;
    tick(next_tick_);
    next_tick_ += std::max(kTick, (next_tick_ - begin) / kTicksPerGap);
  }
  passed_ = std::min(passed_ + std::max<std::int64_t>(time - begin, 0), kMaxTime);
  now_ = time;
  return true;
}

void RecordedScene::tick(std::int64_t time) {
  now_ = time;
  feed_.onTick(toRosTime(time));
  feed_.forgetQuietFrames(passed());
  on_step_(time, true);
}

void RecordedScene::takeStatic(const BagMessage& message) {
  try {
    takeTransforms(message, true);
  } catch (const ros::Exception&) {
    ++damaged_;
  }
}

void RecordedScene::takeJoints(const std::string& topic, JointTransforms& joints) {
  joints_topic_ = topic;
  joints_ = &joints;
  feed_.onTransforms(
      joints.fixed(), true, [] { return std::string(); }, toRosTime(now_), passed());
}

/// Ignores positions of a message that has not one per name, as robot_state_publisher does. A
/// message without a stamp gets its record time.
void RecordedScene::takeJointState(const BagMessage& message) {
  checkType(message, {"sensor_msgs/JointState", ""});
  sensor_msgs::JointState state;
  deserialize(message, state);
  if (state.position.empty()) return;  // it has only velocities or efforts, which is common
  if (state.name.size() != state.position.size()) {
    ++unfit_;
    return;
  }
  const ros::Time now = toRosTime(now_);
  const ros::Time stamp = state.header.stamp.isZero() ? now : state.header.stamp;
  feed_.onTransforms(
      joints_->of(state, stamp), false, [&message] { return *message.publisher; }, now, passed());
}

void RecordedScene::takeTransforms(const BagMessage& message, bool is_static) {
  checkType(message, {"tf2_msgs/TFMessage", "tf/tfMessage", ""});
  tf_message_.read(message.data, message.size);
  if (!is_static) moveFromZero(tf_message_.transforms);
  feed_.onTransforms(
      tf_message_.transforms, is_static, [&message] { return *message.publisher; }, toRosTime(now_),
      passed());
}

/// Arrays of boxes are those of a neighbour, as for the node.
bool RecordedScene::takeObjects(const BagMessage& message) {
  checkType(message, {"visualization_msgs/Marker", kMarkerArray, kBoxArray});
  if (*message.type == kBoxArray) {
    AxisAlignedBoxArray boxes;
    deserialize(message, boxes);
    if (object_topics_.isOwn(boxes, *message.topic, *message.publisher))
      feed_.onNeighbour(boxes, {*message.publisher}, toRosTime(now_));
    return true;
  }
  const bool is_array = *message.type == kMarkerArray;
  visualization_msgs::MarkerArray array;
  if (is_array) {
    deserialize(message, array);
  } else {
    deserialize(message, array.markers.emplace_back());
  }
  object_topics_.keepOwn(array.markers, *message.topic, *message.publisher);
  return feedMarkers(array.markers, *message.publisher) && loadMeshes();
}

/// Feeds the markers in pieces, with checks for an interrupt, but as one update of the scene.
bool RecordedScene::feedMarkers(std::vector<visualization_msgs::Marker>& markers,
                                const std::string& publisher) {
  const ros::Time now = toRosTime(now_);
  feed_.setJoining(true);
  for (std::size_t begin = 0; begin < markers.size(); begin += kMarkersPerGlance) {
    if (isInterrupted()) return false;
    feed_.onMarkers(&markers[begin], std::min(kMarkersPerGlance, markers.size() - begin), publisher,
                    now);
  }
  feed_.setJoining(false);
  feed_.update(now);
  return true;
}

bool RecordedScene::loadMeshes() {
  for (const MeshRequest& request : std::exchange(wanted_meshes_, {})) {
    if (isInterrupted()) return false;
    feed_.onMesh(request, load_mesh_(request.uri), toRosTime(now_));
  }
  return true;
}

}  // namespace link_bounds
