// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A status has a level, a message, and key-value pairs.
#include "node/upkeep/diagnostics.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/this_node.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "node/inputs/tf_receiver.h"
#include "node/interface/topics.h"
#include "node/upkeep/status.h"
#include "text/joined.h"
#include "world/log/log_text.h"

namespace link_bounds {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr std::size_t kMaxObjectLines = 100;  // max lines; the counts include all objects
constexpr std::size_t kMaxPublisherLines = 100;
constexpr double kMaxAge = 100;           // ms; a warning if boxes are older when they are sent
constexpr double kMaxBehind = 2;          // s; a warning if distances are farther behind boxes
constexpr double kMaxOtherBehind = 0.25;  // s; the same for other topics

struct BodyCounts {
  std::size_t boxes = 0;
  std::size_t boxes_of_links = 0;
  std::size_t incomplete_links = 0;
  std::size_t incomplete_objects = 0;
};

BodyCounts countBodies(const Scene& scene) {
  BodyCounts counts;
  scene.forEach([&counts](const SceneBody& body) {
    const std::size_t has_box = body.state.box ? 1 : 0;
    counts.boxes += has_box;
    if (body.link) counts.boxes_of_links += has_box;
    std::size_t& incomplete = body.link ? counts.incomplete_links : counts.incomplete_objects;
    incomplete += body.state.incomplete ? 1 : 0;
  });
  return counts;
}

/// One entry per incomplete body, but at most kMaxObjectLines for objects.
void addIncomplete(const Scene& scene, DiagnosticStatus& status) {
  std::size_t objects = 0;
  scene.forEach([&](const SceneBody& body) {
    if (!body.state.incomplete) return;
    if (body.object && ++objects > kMaxObjectLines) return;
    add(status, "incomplete: " + body.name, scene.reason(body));
  });
}

/// Adds the age of the link box with the oldest stamp; fixed links are ignored. With a slow
/// publisher that box may be as old as parameter `timeout`.
void addOldest(const Scene& scene, DiagnosticStatus& status) {
  std::int64_t oldest = 0;
  std::string name;
  scene.forEach([&](const SceneBody& body) {
    const std::int64_t stamp = body.state.box && body.link ? body.state.stamp : 0;
    if (stamp == 0 || (oldest != 0 && stamp >= oldest)) return;
    oldest = stamp;
    name = body.name;
  });
  const double age_ms = ros::Time::now().toSec() * 1e3 - static_cast<double>(oldest) / 1e6;
  add(status, "oldest box of a link [ms]",
      name.empty() ? "none" : std::to_string(age_ms) + " (" + name + ")");
}

void addMeshes(const Model& model, DiagnosticStatus& status) {
  std::size_t total = 0;
  for (const auto& [path, bytes] : model.mesh_bytes)
    total += bytes;
  add(status, "meshes", std::to_string(model.mesh_bytes.size()));
  add(status, "mesh memory [bytes]", std::to_string(total));
  for (const auto& [path, bytes] : model.mesh_bytes)
    add(status, "memory of " + path + " [bytes]", std::to_string(bytes));
}

std::string incompleteGroups(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneGroup& group : scene.model()->groups)
    if (groupState(group, scene).incomplete) names.push_back(group.name);
  return names.empty() ? "none" : joined(names, ", ");
}

void describeScene(const Scene& scene, const Health& health, DiagnosticStatus& status) {
  const Model& model = *scene.model();
  add(status, "fixed frame", model.fixed_frame);
  add(status, "bounded links", std::to_string(model.links.size()));
  add(status, "objects", std::to_string(scene.objects.objects().size()));
  const BodyCounts counts = countBodies(scene);
  add(status, "boxes", std::to_string(counts.boxes));
  add(status, "left out", model.left_out.empty() ? "none" : model.left_out);
  add(status, "incomplete groups", incompleteGroups(scene));
  addOldest(scene, status);
  addMeshes(model, status);
  addIncomplete(scene, status);
  if (model.links.empty() && health.awaited_description.empty()) {
    raise(status, DiagnosticStatus::WARN, "no link is bounded");
  } else if (counts.boxes_of_links == 0 && !model.links.empty()) {
    raise(status, DiagnosticStatus::ERROR, "not one link has a box");
  }
  const std::size_t links = counts.incomplete_links, objects = counts.incomplete_objects;
  if (links > 0) raise(status, DiagnosticStatus::WARN, std::to_string(links) + " links incomplete");
  if (objects > 0)
    raise(status, DiagnosticStatus::WARN, std::to_string(objects) + " objects incomplete");
}

