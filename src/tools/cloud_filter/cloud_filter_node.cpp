// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The functions follow a message from its arrival to the output.
#include "tools/cloud_filter/cloud_filter_node.h"

#include <ros/console.h>
#include <ros/init.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "node/threads/queued_function.h"
#include "tools/cloud_filter/nearest_message.h"
#include "world/cloud/cloud_layout.h"
#include "world/cloud/without_points.h"
#include "world/log/guarded.h"
#include "world/model/model.h"

namespace link_bounds {
namespace {

/// For inputs and outputs: an output may get all waiting messages at once.
constexpr std::uint32_t kQueue = FilterHealth::kQueue;

constexpr char kNoStamp[] = "its header has no stamp; set that of the measurement";
constexpr std::size_t kMaxWaitingBytes = 256'000'000;
/// Messages of /clock: ten seconds at 1 kHz.
constexpr std::uint32_t kClockQueue = 10'000;
constexpr double kLateTurn = 250;  // ms after max_wait; a later turn is reported
constexpr char kClockJumped[] = "the clock jumped back";
constexpr char kTooLong[] = "it waited too long for its turn, and now ";
constexpr std::chrono::milliseconds kTick(5);
const ros::WallDuration kExpirePeriod(0.05);
const ros::WallDuration kStatusPeriod(1.0);

double milliseconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

CloudFilterNode::CloudFilterNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                 std::function<void()> on_failure)
    : node_(onQueue(node, queue_)),
      private_node_(onQueue(private_node, queue_)),
      health_(node_, private_node.getNamespace()),
      output_(private_node_.advertise<sensor_msgs::PointCloud2>(privateName(kCloudOutput), kQueue)),
      scan_output_(
          private_node_.advertise<sensor_msgs::LaserScan>(privateName(kScanOutput), kQueue)),
      robot_points_(
          private_node_.advertise<sensor_msgs::PointCloud2>(privateName(kRobotPoints), kQueue)),
      nearest_(private_node_.advertise<DistanceArray>(privateName(kNearestPoints), kQueue)),
      tf_receiver_(node_, [this](const TfReceiver::Event& event, bool is_static) {
        guarded([&] { completed([&] { onTransforms(event, is_static); }); });
      }) {
  subscribe();
  loading_ = std::make_unique<Loading>(kFilterReload, node_, private_node_, queue_,
                                       handlers(std::move(on_failure)));
  held_ = std::make_unique<HeldObjects>(private_node_, tf_, loading_->worker(), queue_,
                                        [this] { listBodies(); });
}

void CloudFilterNode::subscribe() {
  cloud_subscriber_ = subscribeReceived<sensor_msgs::PointCloud2>(
      private_node_, privateName(kCloudTopic), kQueue, [this](const auto& event) {
        guarded([&] {
          const auto cloud = event.getMessage();
          ++clouds_taken_;
          if (isComplete(*cloud, kCloudTopic.name, event.getPublisherName()))
            add({cloud, nullptr, queue_.arrival()});
        });
      });
  scan_subscriber_ = subscribeReceived<sensor_msgs::LaserScan>(
      private_node_, privateName(kScanTopic), kQueue, [this](const auto& event) {
        guarded([&] {
          const auto scan = event.getMessage();
          ++scans_taken_;
          if (isComplete(*scan, kScanTopic.name, event.getPublisherName()))
            add({nullptr, scan, queue_.arrival()});
        });
      });
  if (!ros::Time::isSimTime()) return;
  clock_subscriber_ = node_.subscribe<rosgraph_msgs::Clock>(
      "/clock", kClockQueue,
      [this](const rosgraph_msgs::ClockConstPtr& clock) {
        simulated_now_ = clock->clock;
        guarded([this] { completed([this] { observeClock(); }); });
      },
      {}, ros::TransportHints().tcpNoDelay());
}

CloudFilterNode::Loading::Handlers CloudFilterNode::handlers(std::function<void()> on_failure) {
  Loading::Handlers handlers;
  handlers.read = [name = private_node_.getNamespace()](const ParameterServer& server) {
    return readParameters<FilterParameters>(server, name, [](auto& parameters, auto& reader) {
      visitFilterParameters(parameters, reader);
    });
  };
  handlers.load = [](const auto&... all) {
    const auto robot = filteredRobot(all...);
    return Loading::Loaded{robot, robot ? robot->summary : ""};
  };
  handlers.adopt = [this](auto robot) { completed([&] { adopt(std::move(robot)); }); };
  handlers.on_failure = std::move(on_failure);
  return handlers;
}

void CloudFilterNode::spin() {
  ros::SteadyTime next_status = ros::SteadyTime::now() + kStatusPeriod;
  ros::SteadyTime next_expiry = ros::SteadyTime::now();
  bool has_more = false;
  while (ros::ok() && !is_stopping_) {
    if (!has_more) queue_.wait(kTick);
    takeAll();
    has_more = false;
    guarded([&] {
      completed([&] { observeClock(); });
      has_more = filterNext();
    });
    const ros::SteadyTime time = ros::SteadyTime::now();
    if (time >= next_expiry) {
      next_expiry = time + kExpirePeriod;
      guarded([&] {
        completed([&] {
          held_->expire(now());
          tf_.forgetQuiet(time);
        });
      });
    }
    if (time < next_status) continue;
    next_status = time + kStatusPeriod;
    guarded([&] {
      tf_receiver_.freeSpareMemory();
      const std::size_t max_waiting = queue_.takeMaxWaiting();
      health_.publish(robot_.get(), loading_->failure(), heldProblems(),
                      clouds_.waiting.size() + scans_.waiting.size(), max_waiting);
    });
  }
}

/// Calls all callbacks that wait now. A full queue of an input may have lost messages.
void CloudFilterNode::takeAll() {
  clouds_taken_ = scans_taken_ = transforms_taken_ = 0;
  for (std::size_t waiting = queue_.backlog().count; waiting > 0; --waiting)
    queue_.callOne();
  if (std::max(clouds_taken_, scans_taken_) >= kQueue) health_.addFullQueue();
  if (transforms_taken_ >= TfReceiver::kQueue) health_.addFullTfQueue();
}

void CloudFilterNode::adopt(std::shared_ptr<const FilteredRobot> robot) {
  tf_.distrustStampsAhead(ros::Time::now());
  tf_input_.forgetLog();
  robot_ = std::move(robot);
  held_->adopt(robot_);
}

/// Lists the bodies again, after a change of the robot or of the objects that it holds.
void CloudFilterNode::listBodies() {
  const std::vector<TransformBuffer::Hold> old_frames = std::move(frames_);
  names_.clear();
  frames_.clear();
  grids_.clear();
  links_.clear();
  incomplete_ = robot_->incomplete;
  for (std::size_t i = 0; i < robot_->links.size(); ++i)
    add(robot_->links[i], robot_->frames[i], robot_->grids[i]);
  for (const auto& [key, held] : held_->objects()) {
    if (held.grid) add(objectName(key), held.frame, held.grid);
    if (!held.isNewest()) incomplete_.push_back(objectName(key));
  }
  for (const auto& [name, reason] : held_->refused())
    incomplete_.push_back(name);
}

void CloudFilterNode::add(const std::string& name, const std::string& frame,
                          const std::shared_ptr<const BodyGrid>& grid) {
  names_.push_back(name);
  frames_.emplace_back(tf_, frame);
  grids_.push_back(grid);
  links_.push_back({frames_.back().frame(), grid->box()});
}

std::vector<std::string> CloudFilterNode::heldProblems() const {
  std::vector<std::string> problems;
  for (const auto& [key, held] : held_->objects()) {
    if (!held.problem.empty()) problems.push_back(held.problem);
    if (held.problem.empty() && !held.isNewest())
      problems.push_back("object " + objectName(key) + " is not filtered as it is: its " +
                         (held.grid ? "new shape is not ready yet, the old one counts"
                                    : "shape is not ready yet"));
  }
  for (const auto& [name, reason] : held_->refused())
    problems.push_back("object " + name + " is not filtered: " + reason);
  if (held_->moreRefused() > 0)
    problems.push_back(std::to_string(held_->moreRefused()) + " more objects are not filtered");
  return problems;
}

void CloudFilterNode::onTransforms(const TfReceiver::Event& event, bool is_static) {
  if (!is_static) ++transforms_taken_;
  observeClock();
  tf_input_.add(
      event.getConstMessage()->transforms, is_static, [&event] { return event.getPublisherName(); },
      clock_, now(), queue_.arrival(), tf_);
}

/// Simulated time is taken from the queue of the node, in the order of arrival. ros::Time::now()
/// may jump back while a cloud is filtered, and pass the old time again unnoticed.
ros::Time CloudFilterNode::now() const {
  return clock_subscriber_ ? simulated_now_ : ros::Time::now();
}

/// After a backward jump, gives up all waiting messages: tf has forgotten their times.
void CloudFilterNode::observeClock() {
  const ros::Time now = this->now();
  const ClockWatch::Event event = clock_.observe(now);
  if (event == ClockWatch::Event::kStarted) {
    tf_.startClock(now);
    held_->restart(now);
  }
  if (event != ClockWatch::Event::kJumpedBack) return;
  tf_.clear();
  tf_input_.forgetLog();
  held_->restart(now);
  for (Input* input : {&clouds_, &scans_}) {
    for (const Waiting& waiting : input->waiting)
      giveUp(waiting, kClockJumped, false);
    *input = {};
  }
}

template <class Message>
bool CloudFilterNode::isComplete(const Message& message, const char* topic,
                                 const std::string& sender) {
  if (incomplete_messages_.accept(message, topic, sender)) return true;
  health_.addUnfiltered(topic, kIncompleteMessage, false);
  return false;
}

std::size_t CloudFilterNode::Waiting::bytes() const {
  std::size_t sum = header().frame_id.size();
  if (scan) return sum + (scan->ranges.size() + scan->intensities.size()) * sizeof(float);
  for (const sensor_msgs::PointField& field : cloud->fields)
    sum += sizeof field + field.name.size();
  return sum + cloud->data.size();
}

std::string CloudFilterNode::Waiting::fault() const {
  if (header().stamp.isZero()) return kNoStamp;
  return cloud ? layoutOf(*cloud).problem : problemOf(*scan);
}

/// While the first message of an input waits for tf, the others wait behind it.
void CloudFilterNode::add(Waiting waiting) {
  completed([&] { observeClock(); });  // first, so that a jump does not drop this message
  if (clock_.isFromBeforeJump(waiting.header().stamp, now(), waiting.since)) {
    giveUp(waiting, kClockJumped, false);
    return;
  }
  const std::size_t bytes = waiting.bytes();
  if (bytes > kMaxWaitingBytes) {
    giveUp(waiting, "it is larger than 256 MB, which is all that may wait", false);
    return;
  }
  Input& input = inputOf(waiting);
  Input& other = &input == &clouds_ ? scans_ : clouds_;
  if (input.waiting.size() >= FilterHealth::kMaxWaiting) giveUpOldest(input);
  while (waitingBytes() + bytes > kMaxWaitingBytes)
    giveUpOldest(input.waiting.empty() ? other : input);
  input.waiting.push_back(std::move(waiting));
}

std::size_t CloudFilterNode::waitingBytes() const {
  std::size_t sum = 0;
  for (const Input* input : {&clouds_, &scans_}) {
    for (const Waiting& waiting : input->waiting)
      sum += waiting.bytes();
  }
  return sum;
}

/// It may not have been tried: then it lacks what an earlier one of the same frame lacked.
void CloudFilterNode::giveUpOldest(Input& input) {
  const Waiting& waiting = input.waiting.front();
  const bool is_late = !input.waits_for.empty() && waiting.header().frame_id == input.waits_in;
  giveUp(waiting, is_late ? input.waits_for : "more clouds came than could be filtered", is_late);
  input.waiting.pop_front();
}

/// Filters only one message, so that new messages are taken soon from roscpp, whose full queues
/// drop messages silently. False if no message is ready.
bool CloudFilterNode::filterNext() {
  const bool is_scan_first =
      !scans_.waiting.empty() &&
      (clouds_.waiting.empty() || scans_.waiting.front().since < clouds_.waiting.front().since);
  return filterFirst(is_scan_first ? scans_ : clouds_) ||
         filterFirst(is_scan_first ? clouds_ : scans_);
}

/// Filters the oldest message, so that the output keeps the order of the input. False if it has to
/// wait for tf, or if there is none.
bool CloudFilterNode::filterFirst(Input& input) {
  if (input.waiting.empty()) return false;
  const double max_wait = robot_ ? robot_->parameters.max_wait : FilterParameters().max_wait;
  Waiting& waiting = input.waiting.front();
  const double waited = (ros::SteadyTime::now() - waiting.since).toSec();
  const bool is_late_turn =
      !std::exchange(waiting.was_first, true) && waited > max_wait + kLateTurn / 1e3;
  Outcome outcome;
  try {
    outcome = filter(waiting);
  } catch (const std::exception& error) {  // else it and all messages behind it would wait for ever
    outcome.reason = error.what();
  }
  input.waits_for = outcome.may_come ? outcome.reason : "";
  input.waits_in = waiting.header().frame_id;
  if (!outcome.is_done) {
    if (outcome.may_come && waited < max_wait) return false;
    giveUp(waiting, is_late_turn ? kTooLong + outcome.reason : outcome.reason,
           outcome.may_come && !is_late_turn);
  }
  input.waiting.pop_front();
  if (input.waiting.empty()) input.waits_for.clear();  // the next message may find its transforms
  return true;
}

/// A message that cannot be read is never passed on, even if it is given up for being late.
void CloudFilterNode::giveUp(const Waiting& waiting, const std::string& reason, bool is_late) {
  const std::string fault = is_late ? waiting.fault() : "";
  const bool is_passed = is_late && fault.empty() && robot_ && robot_->parameters.late == "pass";
  health_.addUnfiltered(waiting.topic(), fault.empty() ? reason : fault, is_passed);
  if (!is_passed) return;
  publish(waiting);
}

/// Subscribers in this process (nodelets) share the message, so it must not change after this call.
void CloudFilterNode::publish(const Waiting& waiting) {
  if (waiting.cloud) {
    output_.publish(boost::shared_ptr<const sensor_msgs::PointCloud2>(waiting.cloud));
  } else {
    scan_output_.publish(boost::shared_ptr<const sensor_msgs::LaserScan>(waiting.scan));
  }
}

CloudFilterNode::Outcome CloudFilterNode::filter(Waiting& waiting) {
  if (waiting.header().stamp.isZero()) return {false, false, kNoStamp};
  if (!robot_) return {false, true, "no robot has been loaded yet"};
  if (waiting.cloud) {
    const CloudLayout layout = layoutOf(*waiting.cloud);
    if (!layout.problem.empty()) return {false, false, layout.problem};
    return filter(waiting, layout.points);
  }
  const std::string problem = problemOf(*waiting.scan);
  if (!problem.empty()) return {false, false, problem};
  return filter(waiting, LaserPoints(*waiting.scan).points());
}

CloudFilterNode::Outcome CloudFilterNode::filter(Waiting& waiting, const CloudPoints& points) {
  const auto begin = std::chrono::steady_clock::now();
  const double waited = (ros::SteadyTime::now() - waiting.since).toSec() * 1e3;
  std::vector<RobotPoint> removed;
  if (!waiting.span) waiting.span = timeSpan(points);
  if (waiting.span) {
    const std::string frame = tfName("", waiting.header().frame_id);
    const auto sensor = tf_.find(frame);
    if (!sensor) return {false, true, "tf does not know its frame \"" + frame + "\""};
    const FilterParameters& parameters = robot_->parameters;
    const ScanPoses poses = scanPoses(tf_, *sensor, links_, *waiting.span, 0, parameters.timeout);
    if (!poses.problem.empty()) return {false, poses.may_come, poses.problem};
    removed = robotPoints({points, grids_, poses, parameters.min_distance, parameters.shadow},
                          static_cast<std::size_t>(parameters.threads));
  }
  const std::size_t count = points.size();
  if (nearest_.getNumSubscribers() > 0) sendNearest(waiting.header(), points, removed);
  send(waiting, removed);
  health_.addFiltered(count, removed.size(), waited,
                      milliseconds(std::chrono::steady_clock::now() - begin));
  if (waited > robot_->parameters.max_wait * 1e3 + kLateTurn) health_.addLateTurn();
  return {true, false, ""};
}

/// Call it before the points are removed from the message.
void CloudFilterNode::sendNearest(const std_msgs::Header& header, const CloudPoints& points,
                                  const std::vector<RobotPoint>& removed) {
  const auto sensor = tf_.find(tfName("", header.frame_id));
  if (!sensor) return;
  const NearestPoints found = nearestPoints({points, removed, grids_, links_, tf_, *sensor});
  if (!found.problem.empty()) {
    health_.addWithoutNearest(found.problem);
    return;
  }
  nearest_.publish(nearestMessage(header, names_, found.links, incomplete_));
}

void CloudFilterNode::send(const Waiting& waiting, const std::vector<RobotPoint>& removed) {
  if (waiting.scan) {
    removePoints(removed, *waiting.scan);
  } else {
    sensor_msgs::PointCloud2& cloud = *waiting.cloud;
    if (robot_points_.getNumSubscribers() > 0) robot_points_.publish(onlyPoints(removed, cloud));
    removePoints(removed, robot_->parameters.keep_organized, cloud);
  }
  publish(waiting);
}

}  // namespace link_bounds
