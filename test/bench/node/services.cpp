// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A client that asks for boxes while tf is sent, and an empty service in turn: LINKS DEPTH HZ
// REPETITIONS CALLS; and that service, the least that one of roscpp takes. They are
// /ours/node/get_boxes and /empty/node/service. Prints a row per repetition: the median time of a
// call of each kind [us].
#include <ros/ros.h>
#include <std_srvs/Empty.h>

#include <atomic>
#include <chrono>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "bench/common/processes.h"
#include "bench/common/row.h"
#include "bench/common/tf_robot.h"
#include "bench/common/timing.h"
#include "link_bounds/GetBoxes.h"

namespace link_bounds::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kPoses = 64;  // messages made beforehand, used in turn
constexpr const char* kEmpty = "/empty/node/service";
constexpr const char* kGetBoxes = "/ours/node/get_boxes";
constexpr double kHistory = 3;  // s, before the first call

/// Sends tf until it ends.
class Traffic {
 public:
  Traffic(ros::NodeHandle& node, const TfRobot& robot, double hz)
      : publisher_(node.advertise<tf2_msgs::TFMessage>("/ours/tf", 0)),
        messages_(swing(robot, kPoses)),
        thread_([this, hz] { run(hz); }) {}

  ~Traffic() {
    stops_ = true;
    thread_.join();
  }

 private:
  void run(double hz) {
    auto due = Clock::now();
    for (std::size_t i = 0; !stops_ && ros::ok(); ++i) {
      tf2_msgs::TFMessage& message = messages_[i % kPoses];
      const ros::Time now = ros::Time::now();
      for (auto& transform : message.transforms)
        transform.header.stamp = now;
      publisher_.publish(message);
      due += std::chrono::nanoseconds(std::llround(1e9 / hz));
      std::this_thread::sleep_until(due);
    }
  }

  std::atomic<bool> stops_{false};
  ros::Publisher publisher_;
  std::vector<tf2_msgs::TFMessage> messages_;
  std::thread thread_;
};

class Client {
 public:
  /// The services must be there already.
  Client(bool persistent, std::size_t links)
      : empty_(node_.serviceClient<std_srvs::Empty>(kEmpty, persistent)),
        boxes_(node_.serviceClient<GetBoxes>(kGetBoxes, persistent)),
        links_(links) {}

  double empty(int calls) {
    return medianTime<std::micro>(calls, [this] {
      std_srvs::Empty message;
      if (!empty_.call(message)) throw std::runtime_error("the empty service did not answer");
    });
  }

  /// Boxes so many seconds ago; 0: the latest.
  double boxes(int calls, double ago, double span) {
    return medianTime<std::micro>(calls, [&] {
      GetBoxes message;
      if (ago > 0) message.request.stamp = ros::Time::now() - ros::Duration(ago);
      message.request.span = ros::Duration(span);
      const bool is_answered = boxes_.call(message);
      if (!is_answered || message.response.boxes.boxes.size() < links_)
        throw std::runtime_error("not all boxes: " + message.response.message);
    });
  }

  /// The model is there.
  bool hasBoxes() {
    GetBoxes message;
    return boxes_.call(message) && message.response.boxes.boxes.size() == links_;
  }

 private:
  ros::NodeHandle node_;
  ros::ServiceClient empty_;
  ros::ServiceClient boxes_;
  std::size_t links_;
};

void run(std::size_t links, std::size_t depth, double hz, int repetitions, int calls) {
  ros::NodeHandle node;
  Traffic traffic(node, tfRobot(links, depth), hz);
  ros::service::waitForService(kEmpty);
  ros::service::waitForService(kGetBoxes);
  Client kept(true, links), fresh(false, links);
  while (ros::ok() && !fresh.hasBoxes())
    ros::Duration(0.1).sleep();
  ros::Duration(kHistory).sleep();
  Rows rows;
  for (int i = 0; i < repetitions; ++i) {
    rows.push_back({{"empty", kept.empty(calls)},
                    {"latest", kept.boxes(calls, 0, 0)},
                    {"0.1 s ago", kept.boxes(calls, 0.1, 0)},
                    {"2 s ago", kept.boxes(calls, 2, 0)},
                    {"span of 0.1 s", kept.boxes(calls / 10, 0.1, 0.1)},
                    {"empty, fresh connection", fresh.empty(calls / 10)},
                    {"latest, fresh connection", fresh.boxes(calls / 10, 0, 0)}});
  }
  writeJson(rows, std::cout);
}

bool doNothing(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
  return true;
}

}  // namespace

void runEmptyService(const Words&) {
  ros::NodeHandle private_node("~");
  const ros::ServiceServer service = private_node.advertiseService("service", doNothing);
  ros::spin();
}

void runServiceClient(const Words& words) {
  run(std::stoul(words[0]), std::stoul(words[1]), std::stod(words[2]), std::stoi(words[3]),
      std::stoi(words[4]));
}

}  // namespace link_bounds::bench
