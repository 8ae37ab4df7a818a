// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Time without transforms counts when the next one comes.
#include "tools/bag_bounds/boxes/coverage.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "robot/urdf/trimmed.h"
#include "world/tf/frame_paths.h"

namespace link_bounds {
namespace {

/// The prefixes P of all frames P/LINK that tf has.
std::set<std::string> prefixesOf(const std::string& link, const TransformBuffer& tf) {
  std::set<std::string> prefixes;
  for (TransformBuffer::Frame frame = 0; frame < tf.size(); ++frame) {
    const auto prefix = withoutEnd(tf.name(frame), "/" + link);
    if (tf.isMet(frame) && prefix && !prefix->empty()) prefixes.insert(*prefix);
  }
  return prefixes;
}

}  // namespace

void Coverage::sample(const Scene& scene, const TransformBuffer& tf, std::int64_t now) {
  const std::vector<BoxState>& states = scene.links.states();
  const bool has_begun =
      std::any_of(links_.begin(), links_.end(), [](const Link& link) { return link.has_begun; });
  links_.resize(states.size());
  if (!has_begun) last_ = now;
  for (std::size_t i = 0; i < states.size(); ++i) {
    add(links_[i], scene.links.frame(i), scene, tf, now);
    Link& link = links_[i];
    link.has_box = states[i].box.has_value();
    if (!link.had_box) lookForBox(link, scene.links.frame(i), scene, tf, now);
  }
  last_ = now;
  version_ = tf.version();
}

void Coverage::add(Link& link, TransformBuffer::Frame frame, const Scene& scene,
                   const TransformBuffer& tf, std::int64_t now) {
  const std::int64_t passed = std::max<std::int64_t>(now - last_, 0);
  const bool has_begun_now = !link.has_begun && tf.isMet(frame);
  link.has_begun |= has_begun_now;
  link.open_time += passed;
  if (has_begun_now) {
    link.begin = now;
    link.open_time = std::min(link.open_time, carrierTime(frame, scene, tf, now));
    link.since = now - link.open_time;
  }
  if (has_begun_now || !link.has_begun) return;
  if (link.has_box) link.open_covered += passed;
  const bool lasts = !tf.hasParent(frame) || tf.isStatic(frame);
  if (!lasts && !tf.isNewerThan(version_, frame)) return;
  link.time += std::exchange(link.open_time, 0);
  link.covered += std::exchange(link.open_covered, 0);
}

/// The time since the first transform of the frame that moves a link: its own frame, or the next
/// frame above static ones.
std::int64_t Coverage::carrierTime(TransformBuffer::Frame frame, const Scene& scene,
                                   const TransformBuffer& tf, std::int64_t now) const {
  const auto carrier = climb(tf, frame, [&tf](auto at) { return !tf.isStatic(at); });
  if (carrier == frame) return 0;
  if (!tf.hasParent(carrier)) return std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (scene.links.frame(i) == carrier && links_[i].has_begun) return now - links_[i].begin;
  }
  return 0;
}

std::vector<double> Coverage::shares() const {
  std::vector<double> result;
  for (const Link& link : links_) {
    const double no_time = link.has_box ? 1 : 0;
    result.push_back(link.time > 0
                         ? static_cast<double>(link.covered) / static_cast<double>(link.time)
                         : no_time);
  }
  return result;
}

/// Notes the delay of a first box. If no frame moves, a static transform came late.
void Coverage::lookForBox(Link& link, TransformBuffer::Frame frame, const Scene& scene,
                          const TransformBuffer& tf, std::int64_t now) {
  const TransformBuffer::Frame fixed = *scene.frames.fixedFrame();
  begins_.look(tf, frame, now);
  begins_.look(tf, fixed, now);
  link.had_box = link.has_box;
  if (!link.has_box || !link.has_begun) return;
  const auto since = begins_.allSince(tf, fixed, frame, now);
  link.delay = std::max(link.delay, now - since.value_or(link.since));
}

void Coverage::jumpBack(std::int64_t to) {
  begins_.clear();
  for (Link& link : links_) {
    link.had_box = false;
    link.since = to;
  }
}

std::vector<std::int64_t> Coverage::delays() const {
  std::vector<std::int64_t> result;
  for (const Link& link : links_)
    result.push_back(link.delay);
  return result;
}

std::string lateRemedy(std::size_t i, const std::string& bag, const Scene& scene,
                       const TransformBuffer& tf) {
  const std::vector<TransformBuffer::Frame> way = wayUp(tf, scene.links.frame(i));
  const bool is_any_static =
      std::any_of(way.begin(), way.end(), [&](auto frame) { return tf.isStatic(frame); });
  return is_any_static ? "if a static transform was recorded late, add --static-from " + bag : "";
}

std::string frameRemedy(std::size_t i, const Scene& scene, const TransformBuffer& tf) {
  const Model& model = *scene.model();
  if (scene.links.problem(i) != TransformProblem::kNoTransform) return "";
  const std::string& frame = model.frames[i];
  const std::string link = tfName("", model.links[i].name);
  if (!tf.isMet(scene.links.frame(i))) {
    const std::set<std::string> prefixes = prefixesOf(link, tf);
    std::string names;
    for (const std::string& prefix : prefixes)
      names += (names.empty() ? "--tf-prefix " : " or --tf-prefix ") + prefix;
    if (!prefixes.empty()) return "tf has \"" + *prefixes.begin() + "/" + link + "\"; add " + names;
    const auto bare = tf.find(link);
    if (frame != link && bare && tf.isMet(*bare))
      return "tf has \"" + link + "\"; leave out --tf-prefix";
  }
  const std::string& top = tf.name(wayUp(tf, scene.links.frame(i)).back());
  return "nothing leads up from \"" + top +
         "\"; if its static transform was recorded elsewhere, as in the first part of a split "
         "recording, add --static-from FIRST.bag";
}

}  // namespace link_bounds
