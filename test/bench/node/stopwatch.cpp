// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sends numbered tf messages to one node and takes the time until each is answered:
// NAMESPACE PID boxes|markers LINKS DEPTH HZ SECONDS
// Messages go to NAMESPACE/tf, answers come from NAMESPACE/node/boxes. Prints a row.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <time.h>
#include <visualization_msgs/MarkerArray.h>

#include <chrono>
#include <cstdint>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "bench/common/processes.h"
#include "bench/common/result.h"
#include "bench/common/tf_robot.h"
#include "link_bounds/AxisAlignedBoxArray.h"
#include "testing/patience.h"

namespace link_bounds::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kWarmUp = 0.3;  // s
constexpr std::uint32_t kUnlimited = 0;
constexpr std::chrono::seconds kPatience(20);  // for a connection
constexpr std::chrono::seconds kSilence(1);    // after the last answer; the others are lost
constexpr std::size_t kSwingPoses = 64;        // messages made beforehand, used in turn

/// When each message went and when its answer came; numbers are those of the messages.
class Times {
 public:
  explicit Times(std::size_t count) : sent_(count), answered_(count) {}

  void send(std::size_t number) { sent_[number] = Clock::now(); }

  void answer(std::size_t number) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (number >= answered_.size() || answered_[number] != Clock::time_point()) return;
    answered_[number] = Clock::now();
    ++answers_;
  }

  std::size_t answers() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return answers_;
  }

  /// Microseconds, of the messages from the first that counts.
  std::vector<double> latencies(std::size_t first) const {
    std::vector<double> result;
    for (std::size_t i = first; i < sent_.size(); ++i) {
      if (answered_[i] == Clock::time_point()) continue;
      result.push_back(std::chrono::duration<double, std::micro>(answered_[i] - sent_[i]).count());
    }
    return result;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Clock::time_point> sent_;  ///< written before the answer can come
  std::vector<Clock::time_point> answered_;
  std::size_t answers_ = 0;
};

struct Task {
  std::string name_space;
  pid_t pid;
  bool is_markers;
  TfRobot robot;
  double hz;
  double seconds;
};

double cpuSeconds(pid_t pid) {
  clockid_t clock;
  timespec time{};
  if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0)
    throw std::runtime_error("the node is gone");
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
}

/// Until all messages are answered, or no further answer comes.
void awaitAnswers(const Times& times, std::size_t count) {
  std::size_t answers = 0;
  for (auto end = Clock::now() + kSilence; answers < count && Clock::now() < end && ros::ok();) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (times.answers() > answers) end = Clock::now() + kSilence;
    answers = times.answers();
  }
}

/// Messages are numbered by their stamps.
class Stopwatch {
 public:
  explicit Stopwatch(const Task& task)
      : task_(task),
        first_(static_cast<std::size_t>(kWarmUp * task.hz)),
        count_(first_ + static_cast<std::size_t>(task.seconds * task.hz)),
        times_(count_),
        start_(ros::Time::now()),
        messages_(swing(task.robot, kSwingPoses)),
        publisher_(node_.advertise<tf2_msgs::TFMessage>(task.name_space + "/tf", kUnlimited)) {
    const std::string topic = task.name_space + "/node/boxes";
    if (task.is_markers) {
      subscribe<visualization_msgs::MarkerArray>(topic, [](const auto& array) {
        return array.markers.empty() ? ros::Time() : array.markers.front().header.stamp;
      });
    } else {
      subscribe<AxisAlignedBoxArray>(topic, [](const auto& array) { return array.header.stamp; });
    }
  }

  void run() {
    ros::AsyncSpinner spinner(1);
    spinner.start();
    const bool is_connected = becomesTrue(
        [this] {
          return publisher_.getNumSubscribers() == 1 && subscriber_.getNumPublishers() == 1;
        },
        kPatience, [] { return !ros::ok(); });
    if (!is_connected) throw std::runtime_error("no connection with " + task_.name_space);
    double cpu = 0;
    auto due = Clock::now();
    for (std::size_t i = 0; i < count_ && ros::ok(); ++i) {
      if (i == first_) cpu = cpuSeconds(task_.pid);
      send(i);
      due += std::chrono::nanoseconds(std::llround(1e9 / task_.hz));
      std::this_thread::sleep_until(due);
    }
    awaitAnswers(times_, count_);
    spinner.stop();
    print(cpuSeconds(task_.pid) - cpu);
  }

 private:
  template <class Message, class StampOf>
  void subscribe(const std::string& topic, const StampOf& stampOf) {
    subscriber_ = node_.subscribe<Message>(
        topic, kUnlimited,
        [this, stampOf](const boost::shared_ptr<const Message>& message) {
          const ros::Time stamp = stampOf(*message);
          if (stamp >= start_) times_.answer(numberOf(stamp));
          bytes_ = ros::serialization::serializationLength(*message);
        },
        {}, ros::TransportHints().tcpNoDelay());
  }

  ros::Time stampOf(std::size_t number) const {
    return start_ + ros::Duration(static_cast<double>(number) / task_.hz);
  }

  std::size_t numberOf(ros::Time stamp) const {
    return static_cast<std::size_t>(std::llround((stamp - start_).toSec() * task_.hz));
  }

  void send(std::size_t number) {
    tf2_msgs::TFMessage& message = messages_[number % kSwingPoses];
    for (auto& transform : message.transforms)
      transform.header.stamp = stampOf(number);
    times_.send(number);
    publisher_.publish(message);
  }

  void print(double cpu_seconds) const {
    const std::vector<double> latencies = times_.latencies(first_);
    const auto us = [&](double part) { return latencies.empty() ? -1 : quantile(latencies, part); };
    const std::size_t sent = count_ - first_;
    writeJson({{{"p50_us", us(0.5)},
                {"p90_us", us(0.9)},
                {"p99_us", us(0.99)},
                {"cpu_us_per_update", 1e6 * cpu_seconds / static_cast<double>(sent)},
                {"bytes", std::size_t{bytes_}},
                {"sent", sent},
                {"received", latencies.size()}}},
              std::cout);
  }

  ros::NodeHandle node_;  ///< the first, since it starts the clock
  const Task& task_;
  std::size_t first_;
  std::size_t count_;
  Times times_;
  ros::Time start_;
  std::vector<tf2_msgs::TFMessage> messages_;
  std::uint32_t bytes_ = 0;  ///< of an answer
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace

void runStopwatch(const Words& words) {
  const Task task{words[0],
                  std::stoi(words[1]),
                  words[2] == "markers",
                  tfRobot(std::stoul(words[3]), std::stoul(words[4])),
                  std::stod(words[5]),
                  std::stod(words[6])};
  Stopwatch(task).run();
}

}  // namespace link_bounds::bench
