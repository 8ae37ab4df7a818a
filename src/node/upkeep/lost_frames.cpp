// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each log line names the frame and its usual causes.
#include "node/upkeep/lost_frames.h"

#include <map>

#include "text/joined.h"

namespace link_bounds {
namespace {

bool isLost(TransformProblem problem) {
  return problem == TransformProblem::kNoTransform || problem == TransformProblem::kStale ||
         problem == TransformProblem::kNotCarried;
}

std::string andMore(std::size_t count, const std::string& what) {
  return count > 1 ? " (and " + std::to_string(count - 1) + " more " + what + ")" : "";
}

/// True if parameter fixed_frame is set and no link has a transform to it.
bool isFixedFrameLost(const LiveBoxes& links) {
  const Model& model = *links.model();
  if (model.parameters.fixed_frame.empty()) return false;
  bool has_links = false;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (model.links[i].shapes.empty()) continue;
    if (links.problem(i) != TransformProblem::kNoTransform) return false;
    has_links = true;
  }
  return has_links;
}

std::string fixedFrameLine(const std::string& fixed_frame) {
  return "no link has had a transform to fixed_frame " + quoted(fixed_frame) +
         " for 5 s; usual causes: the name is misspelt, or what publishes the transforms between "
         "it and the links does not run (robot_state_publisher, localization)";
}

struct LostLinks {
  std::vector<std::string> names;
  std::vector<std::size_t> indices;
};

LostLinks lostLinks(const LiveBoxes& links) {
  LostLinks result;
  for (std::size_t i = 0; i < links.states().size(); ++i) {
    if (!isLost(links.problem(i))) continue;
    result.names.push_back(links.model()->links[i].name);
    result.indices.push_back(i);
  }
  return result;
}

std::string linkLine(const LiveBoxes& links, std::size_t i, std::size_t count) {
  const bool is_stale = links.problem(i) == TransformProblem::kStale;
  return "link " + quoted(links.model()->links[i].name) + andMore(count, "links") +
         " has had no box for 5 s: " + links.reason(i) + "; usual causes: robot_state_publisher " +
         (is_stale ? "has ended, its joint_states have stopped, or its clock was set back"
                   : "does not run, or nobody publishes joint_states for its joints");
}

/// An object whose frame is lost, and the problem of that frame.
struct LostObject {
  const LiveObject* object;
  TransformProblem problem;
};

/// The first lost object per header frame. An object that waits for the transform at its stamp may
/// only be early, so its frame is checked at the newest time instead.
std::map<std::string, LostObject> lostObjects(Scene& scene) {
  std::map<std::string, LostObject> result;
  std::map<FrameTracker::Frame, TransformProblem> now;  // current problem per frame
  for (const auto& [key, object] : scene.objects.objects()) {
    TransformProblem problem = object.problem;
    if (problem == TransformProblem::kWaiting) {
      const auto [entry, is_new] = now.try_emplace(object.frame, problem);
      if (is_new) entry->second = scene.frames.follow(object.frame).pose().problem;
      problem = entry->second;
    }
    if (isLost(problem))
      result.try_emplace(scene.objects.neededFrame(object), LostObject{&object, problem});
  }
  return result;
}

std::string objectLine(const std::string& frame, const LostObject& lost, std::size_t count,
                       const std::string& fixed_frame) {
  const ObjectContent& content = *lost.object->content;
  return "object " + quoted(content.bounded.name) + " from " + quoted(content.publisher) +
         andMore(count, "header frames") +
         " has had no transform for 5 s: " + describe(lost.problem, frame, fixed_frame) +
         "; usual causes: the frame " + quoted(frame) + " is misspelt, or nobody publishes it";
}

}  // namespace

std::vector<std::string> LostFrames::warnings(Scene& scene, ros::SteadyTime now) {
  std::vector<std::string> lines;
  if (!scene.model()) return lines;
  const std::string& fixed_frame = scene.model()->fixed_frame;
  const LostLinks links = lostLinks(scene.links);
  const std::map<std::string, LostObject> objects = lostObjects(scene);
  std::vector<std::string> frames;
  for (const auto& [frame, lost] : objects)
    frames.push_back(frame);
  if (isFixedFrameLost(scene.links)) {
    if (!fixed_frame_.due({fixed_frame}, now).empty()) lines.push_back(fixedFrameLine(fixed_frame));
    links_.postpone(links.names, now);
    objects_.postpone(frames, now);
    return lines;
  }
  fixed_frame_.due({}, now);
  if (const auto due = links_.due(links.names, now); !due.empty())
    lines.push_back(linkLine(scene.links, links.indices[due.front()], due.size()));
  if (const auto due = objects_.due(frames, now); !due.empty()) {
    const std::string& frame = frames[due.front()];
    lines.push_back(objectLine(frame, objects.at(frame), due.size(), fixed_frame));
  }
  return lines;
}

}  // namespace link_bounds
