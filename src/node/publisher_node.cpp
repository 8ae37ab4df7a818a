// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From a tf message to what is published, in the order of the functions below.
#include "publisher_node.h"

#include <ros/single_subscriber_publisher.h>
#include <time.h>

#include <algorithm>

#include "box_message.h"
#include "footprint.h"
#include "guarded.h"
#include "topics.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kTfQueue = 5000;
constexpr std::uint32_t kObjectsQueue = 1000;
constexpr std::size_t kManyObjects = 1000;  ///< so many together take a megabyte
/// Per subscriber that does not keep up; beside them the kernel buffers about as much again. It
/// must bridge a moment of a busy machine and bounds the memory that a stopped subscriber costs us.
constexpr std::uint32_t kBoxesQueue = 200;
constexpr std::uint32_t kMarkersQueue = 10;
constexpr std::uint32_t kFootprintQueue = 10;
const ros::WallDuration kTick(0.05);
const ros::WallDuration kDiagnosticsPeriod(1.0);

/// The union of all links: the first group of every model.
BoxState robotState(const Scene& scene) {
  return groupState(scene.model()->groups.front(), scene);
}

std::string privateName(const TopicName& topic) {
  return topic.name + 1;
}

double threadCpuMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

}  // namespace

template <class Body>
double PublisherNode::timed(Body&& body) {
  const ros::SteadyTime start = ros::SteadyTime::now();
  const double start_cpu = threadCpuMilliseconds();
  guarded(body);
  const double wall = (ros::SteadyTime::now() - start).toSec() * 1e3;
  health_.longest_callback_ms = std::max(health_.longest_callback_ms, wall);
  health_.longest_callback_cpu_ms =
      std::max(health_.longest_callback_cpu_ms, threadCpuMilliseconds() - start_cpu);
  return wall;
}

PublisherNode::PublisherNode()
    : object_source_(scene_.objects, [this](const std::string& uri) { loader_->requestMesh(uri); }),
      boxes_output_(node_, [this] { publishBoxes(); }),
      markers_output_(node_, [this] { publishMarkers(); }) {
  advertise();
  tick_timer_ = node_.createWallTimer(
      kTick, [this](const ros::WallTimerEvent&) { timed([&] { onTick(); }); });
  diagnostics_timer_ = node_.createWallTimer(
      kDiagnosticsPeriod,
      [this](const ros::WallTimerEvent&) { timed([&] { publishDiagnostics(); }); });
  loader_ = std::make_unique<ModelLoader>(
      private_node_,
      [this](ModelLoader::ModelPtr model) {
        timed([&] { model = adopt(std::move(model)); });
        return model;
      },
      [this](const std::string& uri, const LoadedMesh& mesh) {
        timed([&] { onMesh(uri, mesh); });
      });
  subscribe();
  subscribeToObjects();
  master_watch_ = std::make_unique<MasterWatch>();
}

void PublisherNode::advertise() {
  boxes_publisher_ =
      private_node_.advertise<AxisAlignedBoxArray>(privateName(kBoxesTopic), kBoxesQueue, true);
  groups_publisher_ =
      private_node_.advertise<AxisAlignedBoxArray>(privateName(kGroupsTopic), kBoxesQueue, true);
  markers_publisher_ = private_node_.advertise<visualization_msgs::MarkerArray>(
      privateName(kMarkersTopic), kMarkersQueue,
      [this](const ros::SingleSubscriberPublisher& subscriber) {
        timed([&] { welcome(subscriber); });
      });
  parts_publisher_ = private_node_.advertise<AxisAlignedBoxArray>(
      privateName(kPartsTopic), kBoxesQueue,
      [this](const ros::SingleSubscriberPublisher& subscriber) {
        timed([&] { welcomeToParts(subscriber); });
      });
  footprint_publisher_ = private_node_.advertise<geometry_msgs::Polygon>(
      privateName(kFootprintTopic), kFootprintQueue,
      [this](const ros::SingleSubscriberPublisher& subscriber) {
        timed([&] { welcomeToFootprint(subscriber); });
      });
  overlaps_publisher_ = private_node_.advertise<BoxOverlapArray>(
      privateName(kOverlapsTopic), kBoxesQueue,
      [this](const ros::SingleSubscriberPublisher& subscriber) {
        timed([&] { welcomeToOverlaps(subscriber); });
      });
  diagnostics_publisher_ =
      node_.advertise<diagnostic_msgs::DiagnosticArray>(kDiagnosticsTopic.name, 10);
}

