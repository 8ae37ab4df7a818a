// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From the inside out: each frame after the one that its edge leads to.
#include "world/history/way_bound.h"

#include <limits>

#include "world/tf/frame_paths.h"

namespace link_bounds {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

constexpr double kWayRounding = 1e-12;  // of all coordinates, as share of the largest

}  // namespace

double WayBound::of(Frame source, double radius, MotionSpan span) {
  if (version_ != tf_.version() || span.begin != span_.begin || span.end != span_.end) begin(span);
  const Node& node = nodeOf(source);
  if (!node.is_known) return kInfinite;
  const Height& height = heights_[node.height];
  const Map& link = node.top_from_node;
  const Map& target = height.top_from_target;
  // Steps 5, 3 and 4 of deviation_bound.h.
  const double start = link.inverse * target.inverse * radius;
  const double start_way = (link.stretch + target.stretch) * start;
  const double distance = link.reach + link.scale * start + target.reach;
  const double way = link.shift + link.turn * start + link.scale * start_way + target.shift;
  return height.turned_turn * distance + height.turned_scale * way + kWayRounding * distance;
}

/// The frames above the target come first: their nodes are where all ways end.
void WayBound::begin(MotionSpan span) {
  version_ = tf_.version();
  span_ = span;
  ++run_;
  nodes_.resize(tf_.size());
  heights_.assign(1, Height());
  climb(tf_, target_, [this](Frame frame) {
    Node& node = nodes_[frame];
    if (node.run == run_) return true;  // a loop
    node = {run_, true, heights_.size() - 1, Map()};
    const std::optional<EdgeWay>& edge = edges_.during(frame, span_);
    if (!edge) return true;
    const Height& below = heights_.back();
    Height next;
    next.top_from_target = before(below.top_from_target, *edge);
    next.turned_turn = below.turned_scale * edge->turn + below.turned_turn * edge->scale;
    next.turned_scale = below.turned_scale * edge->scale;
    heights_.push_back(next);
    return false;
  });
}

const WayBound::Node& WayBound::nodeOf(Frame source) {
  way_.clear();
  climb(tf_, source, [this](Frame frame) {
    if (frame >= nodes_.size()) nodes_.resize(tf_.size());
    Node& node = nodes_[frame];
    if (node.run == run_) return true;
    node = {run_, false, 0, Map()};
    way_.push_back(frame);
    return false;
  });
  for (std::size_t i = way_.size(); i-- > 0;) {
    if (!tf_.hasParent(way_[i])) continue;
    const Node& above = nodes_[tf_.parent(way_[i])];
    if (!above.is_known) continue;
    const std::optional<EdgeWay>& edge = edges_.during(way_[i], span_);
    if (edge) nodes_[way_[i]] = {run_, true, above.height, behind(above.top_from_node, *edge)};
  }
  return nodes_[source];
}

/// The points of the edge's child, where `map` is of its parent.
WayBound::Map WayBound::behind(const Map& map, const EdgeWay& edge) {
  return {map.scale * edge.scale,
          map.reach + map.scale * edge.distance,
          map.shift + map.turn * edge.distance + map.scale * edge.shift,
          map.turn * edge.scale + map.scale * edge.turn,
          map.stretch + edge.stretch,
          map.inverse * edge.inverse};
}

/// The same points one frame further up.
WayBound::Map WayBound::before(const Map& map, const EdgeWay& edge) {
  return {edge.scale * map.scale,
          edge.distance + edge.scale * map.reach,
          edge.shift + edge.turn * map.reach + edge.scale * map.shift,
          edge.turn * map.scale + edge.scale * map.turn,
          map.stretch + edge.stretch,
          map.inverse * edge.inverse};
}

}  // namespace link_bounds