std::string nearestText(const Distance& nearest) {
  return nearest.first + " and " + nearest.second + " may be only " +
         std::to_string(nearest.distance) + " m apart";
}

void addIntake(const TfIntake& intake, DiagnosticStatus& status) {
  add(status, "transforms taken", std::to_string(intake.accepted));
  add(status, "of those late", std::to_string(intake.late));
  add(status, "transforms refused, stamp repeated", std::to_string(intake.repeated));
  add(status, "of those with another pose", std::to_string(intake.other));
  add(status, "transforms refused, too old", std::to_string(intake.too_old));
  add(status, "transforms refused, unusable", std::to_string(intake.unusable));
  add(status, "transforms dropped after a clock jump", std::to_string(intake.dropped));
}

void addLatePublishers(const LateTexts& publishers, DiagnosticStatus& status) {
  add(status, "publishers behind", std::to_string(publishers.size()));
  std::size_t count = 0;
  for (const auto& [publisher, text] : publishers) {
    if (++count > kMaxPublisherLines) return;
    add(status, "publisher behind: " + publisher, text);
  }
}

/// `seconds` is the time since the last status.
void addDistances(const DistanceHealth& health, double seconds, DiagnosticStatus& status) {
  const auto count = static_cast<double>(health.times.count);
  const auto text = [](bool is_known, double value) {
    return is_known ? std::to_string(value) : "none";
  };
  const bool has_nearest = health.nearest && !health.nearest->first.empty();
  add(status, "distances", health.is_wanted ? "computed" : "silent: nobody subscribes");
  add(status, "nearest", has_nearest ? nearestText(*health.nearest) : "none");
  add(status, "distance pairs", std::to_string(health.pairs));
  add(status, "pairs left out of ~distances", std::to_string(health.left_out));
  add(status, "distance pairs decided by boxes", std::to_string(health.levels[Distance::BOX]));
  add(status, "distance pairs decided by hulls", std::to_string(health.levels[Distance::HULL]));
  add(status, "distance pairs decided by meshes", std::to_string(health.levels[Distance::MESH]));
  add(status, "without triangles", health.errors.empty() ? "none" : joined(health.errors, "; "));
  add(status, "distances per second", std::to_string(count / seconds));
  add(status, "time per distances, mean of the last second [ms]",
      text(count > 0, health.times.mean()));
  add(status, "time per distances, maximum of the last second [ms]",
      text(count > 0, health.times.max));
  add(status, "distances behind boxes [s]", std::to_string(health.behind));
}

void warnOfDistance(const DistanceHealth& health, double warning, DiagnosticStatus& status) {
  const auto seconds = std::lround(health.behind);
  if (warning > 0 && health.behind > kMaxBehind)
    raise(status, DiagnosticStatus::WARN, std::to_string(seconds) + " s without new distances");
  if (!health.nearest || health.nearest->first.empty()) return;
  if (warning > 0 && health.nearest->distance <= warning)
    raise(status, DiagnosticStatus::WARN, logText(nearestText(*health.nearest)));
}

void addTimes(CallbackTimes& times, DiagnosticStatus& status) {
  const Durations recent = times.takeRecentTf();
  const auto text = [&recent](double value) {
    return recent.count > 0 ? std::to_string(value) : "none";
  };
  add(status, "time per tf message, mean of the last second [ms]", text(recent.mean()));
  add(status, "time per tf message, maximum of the last second [ms]", text(recent.max));
  add(status, "time per tf message, longest [ms]", std::to_string(times.tf().max));
  add(status, "longest callback [ms]", std::to_string(times.longest()));
  add(status, "longest callback, CPU [ms]", std::to_string(times.longestCpu()));
}

/// The warning about old boxes; names the part of the age that this node causes.
std::string ageText(double age_ms, double delay_ms) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << "boxes were up to " << age_ms
       << " ms old when they were sent; the longest delay in this node was " << delay_ms << " ms";
  return text.str();
}

/// The delay that max_rate adds is intended, so it raises the limit.
void warnOfAge(const Health& health, double max_rate, DiagnosticStatus& status) {
  const double age_ms = std::max(health.lag_ms.value_or(0), health.delay_ms);
  if (age_ms > kMaxAge + (max_rate > 0 ? 1e3 / max_rate : 0))
    raise(status, DiagnosticStatus::WARN, ageText(age_ms, health.delay_ms));
}

