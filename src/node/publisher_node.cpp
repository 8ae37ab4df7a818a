// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From what arrives to a scene and its output, in the order of the functions below.
#include "node/publisher_node.h"

#include "node/distances/object_body.h"
#include "node/log/guarded.h"
#include "node/log/log_text.h"
#include "node/names/topics.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kObjectsQueue = 1000;
const ros::WallDuration kTick(0.05);
const ros::WallDuration kLostFramesPeriod(0.5);
const ros::WallDuration kDiagnosticsPeriod(1.0);

}  // namespace

void PublisherNode::guard(const std::function<void()>& body) {
  guarded([&] { times_.measure(body); });
}

PublisherNode::PublisherNode()
    : object_source_(scene_.objects, [this](const std::string& uri) { loader_->requestMesh(uri); }),
      output_(
          node_, private_node_, scene_, [this](const std::function<void()>& body) { guard(body); },
          treeRequests()),
      diagnostics_(node_),
      tf_receiver_(node_,
                   [this](const TfReceiver::Event& event, bool is_static) {
                     times_.measureTf([&] { guarded([&] { onTransforms(event, is_static); }); });
                   }),
      tick_timer_(repeat(kTick, &PublisherNode::onTick)),
      lost_frames_timer_(repeat(kLostFramesPeriod, &PublisherNode::warnOfLostFrames)),
      diagnostics_timer_(repeat(kDiagnosticsPeriod, &PublisherNode::publishDiagnostics)) {
  subscribeToObjects();
  ModelLoader::Handlers handlers;
  // What adopt() throws becomes ~reload's answer.
  handlers.adopt = [this](const auto& model) { times_.measure([&] { adopt(model); }); };
  handlers.on_mesh = [this](const auto& uri, const auto& mesh) {
    guard([&] { onMesh(uri, mesh); });
  };
  handlers.on_tree = [this](const auto& request, const auto& tree) { onTree(request, tree); };
  loader_ = std::make_unique<ModelLoader>(private_node_, std::move(handlers));
  master_watch_ = std::make_unique<MasterWatch>();
}

/// Distances request trees from the loader.
PublisherNode::~PublisherNode() {
  output_.distances().stop();
}

/// Called on the thread of distances, which works only after a model has come from the loader.
TreeRequests PublisherNode::treeRequests() {
  TreeRequests requests;
  requests.mesh = [this](const auto& uri, const auto& points) {
    loader_->requestTree({uri, points});
  };
  requests.list = [this](const std::shared_ptr<const ObjectContent>& list) {
    loader_->request([this, list] { output_.distances().give(listTree(*list)); });
  };
  return requests;
}

/// On the loader thread.
void PublisherNode::onTree(const ModelLoader::TreeRequest& request, const LoadedTree& tree) {
  MadeTree made{request.points, nullptr, tree.error};
  if (tree.points == request.points) {
    made.triangles = tree.triangles;
  } else if (made.error.empty()) {
    made.error = request.uri + " was replaced since it was loaded; call ~reload";
  }
  if (!made.error.empty())
    ROS_WARN("distances to the convex hull only: %s", logText(made.error).c_str());
  output_.distances().give(std::move(made));
}

ros::WallTimer PublisherNode::repeat(ros::WallDuration period, void (PublisherNode::*function)()) {
  return node_.createWallTimer(period, [this, function](const ros::WallTimerEvent&) {
    guard([&] { (this->*function)(); });
  });
}

void PublisherNode::subscribeToObjects() {
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  objects_subscriber_ =
      private_node_.subscribe<visualization_msgs::MarkerArray, const MarkersEvent&>(
          privateName(kObjectsTopic), kObjectsQueue,
          [this](const MarkersEvent& event) {
            guard([&] {
              auto& markers = event.getMessage()->markers;
              onMarkers(markers.data(), markers.size(), event.getPublisherName());
            });
          },
          {}, no_delay);
  object_subscriber_ = private_node_.subscribe<Marker, const MarkerEvent&>(
      privateName(kObjectTopic), kObjectsQueue,
      [this](const MarkerEvent& event) {
        guard([&] { onMarkers(event.getMessage().get(), 1, event.getPublisherName()); });
      },
      {}, no_delay);
}

void PublisherNode::adopt(ModelLoader::ModelPtr model) {
  model_ = std::move(model);
  const ros::Time now = ros::Time::now();
  tf_.distrustStampsAhead(now);
  tf_receiver_.forgetLog();
  scene_.adopt(model_, now);
  object_source_.reloadMeshes();
  output_.adopt();
}

void PublisherNode::onTransforms(const TfReceiver::Event& event, bool is_static) {
  const ros::Time now = ros::Time::now();
  observeClock(now);
  tf_receiver_.add(event, is_static, clock_, now, tf_);
  if (scene_.update(now)) onNews();
}

void PublisherNode::onTick() {
  const ros::Time now = ros::Time::now();
  observeClock(now);
  const bool is_changed = scene_.expire(now);
  object_source_.warnOfGivenUp(now);
  freeMemory();
  if (is_changed) onNews();
  if (clock_.isMissing()) {
    ROS_WARN_STREAM_ONCE("use_sim_time is set but nobody publishes /clock; waiting for it");
  }
}

void PublisherNode::freeMemory() {
  tf_receiver_.freeSpareMemory();
  if (!object_memory_.isWorthReturning(scene_.objects.objects().size())) return;
  output_.freeSpareMemory();
  returnFreeMemory();
}

void PublisherNode::observeClock(ros::Time now) {
  switch (clock_.observe(now)) {
    case ClockWatch::Event::kNone:
      return;
    case ClockWatch::Event::kStarted:
      tf_.startClock(now);
      if (scene_.restart(now)) onNews();
      return;
    case ClockWatch::Event::kJumpedBack:
      ROS_WARN("the clock jumped back; forgetting all transforms that are not static");
      tf_.clear();
      if (scene_.restart(now)) onNews();
      return;
  }
}

/// All markers of one message lead to one publication.
void PublisherNode::onMarkers(Marker* markers, std::size_t count, const std::string& publisher) {
  const ros::Time now = ros::Time::now();
  observeClock(now);
  bool is_changed = false;
  for (std::size_t i = 0; i < count; ++i)
    is_changed |= object_source_.take(std::move(markers[i]), publisher, now);
  if (is_changed) onNews();
}

void PublisherNode::onMesh(const std::string& uri, const LoadedMesh& mesh) {
  if (object_source_.fillMesh(uri, mesh, ros::Time::now())) onNews();
}

/// Nothing is published before the first model.
void PublisherNode::onNews() {
  if (!scene_.model()) return;
  ++updates_;
  output_.request();
}

void PublisherNode::warnOfLostFrames() {
  for (const std::string& line : lost_frames_.warnings(scene_, ros::SteadyTime::now()))
    ROS_WARN("%s", logText(line).c_str());
}

void PublisherNode::publishDiagnostics() {
  Health health;
  if (loader_->waitsForDescription()) health.awaited_description = loader_->descriptionName();
  health.waits_for_clock = clock_.isMissing();
  health.clock_jumped = clock_.hasJustJumped();
  health.updates = updates_;
  health.publications = output_.publications();
  health.lag_ms = output_.takeMaxLag();
  health.footprint = output_.footprintState();
  health.intake = tf_.intake();
  health.distances = output_.distances().takeHealth();
  diagnostics_.publish(scene_, health, times_);
}

}  // namespace link_bounds
