// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs a node for long under tf at 1 kHz, time jumps, reloads and objects, and checks that its
// memory does not grow and no message is lost.
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "soak_listener.h"
#include "soak_objects.h"
#include "soak_program.h"
#include "soak_sender.h"
#include "testing/process_census.h"

namespace link_bounds {
namespace {

using Seconds = ros::WallDuration;

const std::string kPublisher = "/link_bounds_publisher";
const Seconds kPoll(0.01);
const Seconds kQuiet(3);  // three diagnostics without a change
const Seconds kMinute(60);
const Seconds kReloadPeriod(15);
const Seconds kFirstReload(7);  // so that no reload runs when memory is measured

/// The counters of both sides at one moment.
struct Counts {
  double tf_received;
  double boxes_published;
  double boxes_received;
};

bool operator==(const Counts& a, const Counts& b) {
  return a.tf_received == b.tf_received && a.boxes_published == b.boxes_published &&
         a.boxes_received == b.boxes_received;
}

Counts countsNow(const SoakListener& listener) {
  return {listener.diagnostic("tf messages"), listener.diagnostic("publications"),
          static_cast<double>(listener.boxes())};
}

/// Waits until no message is under way, then returns the counters.
Counts settledCounts(const SoakListener& listener) {
  Counts last = countsNow(listener);
  ros::SteadyTime since = ros::SteadyTime::now();
  waitFor(
      [&] {
        const Counts now = countsNow(listener);
        if (!(now == last)) {
          last = now;
          since = ros::SteadyTime::now();
        }
        return ros::SteadyTime::now() - since > kQuiet;
      },
      "all is quiet");
  return last;
}

/// Reloads periodically until the end; returns how often. Throws if the node refuses.
int reloadUntil(ros::SteadyTime end, ros::SteadyTime& next_reload) {
  int reloads = 0;
  while (ros::ok() && ros::SteadyTime::now() < end) {
    kPoll.sleep();
    if (ros::SteadyTime::now() < next_reload) continue;
    next_reload += kReloadPeriod;
    std_srvs::Trigger reload;
    if (!ros::service::call(kPublisher + "/reload", reload) || !reload.response.success) {
      throw std::runtime_error("the node does not reload: " + reload.response.message);
    }
    ++reloads;
  }
  return reloads;
}

/// The growth of memory after the first minute [bytes].
struct Growth {
  int minutes = 0;  ///< that were compared with the first one
  double at_end = 0;
  double largest = 0;  ///< of all minutes
};

Growth runFor(int minutes, int pid, const SoakSender& sender, const SoakObjects& objects,
              const SoakListener& listener) {
  const ros::SteadyTime start = ros::SteadyTime::now();
  ros::SteadyTime next_reload = start + kFirstReload;
  double first = 0;
  double resident = 0;
  Growth growth;
  int reloads = 0;
  for (int minute = 1; minute <= minutes; ++minute) {
    reloads += reloadUntil(start + kMinute * minute, next_reload);
    resident = static_cast<double>(residentBytes(pid));
    if (minute == 1) first = resident;
    growth = {minute - 1, resident - first, std::max(growth.largest, resident - first)};
    std::printf(
        "minute %3d: %9llu tf messages in, %9llu boxes and %7llu markers out, %4d reloads, "
        "%3llu time jumps, %8llu objects, %.3f MB resident\n",
        minute, static_cast<unsigned long long>(sender.sent()),
        static_cast<unsigned long long>(listener.boxes()),
        static_cast<unsigned long long>(listener.markers()), reloads,
        static_cast<unsigned long long>(sender.jumps()),
        static_cast<unsigned long long>(objects.sent()), resident / 1e6);
    std::fflush(stdout);
  }
  return growth;
}

/// Prints and returns how many messages were lost between two moments.
double reportLosses(double sent, const Counts& before, const Counts& after) {
  const double tf_lost = sent - (after.tf_received - before.tf_received);
  const double published = after.boxes_published - before.boxes_published;
  const double boxes_lost = published - (after.boxes_received - before.boxes_received);
  std::printf("lost: %.0f of %.0f tf messages, %.0f of %.0f boxes\n", tf_lost, sent, boxes_lost,
              published);
  return tf_lost + boxes_lost;
}

/// Prints what decides and returns whether it is good; growth and its limit are in bytes. The limit
/// is for the end: what the C library keeps free varies from minute to minute.
bool verdict(double lost, const Growth& growth, double max_growth, double boxless_links) {
  const bool is_good = lost == 0 && growth.at_end < max_growth && boxless_links == 0;
  std::printf("%s: %.0f messages lost (allowed: 0), %.0f links without a box (allowed: 0),\n",
              is_good ? "passed" : "FAILED", lost, boxless_links);
  if (growth.minutes == 0) {
    std::printf("  %s\n", kNoGrowth);
  } else {
    std::printf(
        "  memory %+.3f MB at the end (allowed: < %.3f MB), %+.3f MB in the largest minute\n",
        growth.at_end / 1e6, max_growth / 1e6, growth.largest / 1e6);
  }
  return is_good;
}

/// Returns whether all went well.
bool soak(const SoakArguments& arguments) {
  ros::NodeHandle node;
  const Robot robot = describedRobot(node);
  SoakListener listener(node, kPublisher);
  SoakSender sender(node, robot);
  SoakObjects objects(node, kPublisher, {robot.links[robot.root].name, robot.links.back().name});
  waitFor([&] { return sender.hasSubscriber() && objects.hasSubscriber(); }, "the node listens");
  waitFor([&] { return listener.diagnostic("bounded links") > 0; }, "the robot is loaded");
  const double links = listener.diagnostic("bounded links");
  std::printf("%s: %.0f links bounded\n", robot.name.c_str(), links);
  const Counts before = settledCounts(listener);
  sender.start();
  objects.start();
  const Growth growth = runFor(arguments.minutes, arguments.pid, sender, objects, listener);
  objects.stop();
  sender.stop();
  waitFor([&] { return listener.diagnostic("objects") == 0; }, "all objects are gone");
  const Counts after = settledCounts(listener);
  const double lost = reportLosses(static_cast<double>(sender.sent()), before, after);
  std::printf("update: mean of the worst second %.3f ms, worst %.3f ms\n",
              listener.largest("time per tf message, mean of the last second [ms]"),
              listener.diagnostic("time per tf message, longest [ms]"));
  return verdict(lost, growth, arguments.max_growth, links - listener.diagnostic("boxes"));
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) {
  return link_bounds::runSoak(argc, argv, "soak", link_bounds::soak);
}