/// Without tcpNoDelay small messages wait for each other in the kernel.
void PublisherNode::subscribe() {
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  tf_subscriber_ = node_.subscribe<tf2_msgs::TFMessage, const TfEvent&>(
      kTfTopic.name, kTfQueue,
      [this](const TfEvent& event) {
        health_.tf_callbacks_ms.add(timed([&] { onTransforms(event, false); }));
      },
      {}, no_delay);
  tf_static_subscriber_ = node_.subscribe<tf2_msgs::TFMessage, const TfEvent&>(
      kTfStaticTopic.name, kTfQueue,
      [this](const TfEvent& event) {
        health_.tf_callbacks_ms.add(timed([&] { onTransforms(event, true); }));
      },
      {}, no_delay);
}

void PublisherNode::subscribeToObjects() {
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  objects_subscriber_ =
      private_node_.subscribe<visualization_msgs::MarkerArray, const MarkersEvent&>(
          privateName(kObjectsTopic), kObjectsQueue,
          [this](const MarkersEvent& event) { timed([&] { onMarkers(event); }); }, {}, no_delay);
  object_subscriber_ = private_node_.subscribe<visualization_msgs::Marker, const MarkerEvent&>(
      privateName(kObjectTopic), kObjectsQueue,
      [this](const MarkerEvent& event) { timed([&] { onMarker(event); }); }, {}, no_delay);
}

ModelLoader::ModelPtr PublisherNode::adopt(ModelLoader::ModelPtr model) {
  std::swap(model, model_);
  boxes_output_.setRate(model_->parameters.max_rate);
  markers_output_.setRate(model_->parameters.marker_rate);
  const ros::Time now = ros::Time::now();
  tf_.distrustStampsAhead(now);
  refusal_log_.forget();
  scene_.links.adopt(model_, tf_, now);
  parts_.adopt(*model_);
  scene_.objects.adopt(model_->fixed_frame, model_->parameters.timeout, tf_, now);
  object_source_.reloadMeshes();
  boxes_output_.emitNow();
  markers_output_.request();
  return model;
}

void PublisherNode::onTransforms(const TfEvent& event, bool is_static) {
  const ros::Time now = ros::Time::now();
  observeClock(now);
  const auto is_late = [&](const geometry_msgs::TransformStamped& transform) {
    return clock_.isFromBeforeJump(transform.header.stamp, now);
  };
  const auto& transforms = event.getConstMessage()->transforms;
  if (!is_static && std::any_of(transforms.begin(), transforms.end(), is_late)) {
    std::vector<geometry_msgs::TransformStamped> kept;
    std::remove_copy_if(transforms.begin(), transforms.end(), std::back_inserter(kept), is_late);
    addTransforms(kept, is_static, now, event);
  } else {
    addTransforms(transforms, is_static, now, event);
  }
  const bool links_changed = scene_.links.update(tf_, now);
  const bool objects_changed = scene_.objects.update(tf_, now);
  if (links_changed || objects_changed) onNews();
}

void PublisherNode::addTransforms(const std::vector<geometry_msgs::TransformStamped>& transforms,
                                  bool is_static, ros::Time now, const TfEvent& event) {
  for (const Refusal& refusal : tf_.add(transforms, is_static, now)) {
    const auto line = refusal_log_.line(transforms[refusal.index].child_frame_id, refusal.reason,
                                        event.getPublisherName(), ros::SteadyTime::now());
    if (line) ROS_WARN_STREAM(*line);
  }
}

void PublisherNode::onTick() {
  const ros::Time now = ros::Time::now();
  observeClock(now);
  const bool links_changed = scene_.links.expire(tf_, now);
  const bool objects_changed = scene_.objects.expire(tf_, now);
  object_source_.warnOfGivenUp();
  watchMemory();
  if (links_changed || objects_changed) onNews();
  if (clock_.isMissing()) {
    ROS_WARN_STREAM_ONCE("use_sim_time is set but nobody publishes /clock; waiting for it");
  }
}

/// Many objects that are gone leave holes all over the heap.
void PublisherNode::watchMemory() {
  const std::size_t objects = scene_.objects.objects().size();
  most_objects_ = std::max(most_objects_, objects);
  if (most_objects_ < kManyObjects || objects > most_objects_ / 2) return;
  most_objects_ = objects;
  overlaps_ = SceneOverlaps();
  overlaps_message_ = BoxOverlapArray();
  loader_->giveBackMemory();
}

