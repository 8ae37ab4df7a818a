// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A test for rostest: a published box is what and where it should be.
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/assert_box/box_watch.h"
#include "tools/assert_box/test_report.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPeriod = 0.01;  // wall s between two looks at the deadline
constexpr std::uint32_t kQueueSize = 1000;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Options {
  bool help = false;
  std::string xml_file;  ///< "": none is written
};

/// ROS has taken its own arguments before. The file is known even if another argument is wrong.
Options parseOptions(const std::vector<std::string>& arguments, std::string& fault) {
  constexpr std::string_view kOutput = "--gtest_output=xml:";
  Options options;
  for (const std::string& argument : arguments) {
    if (argument.compare(0, kOutput.size(), kOutput) == 0) {
      options.xml_file = argument.substr(kOutput.size());
    } else if (argument == "--help" || argument == "-h") {
      options.help = true;
    } else if (argument != "--text") {
      fault = "unknown argument: " + argument + "; see --help";
    }
  }
  return options;
}

/// Returns "" as soon as the assertion has held, or why it did not.
std::string awaitBox(const BoxAssertion& assertion, Clock::time_point start) {
  ros::NodeHandle node;
  BoxWatch watch(assertion);
  const auto on_boxes = [&](const AxisAlignedBoxArray::ConstPtr& message) {
    watch.see(message, secondsSince(start));
  };
  const ros::Subscriber subscriber =
      node.subscribe<AxisAlignedBoxArray>(assertion.topic, kQueueSize, on_boxes,
                                          ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  bool had_publisher = false;
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kPeriod));
    const double now = secondsSince(start);
    if (watch.isPassed(now)) return "";
    if (now > assertion.deadline) return watch.failure(now);
    const bool has_publisher = subscriber.getNumPublishers() > 0;
    if (had_publisher && !has_publisher) watch.losePublisher(now);
    had_publisher = has_publisher;
  }
  return "interrupted\n" + watch.failure(secondsSince(start));
}

/// The test's name follows the assertion as soon as that is known.
std::string runTest(std::string& test, Clock::time_point start) {
  try {
    if (!ros::master::check())
      return "no ROS master answers at " + ros::master::getURI() + "; start it by rostest";
    const BoxAssertion assertion = readBoxAssertion();
    test = assertion.name + " " + assertion.check;
    return awaitBox(assertion, start);
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// For people on the terminal, for rostest in the file.
int finish(const TestReport& report, const std::string& xml_file) {
  if (report.failure.empty()) {
    std::cout << "passed: " << report.test << std::endl;
  } else {
    std::cerr << "failed: " << report.failure << std::endl;
  }
  try {
    if (!xml_file.empty()) writeFile(xml_file, junitXml(report));
  } catch (const std::exception& error) {
    std::cerr << "failed: " << error.what() << std::endl;
    return 1;
  }
  return report.failure.empty() ? 0 : 1;
}

int run(int argc, char** argv) {
  const Clock::time_point start = Clock::now();
  TestReport report{"assert_box", "parameters", 0.0, ""};
  std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    ros::init(argc, argv, report.suite);
    // roscpp handles SIGINT only; rostest also sends SIGTERM.
    std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
    arguments.assign(argv + 1, argv + argc);
    report.suite = ros::this_node::getName().substr(1);
  } catch (const std::exception& error) {
    report.failure = error.what();
  }
  const Options options = parseOptions(arguments, report.failure);
  if (options.help) {
    std::cout << assertBoxUsage();
    return 0;
  }
  if (report.failure.empty()) report.failure = runTest(report.test, start);
  report.seconds = secondsSince(start);
  return finish(report, options.xml_file);
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) {
  return link_bounds::run(argc, argv);
}
