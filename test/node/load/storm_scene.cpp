// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Cubes stand on a grid so that neighbours nearly touch; every tenth follows a link.
#include "node/load/storm_scene.h"

#include <cmath>

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr int kCubes = 500;
constexpr int kRow = 25;            // cubes
constexpr double kSpacing = 0.1;    // m
constexpr double kSize = 0.09;      // m
constexpr int kMoving = 50;         // cubes of one message
constexpr int kLists = 4;           // in turn
constexpr int kCells = 5000;        // of a list
constexpr int kCellColumn = 50;     // cells
constexpr double kCellSize = 0.02;  // m
constexpr int kMeshObjects = 4;     // in turn
constexpr double kBehind = 3;       // m, where lists and meshes stand

}  // namespace

StormScene::StormScene(std::size_t links, std::vector<std::string> meshes)
    : links_(links), meshes_(std::move(meshes)) {}

Marker StormScene::marker(const std::string& ns, int id, int type, double x, double y,
                          double z) const {
  Marker marker;
  marker.header.frame_id = "base";
  marker.frame_locked = true;
  marker.ns = ns;
  marker.id = id;
  marker.type = type;
  marker.pose.position.x = x;
  marker.pose.position.y = y;
  marker.pose.position.z = z;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  return marker;
}

Marker StormScene::cube(int id) const {
  const double lift = 0.02 * std::sin(0.1 * static_cast<double>(step_) + id);
  Marker result =
      marker("cube", id, Marker::CUBE, kSpacing * (id % kRow), 0.2 + kSpacing * (id / kRow), lift);
  if (id % 10 == 0) {
    result.header.frame_id = "link_" + std::to_string(static_cast<std::size_t>(id) % links_);
    result.pose.position.x = 0;
  }
  result.scale.x = result.scale.y = result.scale.z = kSize;
  return result;
}

MarkerArray StormScene::allCubes() {
  std::vector<Marker> cubes;
  for (int id = 0; id < kCubes; ++id)
    cubes.push_back(cube(id));
  return keep(cubes);
}

MarkerArray StormScene::nextCubes() {
  ++step_;
  std::vector<Marker> cubes;
  for (int i = 0; i < kMoving; ++i)
    cubes.push_back(cube((static_cast<int>(step_) * kMoving + i) % kCubes));
  return keep(cubes);
}

MarkerArray StormScene::nextList() {
  const int id = static_cast<int>(++step_ % kLists);
  Marker list = marker("list", id, Marker::CUBE_LIST, 2.0 * id, kBehind, 0);
  list.scale.x = list.scale.y = list.scale.z = kCellSize;
  for (int i = 0; i < kCells; ++i) {
    geometry_msgs::Point cell;
    cell.x = kCellSize * (i / kCellColumn);
    cell.y = kCellSize * (i % kCellColumn);
    cell.z = 0.1 * std::sin(0.1 * static_cast<double>(step_) + i);
    list.points.push_back(cell);
  }
  return keep({list});
}

MarkerArray StormScene::nextMesh() {
  const std::size_t number = ++step_ % meshes_.size();
  const int id = static_cast<int>(number % kMeshObjects);
  Marker mesh = marker("mesh", id, Marker::MESH_RESOURCE, id, kBehind + 2, 0);
  mesh.mesh_resource = meshes_[number];
  return keep({mesh});
}

MarkerArray StormScene::keep(const std::vector<Marker>& markers) {
  MarkerArray array;
  array.markers = markers;
  for (const Marker& marker : markers)
    newest_[marker.ns + "/" + std::to_string(marker.id)] = marker;
  return array;
}

MarkerArray StormScene::everything() const {
  MarkerArray array;
  for (const auto& [name, marker] : newest_)
    array.markers.push_back(marker);
  return array;
}

}  // namespace link_bounds