void PublisherNode::observeClock(ros::Time now) {
  switch (clock_.observe(now)) {
    case ClockWatch::Event::kNone:
      return;
    case ClockWatch::Event::kStarted:
      tf_.tree().clockStarted(static_cast<std::int64_t>(now.toNSec()));
      if (scene_.objects.restart(tf_, now)) onNews();
      return;
    case ClockWatch::Event::kJumpedBack: {
      ROS_WARN("the clock jumped back; forgetting all transforms that are not static");
      tf_.clear();
      const bool links_changed = scene_.links.updateAll(tf_, now);
      const bool objects_changed = scene_.objects.restart(tf_, now);
      if (links_changed || objects_changed) onNews();
      return;
    }
  }
}

/// All markers of one message lead to one publication.
void PublisherNode::onMarkers(const MarkersEvent& event) {
  const ros::Time now = ros::Time::now();
  observeClock(now);
  bool is_changed = false;
  for (visualization_msgs::Marker& marker : event.getMessage()->markers)
    is_changed |= object_source_.take(std::move(marker), event.getPublisherName(), tf_, now);
  if (is_changed) onNews();
}

void PublisherNode::onMarker(const MarkerEvent& event) {
  const ros::Time now = ros::Time::now();
  observeClock(now);
  visualization_msgs::Marker& marker = *event.getMessage();
  if (object_source_.take(std::move(marker), event.getPublisherName(), tf_, now)) onNews();
}

void PublisherNode::onMesh(const std::string& uri, const LoadedMesh& mesh) {
  if (object_source_.fillMesh(uri, mesh, tf_, ros::Time::now())) onNews();
}

/// Nothing to publish before the first model.
void PublisherNode::onNews() {
  if (!scene_.model()) return;
  ++health_.updates;
  boxes_output_.request();
  if (markers_publisher_.getNumSubscribers() > 0) markers_output_.request();
}

void PublisherNode::publishBoxes() {
  ++health_.publications;
  fillBoxes(scene_, boxes_message_);
  fillGroups(scene_, groups_message_);
  boxes_publisher_.publish(boxes_message_);
  groups_publisher_.publish(groups_message_);
  publishParts();
  publishFootprint();
  publishOverlaps();
}

void PublisherNode::publishParts() {
  if (!parts_.areWanted() || parts_publisher_.getNumSubscribers() == 0) return;
  parts_.fill(scene_.links, parts_message_);
  parts_publisher_.publish(parts_message_);
}

void PublisherNode::welcomeToParts(const ros::SingleSubscriberPublisher& subscriber) {
  if (!parts_.areWanted()) return;
  parts_.fill(scene_.links, parts_message_);
  subscriber.publish(parts_message_);
}

void PublisherNode::publishFootprint() {
  if (footprint_publisher_.getNumSubscribers() == 0) return;
  if (const auto footprint = footprintOf(robotState(scene_))) {
    footprint_publisher_.publish(*footprint);
  }
}

void PublisherNode::welcomeToFootprint(const ros::SingleSubscriberPublisher& subscriber) {
  if (!scene_.model()) return;
  if (const auto footprint = footprintOf(robotState(scene_))) subscriber.publish(*footprint);
}

void PublisherNode::publishOverlaps() {
  if (overlaps_publisher_.getNumSubscribers() == 0) return;
  overlaps_message_.header = boxes_message_.header;
  overlaps_.fill(scene_, overlaps_message_);
  overlaps_publisher_.publish(overlaps_message_);
}

void PublisherNode::welcomeToOverlaps(const ros::SingleSubscriberPublisher& subscriber) {
  if (!scene_.model()) return;
  overlaps_message_.header = headerOf(scene_);
  overlaps_.fill(scene_, overlaps_message_);
  subscriber.publish(overlaps_message_);
}

void PublisherNode::publishMarkers() {
  if (markers_publisher_.getNumSubscribers() == 0) return;
  const std_msgs::Header header = headerOf(scene_);
  visualization_msgs::MarkerArray markers = boxMarkers(scene_, header);
  shown_.replaceBy(markers, header);
  markers_publisher_.publish(markers);
}

/// A new subscriber to the markers is shown everything at once.
void PublisherNode::welcome(const ros::SingleSubscriberPublisher& subscriber) {
  if (!scene_.model()) return;
  const std_msgs::Header header = headerOf(scene_);
  visualization_msgs::MarkerArray markers = boxMarkers(scene_, header);
  shown_.extendBy(markers, header);
  subscriber.publish(markers);
}

void PublisherNode::publishDiagnostics() {
  health_.waits_for_description = loader_->waitsForDescription();
  health_.waits_for_clock = clock_.isMissing();
  health_.clock_jumped = clock_.hasJustJumped();
  diagnostics_publisher_.publish(diagnose(scene_, health_));
}

}  // namespace link_bounds
