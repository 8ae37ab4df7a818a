// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From what arrives to a scene and its output, in the order of the functions below.
#include "node/publisher_node.h"

#include <time.h>

#include <algorithm>

#include "node/log/guarded.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kTfQueue = 5000;
constexpr std::uint32_t kObjectsQueue = 1000;
constexpr std::size_t kManyObjects = 1000;  ///< so many together take a megabyte
const ros::WallDuration kTick(0.05);
const ros::WallDuration kDiagnosticsPeriod(1.0);

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
      output_(node_, private_node_, scene_,
              [this](const std::function<void()>& body) { timed(body); }),
      diagnostics_publisher_(
          node_.advertise<diagnostic_msgs::DiagnosticArray>(kDiagnosticsTopic.name, 10)) {
  tick_timer_ = node_.createWallTimer(
      kTick, [this](const ros::WallTimerEvent&) { timed([&] { onTick(); }); });
  diagnostics_timer_ = node_.createWallTimer(
      kDiagnosticsPeriod,
      [this](const ros::WallTimerEvent&) { timed([&] { publishDiagnostics(); }); });
  loader_ = std::make_unique<ModelLoader>(
      private_node_,
      [this](const ModelLoader::ModelPtr& model) {
        std::exception_ptr fault;
        timed([&] {
          try {
            adopt(model);
          } catch (...) {
            fault = std::current_exception();
          }
        });
        if (fault) std::rethrow_exception(fault);
      },
      [this](const std::string& uri, const LoadedMesh& mesh) {
        timed([&] { onMesh(uri, mesh); });
      });
  subscribe();
  subscribeToObjects();
  master_watch_ = std::make_unique<MasterWatch>();
}

void PublisherNode::subscribe() {
  tf_subscriber_ = subscribeToTf(kTfTopic, false);
  tf_static_subscriber_ = subscribeToTf(kTfStaticTopic, true);
}

/// Without tcpNoDelay small messages wait for each other in the kernel.
ros::Subscriber PublisherNode::subscribeToTf(const TopicName& topic, bool is_static) {
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const TfEvent&>(
      topic.name, kTfQueue,
      [this, is_static](const TfEvent& event) {
        health_.tf_callbacks_ms.add(timed([&] { onTransforms(event, is_static); }));
      },
      [&memory = is_static ? tf_static_memory_ : tf_memory_] { return memory.lend(); });
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return node_.subscribe(options);
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

void PublisherNode::adopt(ModelLoader::ModelPtr model) {
  model_ = std::move(model);
  const ros::Time now = ros::Time::now();
  tf_.distrustStampsAhead(now);
  refusal_log_.forget();
  scene_.links.adopt(model_, tf_, now);
  scene_.objects.adopt(model_->fixed_frame, model_->parameters.timeout, tf_, now);
  object_source_.reloadMeshes();
  output_.adopt();
}

void PublisherNode::onTransforms(const TfEvent& event, bool is_static) {
  const ros::Time now = ros::Time::now();
  observeClock(now);
  const auto is_late = [&](const TransformView& transform) {
    return clock_.isFromBeforeJump(transform.stamp, now);
  };
  const auto& transforms = event.getConstMessage()->transforms;
  if (!is_static && std::any_of(transforms.begin(), transforms.end(), is_late)) {
    std::vector<TransformView> kept;
    std::remove_copy_if(transforms.begin(), transforms.end(), std::back_inserter(kept), is_late);
    tf_.countDropped(transforms.size() - kept.size());
    addTransforms(kept, is_static, now, event);
  } else {
    addTransforms(transforms, is_static, now, event);
  }
  const bool links_changed = scene_.links.update(tf_, now);
  const bool objects_changed = scene_.objects.update(tf_, now);
  if (links_changed || objects_changed) onNews();
}

void PublisherNode::addTransforms(const std::vector<TransformView>& transforms, bool is_static,
                                  ros::Time now, const TfEvent& event) {
  for (const Refusal& refusal : tf_.add(transforms, is_static, now)) {
    const auto line =
        refusal_log_.line(std::string(transforms[refusal.index].child), refusal.reason,
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
  tf_memory_.giveBack();
  tf_static_memory_.giveBack();
  const std::size_t objects = scene_.objects.objects().size();
  most_objects_ = std::max(most_objects_, objects);
  if (most_objects_ < kManyObjects || objects > most_objects_ / 2) return;
  most_objects_ = objects;
  output_.freeSpareMemory();
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
  output_.request();
}

void PublisherNode::publishDiagnostics() {
  health_.publications = output_.publications();
  health_.waits_for_description = loader_->waitsForDescription();
  health_.waits_for_clock = clock_.isMissing();
  health_.clock_jumped = clock_.hasJustJumped();
  health_.intake = tf_.intake();
  health_.lag_ms = output_.takeLongestLag();
  const ros::SteadyTime now = ros::SteadyTime::now();
  const double seconds = (now - last_status_).toSec();
  health_.updates_per_second = static_cast<double>(health_.updates - last_updates_) / seconds;
  diagnostics_publisher_.publish(diagnose(scene_, health_));
  last_status_ = now;
  last_updates_ = health_.updates;
}

}  // namespace link_bounds
