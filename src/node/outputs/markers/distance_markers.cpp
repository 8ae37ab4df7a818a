// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Always the same three marker ids, so that no old marker stays in rviz.
#include "node/outputs/markers/distance_markers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "node/outputs/markers/drawable.h"
#include "node/outputs/markers/label_layout.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

/// ObjectSource ignores markers whose namespaces begin with "link_bounds/".
constexpr char kNamespace[] = "link_bounds/distances";

constexpr double kLineWidth = 0.004;    ///< [m]
constexpr double kNearestWidth = 0.01;  ///< visibly thicker, to be recognised without colors [m]
constexpr double kTextHeight = 0.05;    ///< [m]

bool areDrawable(const Distance& distance) {
  const auto is_below = [](const geometry_msgs::Point& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kMaxDrawable;
  };
  return is_below(distance.on_first) && is_below(distance.on_second);
}

/// From red at `red` through yellow to green at `limit`.
std_msgs::ColorRGBA colorOf(double distance, double red, double limit) {
  const double share = limit > red ? std::clamp((distance - red) / (limit - red), 0.0, 1.0) : 0;
  return toColor({std::min(1.0, 2 - 2 * share), std::min(1.0, 2 * share) * 0.8, 0, 1});
}

void addLine(const Distance& distance, const std_msgs::ColorRGBA& color, Marker& lines) {
  lines.action = Marker::ADD;
  lines.points.push_back(distance.on_first);
  lines.points.push_back(distance.on_second);
  lines.colors.resize(lines.points.size(), color);
}

Marker marker(const std_msgs::Header& header, int id, int type) {
  Marker result = newMarker(header, kNamespace, id, type);
  result.action = Marker::DELETE;
  result.color.a = 1;
  return result;
}

/// In metres: to the millimetre below 0.1 m, else to the centimetre.
std::string textOf(double distance) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), distance < 0.1 ? "%.3f m" : "%.2f m", distance);
  return text.data();
}

geometry_msgs::Point middleOf(const Distance& distance) {
  geometry_msgs::Point point;
  point.x = (distance.on_first.x + distance.on_second.x) / 2;
  point.y = (distance.on_first.y + distance.on_second.y) / 2;
  point.z = (distance.on_first.z + distance.on_second.z) / 2 + 2 * kTextHeight;
  return point;
}

}  // namespace

visualization_msgs::MarkerArray distanceMarkers(const DistanceArray& distances,
                                                const Distance& nearest, double red, double limit) {
  Marker lines = marker(distances.header, 0, Marker::LINE_LIST);
  lines.scale.x = kLineWidth;
  for (const Distance& distance : distances.distances)
    if (areDrawable(distance)) addLine(distance, colorOf(distance.distance, red, limit), lines);
  Marker text = marker(distances.header, 1, Marker::TEXT_VIEW_FACING);
  Marker line = marker(distances.header, 2, Marker::LINE_LIST);
  line.scale.x = kNearestWidth;
  if (!nearest.first.empty() && areDrawable(nearest)) {
    addLine(nearest, colorOf(nearest.distance, red, limit), line);
    text.action = Marker::ADD;
    text.text = textOf(nearest.distance);
    text.pose.position = middleOf(nearest);
    text.scale.z = kTextHeight;
    text.color = labelColor();
  }
  visualization_msgs::MarkerArray array;
  array.markers = {std::move(lines), std::move(text), std::move(line)};
  return array;
}

}  // namespace link_bounds
