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
#include "world/moment/object_body.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kObjectQueue = 1000;  // messages, as for a burst of single markers

/// A publisher may invent names without end, and each grid takes up to 256 KiB, its triangles more.
constexpr std::size_t kMaxHeld = 64;

/// Throws what has words.
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

}  // namespace

HeldObjects::HeldObjects(ros::NodeHandle& private_node, TransformBuffer& tf, Worker& worker,
                         ros::CallbackQueueInterface& queue, std::function<void()> on_change)
    : worker_(worker), queue_(queue), on_change_(std::move(on_change)), frames_(tf) {
  subscriber_ = private_node.subscribe<Markers, const ros::MessageEvent<Markers>&>(
      privateName(kHeldObjects), kObjectQueue,
      [this](const ros::MessageEvent<Markers>& event) { guarded([&] { onMarkers(event); }); }, {},
      ros::TransportHints().tcpNoDelay());
}

void HeldObjects::onMarkers(const ros::MessageEvent<Markers>& event) {
  const auto message = event.getMessage();
  const std::string& publisher = event.getPublisherName();
  if (!incomplete_messages_.accept(*message, kHeldObjects.name, publisher)) return;
  for (visualization_msgs::Marker& marker : message->markers)
    source_.take(std::move(marker), publisher, ros::Time::now());
  update();
}

void HeldObjects::adopt(std::shared_ptr<const FilteredRobot> robot) {
  robot_ = std::move(robot);
  for (auto& [key, held] : held_)
    held.content.reset();
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
  if (!robot_) return;
  Objects old = std::move(held_);
  held_.clear();
  for (const auto& [key, object] : objects_.objects()) {
    if (!isHeld(*object.content)) continue;
    if (held_.size() >= kMaxHeld) {
      ROS_ERROR_THROTTLE(10, "more than %zu markers follow links; the others are not filtered",
                         kMaxHeld);
      break;
    }
    HeldObject& held = held_[key] = std::move(old[key]);
    if (held.content && isSame(*held.content, *object.content)) continue;
    held.content = object.content;
    request(key, held.content);
  }
  on_change_();
}

void HeldObjects::request(const ObjectKey& key,
                          const std::shared_ptr<const ObjectContent>& content) {
  const auto make = [this, key, content, padding = robot_->parameters.padding] {
    const auto is_cancelled = [this] { return worker_.isCancelled(); };
    const auto check_interrupt = [&] {
      if (is_cancelled()) throw std::runtime_error("a newer marker replaces it");
    };
    std::shared_ptr<const BodyGrid> grid;
    std::string problem;
    try {
      grid = std::make_shared<BodyGrid>(
          BodySurface(bodyOf(*content, is_cancelled, check_interrupt), check_interrupt),
          GridOptions{padding, kMaxMotionError}, check_interrupt);
    } catch (const std::exception& error) {
      problem = "object " + content->bounded.name + " is not filtered: " + error.what();
    }
    enqueue(queue_, [this, key, content, grid, problem] { take(key, content, grid, problem); });
  };
  const auto& shapes = content->bounded.shapes;
  const bool has_points = !shapes.empty() && shapes.front().points;
  worker_.post("object " + objectName(key), make, has_points ? shapes.front().points->bytes() : 0);
}

/// What is not of the newest content comes too late.
void HeldObjects::take(const ObjectKey& key, const std::shared_ptr<const ObjectContent>& content,
                       std::shared_ptr<const BodyGrid> grid, const std::string& problem) {
  const auto found = held_.find(key);
  if (found == held_.end() || found->second.content != content) return;
  if (!problem.empty()) ROS_ERROR("%s", logText(problem).c_str());
  found->second.grid = std::move(grid);
  found->second.frame = content->frame;
  found->second.problem = problem;
  on_change_();
}

}  // namespace link_bounds
