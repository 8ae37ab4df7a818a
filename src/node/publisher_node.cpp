// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From what arrives to a scene and its output, in the order of the functions below.
#include "node/publisher_node.h"

#include <ros/callback_queue.h>
#include <ros/init.h>
#include <ros/this_node.h>

#include "node/distances/object_body.h"
#include "node/log/guarded.h"
#include "node/log/log_text.h"
#include "node/names/topics.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kObjectsQueue = 1000;  // messages, as for a burst of single markers
const ros::WallDuration kTick(SceneFeed::kTick);
const ros::WallDuration kLostFramesPeriod(0.5);
const ros::WallDuration kDiagnosticsPeriod(1.0);
const ros::WallDuration kMaxWait(0.1);  // until a shutdown is noticed

}  // namespace

void PublisherNode::guard(const std::function<void()>& body) {
  guarded([&] { times_.measure(body); });
}

PublisherNode::PublisherNode()
    : feed_({[this](const std::string& uri) { loader_->requestMesh(uri); }, [this] { onNews(); }}),
      output_(
          node_, private_node_, scene_, [this](const std::function<void()>& body) { guard(body); },
          treeRequests()),
      diagnostics_(node_),
      tf_receiver_(node_,
                   [this](const TfReceiver::Event& event, bool is_static) {
                     times_.measureTf([&] { guarded([&] { onTransforms(event, is_static); }); });
                   }),
      history_(scene_, [this](const std::function<void()>& body) { guard(body); }),
      box_service_(private_node_, history_),
      swept_output_(
          node_, private_node_, [this](const std::function<void()>& body) { guard(body); },
          history_) {
  repeat(kTick, &PublisherNode::onTick);
  repeat(kLostFramesPeriod, &PublisherNode::warnOfLostFrames);
  repeat(kDiagnosticsPeriod, &PublisherNode::publishDiagnostics);
  subscribeToObjects();
  output_.onBoxes([this] { swept_output_.request(); });
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
  history_.stop();
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

void PublisherNode::repeat(ros::WallDuration period, void (PublisherNode::*function)()) {
  periodic_.add(period, [this, function] { guard([&] { (this->*function)(); }); });
}

void PublisherNode::spin() {
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(periodic_.rest(kMaxWait));
    if (!ros::isShuttingDown()) periodic_.callDue();
  }
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
  neighbours_subscriber_ = private_node_.subscribe<AxisAlignedBoxArray, const NeighbourEvent&>(
      privateName(kNeighboursTopic), kObjectsQueue,
      [this](const NeighbourEvent& event) { guard([&] { onNeighbour(event); }); }, {}, no_delay);
}

void PublisherNode::adopt(ModelLoader::ModelPtr model) {
  model_ = std::move(model);
  feed_.adopt(model_, ros::Time::now());
  history_.adopt(model_);
  swept_output_.adopt(model_->parameters);
  output_.adopt();
}

void PublisherNode::onTransforms(const TfReceiver::Event& event, bool is_static) {
  feed_.onTransforms(
      event.getConstMessage()->transforms, is_static, [&event] { return event.getPublisherName(); },
      ros::Time::now());
}

void PublisherNode::onTick() {
  feed_.onTick(ros::Time::now());
  freeMemory();
  if (feed_.clock().isMissing()) {
    ROS_WARN_STREAM_ONCE("use_sim_time is set but nobody publishes /clock; waiting for it");
  }
}

void PublisherNode::freeMemory() {
  tf_receiver_.freeSpareMemory();
  if (!object_memory_.isWorthReturning(scene_.objects.objects().size())) return;
  output_.freeSpareMemory();
  returnFreeMemory();
}

void PublisherNode::onMarkers(Marker* markers, std::size_t count, const std::string& publisher) {
  feed_.onMarkers(markers, count, publisher, ros::Time::now());
}

void PublisherNode::onNeighbour(const NeighbourEvent& event) {
  const std::string& sender = event.getPublisherName();
  if (sender == ros::this_node::getName()) {
    ROS_WARN_ONCE("~neighbours also carries the boxes of this node itself; they are ignored");
    return;
  }
  feed_.onNeighbour(*event.getConstMessage(), sender, ros::Time::now());
}

void PublisherNode::onMesh(const std::string& uri, const LoadedMesh& mesh) {
  feed_.onMesh(uri, mesh, ros::Time::now());
}

void PublisherNode::onNews() {
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
  health.waits_for_clock = feed_.clock().isMissing();
  health.clock_jumped = feed_.clock().hasJustJumped();
  health.updates = updates_;
  health.publications = output_.publications();
  health.lag_ms = output_.takeMaxLag();
  health.footprint = output_.footprintState();
  health.intake = feed_.tf().intake();
  health.distances = output_.distances().takeHealth();
  diagnostics_.publish(scene_, health, times_);
}

}  // namespace link_bounds
