// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/held_objects.h"

#include <ros/console.h>

#include <stdexcept>
#include <utility>

#include "link_bounds/robot/robot_loader.h"
#include "node/threads/queued_function.h"
#include "packages/package_path.h"
#include "world/cloud/scan_poses.h"
#include "world/log/guarded.h"
#include "world/log/log_text.h"
#include "world/model/model.h"
#include "world/moment/object_body.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kObjectQueue = 1000;  // messages, as for a burst of single markers

/// Limits memory: a publisher may send ever new names, and each grid takes up to 256 KiB, its
/// triangles more.
constexpr std::size_t kMaxHeld = 64;
constexpr std::size_t kMaxRefused = 100;  // refused markers that are named; more are only counted

/// Throws exceptions whose what() is a reason for the user.
Body bodyOf(const ObjectContent& content, const std::function<bool()>& is_cancelled,
            const CheckInterrupt& check_interrupt) {
  if (content.mesh_uri.empty()) {
    if (!hasTree(content)) return objectBody(content, nullptr);
    const MadeTree made = listTree(content, check_interrupt);
    if (!made.triangles) throw std::runtime_error(made.error);
    return objectBody(content, made.triangles);
  }
  MeshSource source;
  source.package_path = rosPackages();
  source.is_cancelled = is_cancelled;
  RobotLoader loader;
  const LoadedTree tree = loader.loadTrees({content.mesh_uri}, source).front();
  if (!tree.points || !tree.triangles) throw std::runtime_error(tree.error);
  ObjectContent with_points = content;
  with_points.bounded.shapes.front().points = tree.points;
  return objectBody(with_points, tree.triangles);
}

/// The key of the worker's task for an object.
std::string keyOf(const ObjectKey& key) {
  return "object " + objectName(key);
}

}  // namespace

HeldObjects::HeldObjects(ros::NodeHandle& private_node, TransformBuffer& tf, Worker& worker,
                         ros::CallbackQueueInterface& queue, std::function<void()> on_change)
    : worker_(worker), queue_(queue), on_change_(std::move(on_change)), frames_(tf) {
  subscriber_ = subscribeReceived<visualization_msgs::MarkerArray>(
      private_node, privateName(kHeldObjects), kObjectQueue,
      [this](const auto& event) { guarded([&] { completed([&] { onMarkers(event); }); }); });
}

void HeldObjects::onMarkers(const ros::MessageEvent<Markers>& event) {
  const auto message = event.getMessage();
  const std::string& publisher = event.getPublisherName();
  if (!incomplete_messages_.accept(*message, kHeldObjects.name, publisher)) return;
  for (visualization_msgs::Marker& marker : message->markers) {
    const bool follows = marker.frame_locked || marker.header.stamp.isZero();
    asked_[{marker.ns, marker.id}] = follows ? tfName("", marker.header.frame_id) : "";
    source_.take(std::move(marker), publisher, ros::Time::now());
  }
  update();
}

void HeldObjects::adopt(std::shared_ptr<const FilteredRobot> robot) {
  robot_ = std::move(robot);
  for (auto& [key, held] : held_) {
    held.content.reset();
    held.first = 0;
  }
  update();
}

void HeldObjects::expire(ros::Time now) {
  if (objects_.expire(now)) update();
  for (const auto& [key, held] : held_) {
    if (objects_.objects().count(key) > 0) continue;
    update();
    return;
  }
}

void HeldObjects::restart(ros::Time now) {
  objects_.restart(now);
  update();
}

bool HeldObjects::isHeld(const ObjectContent& content) const {
  return content.follows() && !content.is_neighbour && content.refused_name.empty() &&
         content.bounded.isWhole() && robot_->all_frames.count(content.frame) > 0;
}

void HeldObjects::update() {
  for (auto asked = asked_.begin(); asked != asked_.end();)
    asked = objects_.objects().count(asked->first) > 0 ? std::next(asked) : asked_.erase(asked);
  if (!robot_) return;
  Objects old = std::move(held_);
  held_.clear();
  refused_.clear();
  more_refused_ = 0;
  for (const auto& [key, object] : objects_.objects()) {
    const ObjectContent& content = *object.content;
    if (!content.bounded.isWhole() && robot_->all_frames.count(asked_[key]) > 0)
      refuse(content.bounded.name, content.bounded.missing);
    if (!isHeld(content)) continue;
    if (held_.size() >= kMaxHeld) {
      refuse(content.bounded.name,
             "more than " + std::to_string(kMaxHeld) + " markers follow links; delete some");
      continue;
    }
    HeldObject& held = held_[key] = std::move(old[key]);
    if (held.content && isSame(*held.content, content)) continue;
    held.content = object.content;
    request(key, held);
  }
  for (const auto& [key, gone] : old) {
    if (held_.count(key) > 0) continue;
    worker_.cancel(keyOf(key));
    if (gone.is_gone) *gone.is_gone = true;
  }
  on_change_();
}

void HeldObjects::refuse(const std::string& name, const std::string& reason) {
  if (refused_.size() < kMaxRefused) {
    refused_[name] = reason;
  } else {
    ++more_refused_;
  }
}

/// A grid that is being made is completed even if a newer content waits. Otherwise a marker that
/// changes all the time would never get a grid.
void HeldObjects::request(const ObjectKey& key, HeldObject& held) {
  held.requested = ++requests_;
  if (held.first == 0) held.first = held.requested;
  if (!held.is_gone) held.is_gone = std::make_shared<std::atomic<bool>>(false);
  const auto make = [this, key, content = held.content, request = held.requested,
                     is_gone = held.is_gone, padding = robot_->parameters.padding] {
    const auto is_over = [&] { return worker_.isStopping() || *is_gone; };
    const auto check_interrupt = [&] {
      if (is_over()) throw std::runtime_error("nobody needs it any more");
    };
    std::shared_ptr<const BodyGrid> grid;
    std::string problem;
    try {
      grid = std::make_shared<BodyGrid>(
          BodySurface(bodyOf(*content, is_over, check_interrupt), check_interrupt),
          GridOptions{padding, kMaxMotionError}, check_interrupt);
      if (!grid->isWhole()) problem = "object " + content->bounded.name + kNotWhole;
    } catch (const std::exception& error) {
      problem = "object " + content->bounded.name + " is not filtered: " + error.what();
    }
    enqueue(queue_, [this, key, request, frame = content->frame, grid, problem] {
      completed([&] { take(key, request, frame, grid, problem); });
    });
  };
  worker_.post(keyOf(key), make);
}

/// Takes the grid of an older content, too: the grid before it is older still. Discards the results
/// of requests from before a reload, and for markers that have been deleted.
void HeldObjects::take(const ObjectKey& key, std::uint64_t request, const std::string& frame,
                       std::shared_ptr<const BodyGrid> grid, const std::string& problem) {
  const auto found = held_.find(key);
  if (found == held_.end() || request < found->second.first) return;
  if (!problem.empty()) ROS_ERROR("%s", logText(problem).c_str());
  HeldObject& held = found->second;
  held.grid = std::move(grid);
  held.frame = frame;
  held.problem = problem;
  held.made = request;
  on_change_();
}

}  // namespace link_bounds
