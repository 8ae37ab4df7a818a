// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// CUBE, LINE_LIST and TEXT markers per box, and DELETE markers.
#include "node/outputs/markers/box_markers.h"

#include "link_bounds/ros/messages.h"
#include "node/outputs/markers/drawable.h"
#include "node/outputs/markers/label_layout.h"
#include "world/bodies/object_source.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

std::string objectsNamespace() {
  return std::string(kDrawingsNamespace) + "objects/";
}

enum MarkerId { kFaces = 0, kEdges = 1, kLabel = 2 };

constexpr double kMinSize = 1e-4;     ///< rviz cannot draw a box of zero size [m]
constexpr double kEdgeWidth = 0.002;  ///< [m]

void addFaces(Marker marker, const Eigen::Vector3d& radius, const std_msgs::ColorRGBA& color,
              MarkerArray& array) {
  marker.scale = toVector3(2 * radius);
  marker.color = color;
  array.markers.push_back(std::move(marker));
}

void addEdges(Marker marker, const Eigen::Vector3d& radius, std_msgs::ColorRGBA color,
              MarkerArray& array) {
  appendEdges(corners(Aabb(-radius, radius)), marker);
  color.a = 1;
  marker.color = color;
  marker.scale.x = kEdgeWidth;
  array.markers.push_back(std::move(marker));
}

/// placeLabels() sets the size and the position later.
void addLabel(Marker marker, const std::string& text, MarkerArray& array) {
  marker.text = text;
  marker.color = labelColor();
  array.markers.push_back(std::move(marker));
}

void addBox(const Aabb& box, const std::string& name, const std::string& ns,
            const std_msgs::Header& header, const Parameters& parameters, MarkerArray& array,
            std::vector<Label>& labels) {
  if (!isDrawable(box)) return;
  const auto [center, exact_radius] = toCenterRadius(box);
  const Eigen::Vector3d radius = exact_radius.cwiseMax(kMinSize / 2);
  const std_msgs::ColorRGBA color = toColor(parameters.marker_color);
  const auto marker = [&, &box_center = center](MarkerId id, int type) {
    Marker result = newMarker(header, ns, id, type);
    result.pose.position = toPoint(box_center);
    return result;
  };
  if (parameters.marker_style != "edges") {
    addFaces(marker(kFaces, Marker::CUBE), radius, color, array);
  }
  if (parameters.marker_style != "faces") {
    addEdges(marker(kEdges, Marker::LINE_LIST), radius, color, array);
  }
  if (parameters.marker_labels) {
    addLabel(marker(kLabel, Marker::TEXT_VIEW_FACING), name, array);
    labels.push_back(labelOf(box, name));
  }
}

/// `labels` has one entry per text marker of `array`, in the same order.
void placeLabels(std::vector<Label> labels, MarkerArray& array) {
  separate(labels);
  auto label = labels.begin();
  for (Marker& marker : array.markers) {
    if (marker.id != kLabel) continue;
    marker.pose.position = toPoint(label->bottom);
    marker.pose.position.z += label->height / 2;  // rviz centers a text at its position
    marker.scale.z = label->height;
    ++label;
  }
}

}  // namespace

MarkerArray boxMarkers(const Moment& moment) {
  const Model& model = *moment.model;
  MarkerArray array;
  std::vector<Label> labels;
  for (const Moment::Body& body : moment.bodies) {
    const std::string& name = moment.name(body);
    addBox(body.box, name, body.link ? model.frames[*body.link] : objectsNamespace() + name,
           moment.header, model.parameters, array, labels);
  }
  placeLabels(std::move(labels), array);
  return array;
}

void ShownMarkers::replaceBy(MarkerArray& markers, const std_msgs::Header& header, bool has_lost) {
  std::set<Key> added;
  for (const Marker& marker : markers.markers)
    added.emplace(marker.ns, marker.id);
  Marker end;
  end.header = header;
  end.pose.orientation.w = 1;
  if (has_lost) {
    end.action = Marker::DELETEALL;
    end.ns = kDrawingsNamespace;  // rviz ignores the namespace and deletes all markers
    markers.markers.insert(markers.markers.begin(), end);
    shown_.clear();
  }
  end.action = Marker::DELETE;
  for (const auto& [ns, id] : shown_) {
    if (added.count({ns, id})) continue;
    end.ns = ns;
    end.id = id;
    markers.markers.push_back(end);
  }
  shown_ = std::move(added);
}

void ShownMarkers::add(const MarkerArray& markers) {
  for (const Marker& marker : markers.markers)
    shown_.emplace(marker.ns, marker.id);
}

}  // namespace link_bounds
