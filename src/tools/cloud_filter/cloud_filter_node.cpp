// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From what arrives to what is sent, in the order of the functions below.
#include "tools/cloud_filter/cloud_filter_node.h"

#include <ros/init.h>

#include <chrono>

#include "world/cloud/laser_points.h"
#include "world/cloud/without_points.h"
#include "world/log/guarded.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kQueue = 5;      // messages of one topic that roscpp keeps
constexpr std::size_t kMaxWaiting = 32;  // messages that wait for tf
const ros::WallDuration kTick(0.005);
const ros::WallDuration kStatusPeriod(1.0);

double milliseconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

/// On the program's own queue.
ros::NodeHandle nodeHandle(const std::string& ns, ros::CallbackQueueInterface& queue) {
  ros::NodeHandle node(ns);
  node.setCallbackQueue(&queue);
  return node;
}

std::string withoutSlash(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

}  // namespace

CloudFilterNode::CloudFilterNode()
    : node_(nodeHandle("", queue_)),
      private_node_(nodeHandle("~", queue_)),
      health_(node_),
      output_(private_node_.advertise<sensor_msgs::PointCloud2>(privateName(kCloudOutput), kQueue)),
      scan_output_(
          private_node_.advertise<sensor_msgs::LaserScan>(privateName(kScanOutput), kQueue)),
      robot_points_(
          private_node_.advertise<sensor_msgs::PointCloud2>(privateName(kRobotPoints), kQueue)),
      tf_receiver_(node_, [this](const TfReceiver::Event& event, bool is_static) {
        guarded([&] { onTransforms(event, is_static); });
      }) {
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  using CloudEvent = ros::MessageEvent<Cloud>;
  using ScanEvent = ros::MessageEvent<Scan>;
  cloud_subscriber_ = private_node_.subscribe<Cloud, const CloudEvent&>(
      privateName(kCloudTopic), kQueue,
      [this](const CloudEvent& event) {
        guarded([&] {
          const auto cloud = event.getMessage();
          if (incomplete_messages_.accept(*cloud, kCloudTopic.name, event.getPublisherName()))
            add({cloud, nullptr, ros::SteadyTime::now()});
        });
      },
      {}, no_delay);
  scan_subscriber_ = private_node_.subscribe<Scan, const ScanEvent&>(
      privateName(kScanTopic), kQueue,
      [this](const ScanEvent& event) {
        guarded([&] {
          const auto scan = event.getMessage();
          if (incomplete_messages_.accept(*scan, kScanTopic.name, event.getPublisherName()))
            add({nullptr, scan, ros::SteadyTime::now()});
        });
      },
      {}, no_delay);
  loading_ = std::make_unique<RobotLoading>(
      queue_, [this](std::shared_ptr<const FilteredRobot> robot) { adopt(std::move(robot)); });
}

void CloudFilterNode::spin() {
  ros::SteadyTime next_status = ros::SteadyTime::now() + kStatusPeriod;
  while (ros::ok()) {
    queue_.callAvailable(kTick);
    guarded([&] {
      observeClock();
      filterWaiting();
    });
    if (ros::SteadyTime::now() < next_status) continue;
    next_status = ros::SteadyTime::now() + kStatusPeriod;
    guarded([&] {
      tf_.forgetQuiet(ros::SteadyTime::now());
      tf_receiver_.freeSpareMemory();
      health_.publish(robot_.get());
    });
  }
}

void CloudFilterNode::adopt(std::shared_ptr<const FilteredRobot> robot) {
  robot_ = std::move(robot);
  for (std::size_t i = 0; i < robot_->links.size(); ++i) {
    frames_.emplace_back(tf_, withoutSlash(robot_->links[i]));
    links_.push_back({frames_.back().frame(), robot_->grids[i]->box()});
  }
}

void CloudFilterNode::onTransforms(const TfReceiver::Event& event, bool is_static) {
  observeClock();
  tf_input_.add(
      event.getConstMessage()->transforms, is_static, [&event] { return event.getPublisherName(); },
      clock_, ros::Time::now(), tf_);
}