std::string behindText(const std::string& topic, double seconds) {
  return "~" + topic + " was up to " + std::to_string(std::lround(seconds * 1e3)) +
         " ms behind ~boxes";
}

void warnOfBehind(const std::map<std::string, double>& behind, DiagnosticStatus& status) {
  for (const auto& [topic, seconds] : behind) {
    if (seconds > kMaxOtherBehind)
      raise(status, DiagnosticStatus::WARN, behindText(topic, seconds));
  }
}

std::string nodeName() {
  const std::string name = ros::this_node::getName();
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

void assess(const Scene& scene, const Health& health, std::uint64_t last_errors,
            DiagnosticStatus& status) {
  if (scene.model()) {
    describeScene(scene, health, status);
  } else if (health.awaited_description.empty()) {
    raise(status, DiagnosticStatus::ERROR, "the robot is still loading");
  }
  if (!health.awaited_description.empty()) {
    raise(status, DiagnosticStatus::WARN, "waiting for " + logText(health.awaited_description));
  }
  if (scene.model())
    warnOfDistance(health.distances, scene.model()->parameters.distance_warning, status);
  if (scene.model()) warnOfAge(health, scene.model()->parameters.max_rate, status);
  warnOfBehind(health.behind, status);
  if (health.skipped > 0)
    raise(status, DiagnosticStatus::WARN, "tf comes faster than it can be read");
  if (health.max_waiting >= TfReceiver::kQueue)
    raise(status, DiagnosticStatus::WARN,
          "messages of /tf, ~objects or ~neighbours may have been dropped");
  if (health.waits_for_clock) raise(status, DiagnosticStatus::WARN, "waiting for /clock");
  if (!health.late_publishers.empty())
    raise(status, DiagnosticStatus::WARN, "stamps of a publisher run behind");
  if (health.clock_jumped) raise(status, DiagnosticStatus::WARN, "the clock jumped back");
  if (health.errors > last_errors)
    raise(status, DiagnosticStatus::ERROR,
          std::to_string(health.errors - last_errors) + kUnexpectedErrors);
  if (status.level == DiagnosticStatus::OK) status.message = "all boxes complete";
}

}  // namespace

Diagnostics::Diagnostics(ros::NodeHandle& node)
    : publisher_(node.advertise<diagnostic_msgs::DiagnosticArray>(kDiagnosticsTopic.name, 10)) {}

void Diagnostics::publish(const Scene& scene, const Health& health, CallbackTimes& times) {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  DiagnosticStatus& status = array.status.emplace_back();
  status.name = nodeName() + ": boxes";
  assess(scene, health, std::exchange(last_errors_, health.errors), status);
  add(status, "tf messages", std::to_string(times.tf().count));
  addIntake(health.intake, status);
  add(status, "clock jumps", std::to_string(health.clock_jumps));
  addLatePublishers(health.late_publishers, status);
  add(status, "updates", std::to_string(health.updates));
  const double seconds = secondsSinceLast();
  const auto updates =
      static_cast<double>(health.updates - std::exchange(last_updates_, health.updates));
  add(status, "updates per second", std::to_string(updates / seconds));
  add(status, "updates joined, last second", std::to_string(health.joined));
  add(status, "tf messages skipped, last second", std::to_string(health.skipped));
  add(status, "most messages that waited, last second", std::to_string(health.max_waiting));
  add(status, "longest delay of a message in the node [ms]", std::to_string(health.delay_ms));
  add(status, "longest lag of boxes behind their stamp [ms]",
      health.lag_ms ? std::to_string(*health.lag_ms) : "none");
  add(status, "publications", std::to_string(health.publications));
  add(status, "unexpected errors", std::to_string(health.errors));
  add(status, "footprint", health.footprint);
  if (!health.stopping.empty()) add(status, "stopping", "incomplete: " + health.stopping);
  if (!health.earliest.empty()) add(status, "earliest", "incomplete: " + health.earliest);
  for (const auto& [topic, behind] : health.behind)
    add(status, topic + " behind boxes, maximum of the last second [s]", std::to_string(behind));
  addDistances(health.distances, seconds, status);
  addTimes(times, status);
  publisher_.publish(array);
}

/// Wall time since the last status.
double Diagnostics::secondsSinceLast() {
  const ros::SteadyTime now = ros::SteadyTime::now();
  return (now - std::exchange(last_status_, now)).toSec();
}

}  // namespace link_bounds
