// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sends tf at a rate and measures how old ~boxes of each node become:
// load_driver [--slides] LINKS HZ SECONDS NODE ...
// With --slides the links do not turn, as those of prismatic joints.
// Waits until the last message is answered, and prints a line of JSON for each node.
#include <ros/ros.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "node/load/ages.h"
#include "node/load/boxes_stamp.h"
#include "node/load/swinging_links.h"
#include "testing/patience.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience(30);  // for connections, and for the last answer
constexpr std::uint32_t kUnlimited = 0;
constexpr double kPhasePerMessage = 0.01;  // rad

bool waitFor(const std::function<bool()>& condition) {
  return becomesTrue(condition, kPatience, [] { return !ros::ok(); });
}

struct Task {
  std::size_t links;
  double hz;
  double seconds;
  bool slides;
};

void stopTurning(tf2_msgs::TFMessage& message) {
  for (geometry_msgs::TransformStamped& transform : message.transforms) {
    transform.transform.rotation = geometry_msgs::Quaternion();
    transform.transform.rotation.w = 1;
  }
}

/// The ages of one node's boxes.
struct Measured {
  Ages ages;
  ros::Subscriber boxes;

  void subscribe(ros::NodeHandle& node, const std::string& name) {
    boxes = node.subscribe<BoxesStamp>(
        name + "/boxes", kUnlimited,
        [this](const boost::shared_ptr<const BoxesStamp>& message) { ages.answer(message->stamp); },
        {}, ros::TransportHints().tcpNoDelay());
  }
};

using Nodes = std::deque<Measured>;

/// The rate at which it sent [Hz].
double send(const Task& task, const ros::Publisher& tf, Nodes& nodes) {
  const auto count = static_cast<std::size_t>(task.hz * task.seconds);
  const auto start = Clock::now();
  for (std::size_t i = 0; i < count && ros::ok(); ++i) {
    const std::chrono::duration<double> due(static_cast<double>(i) / task.hz);
    std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(due));
    const ros::Time stamp = ros::Time::now();
    auto message = swingingLinks(task.links, kPhasePerMessage * static_cast<double>(i), stamp);
    if (task.slides) stopTurning(message);
    for (Measured& node : nodes)
      node.ages.send(stamp);
    tf.publish(message);
  }
  return static_cast<double>(count) / std::chrono::duration<double>(Clock::now() - start).count();
}

void drive(const Task& task, const std::vector<std::string>& names) {
  ros::NodeHandle node;
  const ros::Publisher tf = node.advertise<tf2_msgs::TFMessage>("/tf", kUnlimited);
  Nodes nodes(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    nodes[i].subscribe(node, names[i]);
  const auto all = [&nodes](const auto& condition) {
    return waitFor([&] { return std::all_of(nodes.begin(), nodes.end(), condition); });
  };
  ros::AsyncSpinner spinner(1);
  spinner.start();
  if (!waitFor([&] { return tf.getNumSubscribers() >= nodes.size(); }) ||
      !all([](const Measured& measured) { return measured.boxes.getNumPublishers() > 0; }))
    throw std::runtime_error("no connection with a node");
  const StallWatch stalls;
  const double hz = send(task, tf, nodes);
  all([](const Measured& measured) { return measured.ages.isAllAnswered(); });
  spinner.stop();
  for (const Measured& measured : nodes) {
    std::cout << "{";
    measured.ages.print(std::cout);
    std::cout << ", \"hz\": " << hz << ", \"stall_ms\": " << stalls.longest() << "}\n";
  }
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) try {
  ros::init(argc, argv, "load_driver", ros::init_options::AnonymousName);
  const bool slides = argc > 1 && argv[1] == std::string("--slides");
  char** const first = argv + (slides ? 2 : 1);
  if (argv + argc - first < 4)
    throw std::runtime_error("usage: load_driver [--slides] LINKS HZ SECONDS NODE ...");
  link_bounds::drive({std::stoul(first[0]), std::stod(first[1]), std::stod(first[2]), slides},
                     {first + 3, argv + argc});
} catch (const std::exception& error) {
  std::cerr << "load_driver: " << error.what() << "\n";
  return 1;
}