/// After a jump back, what waits is from a time that tf has forgotten.
void CloudFilterNode::observeClock() {
  const ros::Time now = ros::Time::now();
  const ClockWatch::Event event = clock_.observe(now);
  if (event == ClockWatch::Event::kStarted) tf_.startClock(now);
  if (event != ClockWatch::Event::kJumpedBack) return;
  tf_.clear();
  tf_input_.forgetLog();
  for (const Waiting& waiting : waiting_)
    giveUp(waiting, "the clock jumped back", false);
  waiting_.clear();
}

void CloudFilterNode::add(Waiting waiting) {
  if (waiting_.size() >= kMaxWaiting) {
    giveUp(waiting_.front(), "more clouds came than could be filtered", false);
    waiting_.pop_front();
  }
  waiting_.push_back(std::move(waiting));
}

/// In the order of arrival, so that an output keeps the order of its input.
void CloudFilterNode::filterWaiting() {
  const double max_wait = robot_ ? robot_->parameters.max_wait : FilterParameters().max_wait;
  while (!waiting_.empty()) {
    const Waiting& waiting = waiting_.front();
    const Outcome outcome = filter(waiting);
    if (!outcome.is_done) {
      const double waited = (ros::SteadyTime::now() - waiting.since).toSec();
      if (outcome.may_come && waited < max_wait) return;
      giveUp(waiting, outcome.reason, outcome.may_come);
    }
    waiting_.pop_front();
  }
}

/// What cannot be read is never passed on.
void CloudFilterNode::giveUp(const Waiting& waiting, const std::string& reason, bool is_late) {
  const bool is_passed = is_late && robot_ && robot_->parameters.late == "pass";
  health_.addUnfiltered(waiting.topic(), reason, is_passed);
  if (!is_passed) return;
  if (waiting.cloud) {
    output_.publish(static_cast<const sensor_msgs::PointCloud2&>(*waiting.cloud));
  } else {
    scan_output_.publish(static_cast<const sensor_msgs::LaserScan&>(*waiting.scan));
  }
}

CloudFilterNode::Outcome CloudFilterNode::filter(const Waiting& waiting) {
  if (waiting.header().stamp.isZero())
    return {false, false, "its header has no stamp; set that of the measurement"};
  if (!robot_) return {false, true, "no robot has been loaded yet"};
  if (waiting.cloud) {
    const CloudLayout layout = layoutOf(*waiting.cloud);
    if (!layout.problem.empty()) return {false, false, layout.problem};
    return filter(waiting, layout.points);
  }
  const LaserPoints laser(*waiting.scan);
  if (!laser.problem().empty()) return {false, false, laser.problem()};
  return filter(waiting, laser.points());
}

CloudFilterNode::Outcome CloudFilterNode::filter(const Waiting& waiting,
                                                 const CloudPoints& points) {
  const auto begin = std::chrono::steady_clock::now();
  const double waited = (ros::SteadyTime::now() - waiting.since).toSec() * 1e3;
  std::vector<RobotPoint> removed;
  if (const auto span = timeSpan(points)) {
    const std::string frame = withoutSlash(waiting.header().frame_id);
    const auto sensor = tf_.find(frame);
    if (!sensor) return {false, true, "tf does not know its frame \"" + frame + "\""};
    const ScanPoses poses = scanPoses(tf_, *sensor, links_, *span);
    if (!poses.problem.empty()) return {false, poses.may_come, poses.problem};
    const FilterParameters& parameters = robot_->parameters;
    removed = robotPoints({points, robot_->grids, poses, parameters.min_distance},
                          static_cast<std::size_t>(parameters.threads));
  }
  const std::size_t count = points.size();
  send(waiting, removed);
  health_.addFiltered(count, removed.size(), waited,
                      milliseconds(std::chrono::steady_clock::now() - begin));
  return {true, false, ""};
}

void CloudFilterNode::send(const Waiting& waiting, const std::vector<RobotPoint>& removed) {
  if (waiting.scan) {
    removePoints(removed, *waiting.scan);
    scan_output_.publish(static_cast<const sensor_msgs::LaserScan&>(*waiting.scan));
    return;
  }
  sensor_msgs::PointCloud2& cloud = *waiting.cloud;
  if (robot_points_.getNumSubscribers() > 0) robot_points_.publish(onlyPoints(removed, cloud));
  removePoints(removed, robot_->parameters.keep_organized, cloud);
  output_.publish(cloud);
}

}  // namespace link_bounds
