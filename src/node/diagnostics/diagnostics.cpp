// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Level, one sentence, and figures.
#include "node/diagnostics/diagnostics.h"

#include <ros/this_node.h>
#include <ros/time.h>

#include <algorithm>

#include "node/log/log_text.h"

namespace link_bounds {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr std::size_t kMostObjectLines = 100;

void raise(DiagnosticStatus& status, std::int8_t level, const std::string& text) {
  status.level = std::max<std::int8_t>(status.level, level);
  status.message += (status.message.empty() ? "" : "; ") + text;
}

void add(DiagnosticStatus& status, const std::string& key, const std::string& value) {
  diagnostic_msgs::KeyValue pair;
  pair.key = logText(key);
  pair.value = logText(value);
  status.values.push_back(pair);
}

std::size_t countBoxes(const Scene& scene) {
  std::size_t count = 0;
  scene.forEach(
      [&count](const std::string&, const BoxState& state) { count += state.box ? 1 : 0; });
  return count;
}

bool hasLinkBox(const LiveBoxes& links) {
  return std::any_of(links.states().begin(), links.states().end(),
                     [](const BoxState& state) { return state.box.has_value(); });
}

void addIncomplete(const std::string& name, const std::string& reason, DiagnosticStatus& status) {
  add(status, "incomplete: " + name, reason);
}

/// Adds a line per incomplete link; returns how many there are.
std::size_t addIncomplete(const LiveBoxes& links, DiagnosticStatus& status) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < links.states().size(); ++i) {
    if (!links.states()[i].incomplete) continue;
    addIncomplete(links.model()->links[i].name, links.reason(i), status);
    ++count;
  }
  return count;
}

/// The same for objects, of which there may be very many.
std::size_t addIncomplete(const LiveObjects& objects, DiagnosticStatus& status) {
  std::size_t count = 0;
  for (const auto& [key, object] : objects.objects()) {
    if (!object.state.incomplete) continue;
    if (count < kMostObjectLines)
      addIncomplete(object.content.bounded.name, object.reason(), status);
    ++count;
  }
  return count;
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

void describeScene(const Scene& scene, DiagnosticStatus& status) {
  const Model& model = *scene.model();
  add(status, "fixed frame", model.fixed_frame);
  add(status, "bounded links", std::to_string(model.links.size()));
  add(status, "objects", std::to_string(scene.objects.objects().size()));
  add(status, "boxes", std::to_string(countBoxes(scene)));
  addMeshes(model, status);
  const std::size_t links = addIncomplete(scene.links, status);
  const std::size_t objects = addIncomplete(scene.objects, status);
  if (!hasLinkBox(scene.links) && !model.links.empty()) {
    raise(status, DiagnosticStatus::ERROR, "not one link has a box");
  }
  if (links > 0) raise(status, DiagnosticStatus::WARN, std::to_string(links) + " links incomplete");
  if (objects > 0) {
    raise(status, DiagnosticStatus::WARN, std::to_string(objects) + " objects incomplete");
  }
}

void addIntake(const TfIntake& intake, DiagnosticStatus& status) {
  add(status, "transforms taken", std::to_string(intake.taken));
  add(status, "of those late", std::to_string(intake.late));
  add(status, "transforms refused, stamp repeated", std::to_string(intake.repeated));
  add(status, "transforms refused, too old", std::to_string(intake.too_old));
  add(status, "transforms refused, unusable", std::to_string(intake.unusable));
  add(status, "transforms dropped after a clock jump", std::to_string(intake.dropped));
}

std::string nodeName() {
  const std::string name = ros::this_node::getName();
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

}  // namespace

diagnostic_msgs::DiagnosticArray diagnose(const Scene& scene, const Health& health) {
  DiagnosticStatus status;
  status.name = nodeName() + ": boxes";
  if (scene.model()) {
    describeScene(scene, status);
  } else if (!health.waits_for_description) {
    raise(status, DiagnosticStatus::ERROR, "the robot is still loading");
  }
  if (health.waits_for_description) {
    raise(status, DiagnosticStatus::WARN, "waiting for robot_description");
  }
  if (health.waits_for_clock) raise(status, DiagnosticStatus::WARN, "waiting for /clock");
  if (health.clock_jumped) raise(status, DiagnosticStatus::WARN, "the clock jumped back");
  if (status.level == DiagnosticStatus::OK) status.message = "all boxes complete";
  const DurationHistogram& tf = health.tf_callbacks_ms;
  add(status, "tf messages", std::to_string(tf.count()));
  addIntake(health.intake, status);
  add(status, "updates", std::to_string(health.updates));
  add(status, "updates per second", std::to_string(health.updates_per_second));
  add(status, "longest lag of boxes behind their stamp [ms]",
      health.lag_ms ? std::to_string(*health.lag_ms) : "none");
  add(status, "publications", std::to_string(health.publications));
  add(status, "time per tf message, p99 [ms]", std::to_string(tf.quantile(0.99)));
  add(status, "time per tf message, longest [ms]", std::to_string(tf.longest()));
  add(status, "longest callback [ms]", std::to_string(health.longest_callback_ms));
  add(status, "longest callback, CPU [ms]", std::to_string(health.longest_callback_cpu_ms));
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  array.status.push_back(status);
  return array;
}

}  // namespace link_bounds
