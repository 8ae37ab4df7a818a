// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Passes messages to the scene and the scene to the outputs; functions are in that order.
#include "node/publisher_node.h"

#include <ros/init.h>
#include <ros/this_node.h>

#include <algorithm>
#include <utility>

#include "node/interface/topics.h"
#include "node/loading/mesh_remedy.h"
#include "node/threads/queued_function.h"
#include "world/log/guarded.h"
#include "world/log/log_text.h"
#include "world/moment/object_body.h"

namespace link_bounds {
namespace {

/// Max waiting messages per topic. If more come, roscpp drops the oldest without notice.
constexpr std::uint32_t kObjectsQueue = 1000;
constexpr std::uint32_t kObjectQueue = 100'000;  // a scene sent as single markers, about 1 kB each
const ros::WallDuration kTick(SceneFeed::kTick);
const ros::WallDuration kLostFramesPeriod(0.5);
const ros::WallDuration kDiagnosticsPeriod(1.0);
constexpr std::chrono::milliseconds kMaxWait(100);  // max delay until a shutdown is noticed

/// If a message has waited longer than this, or more than kMaxWaiting messages wait, all of them
/// share one update.
constexpr std::chrono::milliseconds kMaxBacklogAge(20);

constexpr std::size_t kMaxWaiting = 64;

/// When messages share an update: after this time, messages of /tf are skipped except the newest
/// kMaxWaiting. This keeps boxes recent even if reading all of /tf is too slow.
constexpr std::chrono::milliseconds kMaxTaking(15);

double seconds(std::chrono::nanoseconds duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

void PublisherNode::measure(const std::function<void()>& body) {
  completed([&] {
    times_.measure([&] {
      feed_.update(ros::Time::now());
      body();
    });
  });
}

void PublisherNode::guardMessage(const std::function<void()>& body) {
  guarded([&] { completed([&] { times_.measure(body); }); });
}

PublisherNode::PublisherNode()
    : node_(onQueue(ros::NodeHandle(), queue_)),
      private_node_(onQueue(ros::NodeHandle("~"), queue_)),
      feed_({[this](const auto& request) { loader_->requestMesh(request); }, [this] { onNews(); },
             [this](const std::string& node) { return master_watch_->hasLeft(node); }}),
      output_(periodic_, private_node_, scene_, guard_, treeRequests()),
      diagnostics_(node_),
      tf_receiver_(node_,
                   [this](const TfReceiver::Event& event, bool is_static) {
                     times_.measureTf([&] {
                       guarded([&] { completed([&] { onTransforms(event, is_static); }); });
                     });
                   }),
      scene_copier_(
          scene_, [this](const auto& body) { measure(body); }, queue_),
      box_service_(private_node_, scene_copier_),
      path_service_(private_node_, scene_copier_, box_service_.answering(),
                    [this](const auto& uris, const auto& is_over) {
                      return loader_->loadTrees(uris, is_over);
                    }),
      swept_output_(periodic_, private_node_, guard_, scene_copier_),
      stopping_output_(periodic_, private_node_, guard_, scene_copier_),
      earliest_output_(private_node_, guard_, scene_copier_, treeRequests()) {
  repeat(kTick, &PublisherNode::onTick);
  repeat(kLostFramesPeriod, &PublisherNode::warnOfLostFrames);
  repeat(kDiagnosticsPeriod, &PublisherNode::publishDiagnostics);
  subscribeToObjects();
  output_.onBoxes([this] {
    swept_output_.request();
    stopping_output_.request();
    earliest_output_.request();
  });
  ModelLoader::Handlers handlers;
  // An exception of adopt() becomes the response of ~reload.
  handlers.adopt = [this](const auto& model) { measure([&] { adopt(model); }); };
  handlers.on_mesh = [this](const auto& request, const auto& mesh) {
    guard_([&] { feed_.onMesh(request, mesh, ros::Time::now()); });
  };
  handlers.on_tree = [this](const auto& request, const auto& tree) { onTree(request, tree); };
  loader_ = std::make_unique<ModelLoader>(node_, private_node_, queue_, std::move(handlers));
  master_watch_ =
      std::make_unique<MasterWatch>(private_node_.resolveName(privateName(kNeighboursTopic)));
}

/// Stops the threads that request trees from the loader, before the loader is destroyed.
PublisherNode::~PublisherNode() {
  path_service_.stop();
  output_.distances().stop();
  earliest_output_.stop();
}

/// The functions are called on the threads of distances and contacts, which work only after the
/// loader has made a model.
TreeRequests PublisherNode::treeRequests() {
  TreeRequests requests;
  requests.mesh = [this](const auto& uri, const auto& points) {
    loader_->requestTree({uri, points});
  };
  requests.list = [this](const std::shared_ptr<const ObjectContent>& list) {
    const auto make = [this, waiting = std::weak_ptr<const ObjectContent>(list)](
                          const MeshReaders::IsCancelled& is_cancelled) {
      if (const auto content = waiting.lock()) makeListTree(content, is_cancelled);
    };
    const auto bytes = list->bounded.shapes.front().points->bytes();
    loader_->request("list " + list->bounded.name, {[bytes] { return bytes; }, make});
  };
  return requests;
}

/// Called on a reader thread. If `list` has no other owner, nobody needs its tree.
void PublisherNode::makeListTree(const std::shared_ptr<const ObjectContent>& list,
                                 const MeshReaders::IsCancelled& is_cancelled) {
  const auto is_unwanted = [&] { return is_cancelled() || list.use_count() == 1; };
  const auto source = loader_->source(is_unwanted);
  if (!source) return;
  MadeTree made{list->bounded.shapes.front().points, nullptr, ""};
  try {
    made = listTree(*list, meshDeadline(source->limits, is_unwanted));
  } catch (const MeshError& error) {
    made.error = list->bounded.name + ": " + error.what() + "; " + nodeRemedy(error.fault());
  }
  if (!is_unwanted()) give(made);
}

/// Called on a reader thread.
void PublisherNode::onTree(const ModelLoader::TreeRequest& request, const LoadedTree& tree) {
  MadeTree made{request.points, nullptr, tree.error};
  if (tree.points == request.points.lock()) {
    made.triangles = tree.triangles;
  } else if (made.error.empty()) {
    made.error = request.uri + " was replaced since it was loaded; call ~reload";
  }
  if (!made.error.empty())
    ROS_WARN("distances to the convex hull only: %s", logText(made.error).c_str());
  give(made);
}

/// Gives the tree to all outputs that may have requested it.
void PublisherNode::give(const MadeTree& tree) {
  output_.distances().give(tree);
  earliest_output_.give(tree);
}

void PublisherNode::repeat(ros::WallDuration period, void (PublisherNode::*function)()) {
  periodic_.add(period, [this, function] { guard_([&] { (this->*function)(); }); });
}

void PublisherNode::spin() {
  while (ros::ok()) {
    queue_.wait(std::min<std::chrono::nanoseconds>(kMaxWait, periodic_.rest()));
    callWaiting();
    if (!ros::isShuttingDown()) periodic_.callDue();
  }
}

/// While the node keeps up, each message leads to an update. Otherwise all waiting messages share
/// one update, and messages of /tf are skipped after kMaxTaking.
void PublisherNode::callWaiting() {
  const auto begin = std::chrono::steady_clock::now();
  const TimedQueue::Backlog backlog = queue_.backlog();
  const bool is_behind = backlog.count > kMaxWaiting || backlog.oldest > kMaxBacklogAge;
  feed_.setJoining(is_behind);
  queue_.callOne();
  for (std::size_t i = 1; is_behind && i < backlog.count && queue_.callOne(); ++i) {
    if (!ros::isShuttingDown()) periodic_.callDue();
    const bool is_late = std::chrono::steady_clock::now() - begin > kMaxTaking;
    tf_receiver_.skip(is_late && i + 1 + kMaxWaiting < backlog.count);
  }
  tf_receiver_.skip(false);
  feed_.setJoining(false);
  if (is_behind) guard_([] {});  // runs the update
  const auto delay = backlog.oldest + (std::chrono::steady_clock::now() - begin);
  if (backlog.count > 0) max_delay_ = std::max(max_delay_, delay);
}

template <class Message, class Take>
ros::Subscriber PublisherNode::subscribe(const TopicName& topic, std::uint32_t size, Take take) {
  return subscribeReceived<Message>(
      private_node_, privateName(topic), size, [this, &topic, take](const auto& event) {
        guardMessage([&] {
          const auto message = event.getMessage();
          const std::string& sender = event.getPublisherName();
          if (incomplete_messages_.accept(*message, topic.name, sender)) take(*message, sender);
        });
      });
}

void PublisherNode::subscribeToObjects() {
  objects_subscriber_ = subscribe<visualization_msgs::MarkerArray>(
      kObjectsTopic, kObjectsQueue, [this](auto& message, const std::string& sender) {
        onMarkers(message.markers.data(), message.markers.size(), sender);
      });
  object_subscriber_ = subscribe<Marker>(
      kObjectTopic, kObjectQueue,
      [this](auto& message, const std::string& sender) { onMarkers(&message, 1, sender); });
  neighbours_subscriber_ = subscribeReceived<AxisAlignedBoxArray>(
      private_node_, privateName(kNeighboursTopic), kObjectsQueue,
      [this](const NeighbourEvent& event) { guardMessage([&] { onNeighbour(event); }); });
}

void PublisherNode::adopt(ModelLoader::ModelPtr model) {
  model_ = std::move(model);
  feed_.adopt(model_, ros::Time::now());
  scene_copier_.adopt(model_);
  swept_output_.adopt(model_->parameters);
  stopping_output_.adopt(model_->parameters);
  output_.adopt();
}

void PublisherNode::onTransforms(const TfReceiver::Event& event, bool is_static) {
  if (event.getConstMessage()->is_skipped) {
    ++skipped_;
    return;
  }
  feed_.onTransforms(
      event.getConstMessage()->transforms, is_static, [&event] { return event.getPublisherName(); },
      ros::Time::now(), queue_.arrival());
}

void PublisherNode::onTick() {
  feed_.onTick(ros::Time::now());
  feed_.forgetQuietFrames(ros::SteadyTime::now());
  stopping_output_.restIfUnheard();
  earliest_output_.restIfUnheard();
  freeMemory();
  if (feed_.clock().isMissing()) {
    ROS_WARN_ONCE(
        "use_sim_time is set, but /clock has had no time yet: nobody publishes it, or it stands "
        "at 0; waiting for it");
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
  if (!incomplete_messages_.accept(*event.getConstMessage(), kNeighboursTopic.name, sender)) return;
  feed_.onNeighbour(*event.getConstMessage(), {sender, event.getConnectionHeaderPtr()},
                    ros::Time::now());
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
  health.clock_jumps = feed_.clock().jumps();
  health.updates = updates_;
  health.publications = output_.publications();
  health.errors = unexpectedErrors();
  health.joined = feed_.takeJoined();
  health.skipped = std::exchange(skipped_, 0);
  health.max_waiting = queue_.takeMaxWaiting();
  health.lag_ms = output_.takeMaxLag();
  if (const auto lag = feed_.tf().takeMaxLag()) {
    const double lag_ms = static_cast<double>(*lag) / 1e6;
    health.lag_ms = std::max(lag_ms, health.lag_ms.value_or(lag_ms));
  }
  health.delay_ms = std::chrono::duration<double, std::milli>(max_delay_).count();
  max_delay_ = std::chrono::nanoseconds(0);
  health.footprint = output_.footprintState();
  health.stopping = stopping_output_.problem();
  health.earliest = earliest_output_.problem();
  health.behind = {{"stopping", seconds(stopping_output_.takeLongest())},
                   {"earliest", seconds(earliest_output_.takeLongest())},
                   {"swept", seconds(swept_output_.takeLongest())}};
  health.intake = feed_.tf().intake();
  health.late_publishers = feed_.takeLatePublishers();
  health.distances = output_.distances().takeHealth();
  diagnostics_.publish(scene_, health, times_);
}

}  // namespace link_bounds
