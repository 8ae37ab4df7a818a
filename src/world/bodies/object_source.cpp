// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks a marker, turns it into the content of an object, and finds its mesh.
#include "world/bodies/object_source.h"

#include <ros/console.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "world/bodies/marker_refusal.h"
#include "world/bodies/marker_shape.h"
#include "world/model/model.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

std::int64_t placementStamp(const Marker& marker) {
  return marker.frame_locked ? 0 : nanosecondsOf(marker.header.stamp);
}

std::string whyNeverPlaced(const LiveObjects::NeverPlaced& object) {
  std::ostringstream text;
  text << "it is sent again and again, and its stamp is " << std::setprecision(3)
       << std::abs(object.ahead) << " s " << (object.ahead > 0 ? "ahead of" : "behind")
       << " the newest transform from \"" << object.object->content->frame
       << "\"; synchronise the clocks of both publishers, or stamp 0 to follow that frame";
  return text.str();
}

}  // namespace

ObjectSource::ObjectSource(LiveObjects& objects,
                           std::function<void(const MeshRequest&)> request_mesh)
    : objects_(objects), request_mesh_(std::move(request_mesh)) {}

bool ObjectSource::take(Marker&& marker, const std::string& publisher, ros::Time now) {
  if (marker.action == Marker::DELETEALL)
    return isDrawing(marker) ? objects_.removeAllOf(publisher) : objects_.removeAll();
  if (isDrawing(marker)) return false;
  const ObjectKey key{marker.ns, marker.id};
  if (marker.action == Marker::DELETE) return objects_.remove(key);
  if (marker.action == Marker::ADD && !hasShape(marker)) return objects_.remove(key);
  return objects_.put(key, contentOf(key, std::move(marker), publisher), now);
}

ObjectContent ObjectSource::contentOf(const ObjectKey& key, Marker&& marker,
                                      const std::string& publisher) {
  ObjectContent content;
  content.bounded.name = objectName(key);
  content.bounded.missing = whyMarkerRefused(marker);
  if (const LiveObject* other = objects_.otherOfName(key))
    content.refused_name = whyNameRefused(*other);
  content.publisher = publisher;
  content.lifetime = marker.lifetime;
  const std::string& refusal =
      content.refused_name.empty() ? content.bounded.missing : content.refused_name;
  if (!refusal.empty()) {
    const auto line =
        marker_log_.line(content.bounded.name, refusal, publisher, ros::SteadyTime::now());
    if (line) ROS_ERROR_STREAM(*line);
  }
  if (!content.bounded.isWhole()) return content;
  content.frame = tfName("", marker.header.frame_id);
  content.stamp = placementStamp(marker);
  MarkerShape shape = markerShape(std::move(marker));
  content.bounded.shapes = std::move(shape.shapes);
  content.mesh_uri = std::move(shape.mesh_uri);
  content.drawing = shape.drawing;
  if (!content.mesh_uri.empty()) useMesh(content);
  return content;
}

/// Gives the content its mesh. Requests the mesh the first time, and again if loading may have been
/// cancelled while no object used it.
void ObjectSource::useMesh(ObjectContent& content) {
  eraseDead(meshes_, max_meshes_, [](const Mesh& mesh) { return mesh.use.expired(); });
  Mesh& mesh = meshes_[content.mesh_uri];
  const MeshUse use = mesh.use.lock();
  content.mesh_use = use ? use : std::make_shared<const std::string>(content.mesh_uri);
  mesh.use = content.mesh_use;
  content.setMesh({mesh.points.lock(), mesh.error});
  if (mesh.has_changed) content.setMesh(LoadedMesh());
  const bool is_requested = mesh.request != 0;
  if (is_requested ? !use : content.isLoading()) request(content.mesh_uri, mesh);
}

void ObjectSource::request(const std::string& uri, Mesh& mesh) {
  mesh.request = ++requests_;
  request_mesh_({uri, mesh.use, mesh.request});
}

bool ObjectSource::fillMesh(const MeshRequest& request, const LoadedMesh& mesh, ros::Time now) {
  const std::string& uri = request.uri;
  const auto found = meshes_.find(uri);
  if (found == meshes_.end() || found->second.request != request.number) return false;
  Mesh& known = found->second;
  known.points = mesh.points;
  known.error = mesh.error;
  known.request = 0;
  known.has_changed = false;
  if (!mesh.error.empty()) {
    const LiveObject* const user = objects_.firstWithMesh(uri);
    const std::string whose = user ? user->content->bounded.name + " of " + user->content->publisher
                                   : "an object that has gone";
    const auto line = mesh_log_.line(uri, mesh.error, whose, ros::SteadyTime::now());
    if (line) ROS_ERROR_STREAM(*line);
  }
  return objects_.fillMesh(uri, mesh, now);
}

void ObjectSource::warnOfGivenUp(ros::Time now) {
  for (const LiveObject* object : objects_.takeGivenUp())
    warn(*object, objects_.reason(*object) + "; publish that frame, or stamp 0 to follow it");
  for (const LiveObjects::NeverPlaced& object : objects_.neverPlaced(now))
    warn(*object.object, whyNeverPlaced(object));
}

void ObjectSource::warn(const LiveObject& object, const std::string& reason) {
  const auto line = marker_log_.line(object.content->bounded.name, reason,
                                     object.content->publisher, ros::SteadyTime::now());
  if (line) ROS_WARN_STREAM(*line);
}

bool ObjectSource::reloadMeshes(const Points& unchanged, ros::Time now) {
  marker_log_.forget();
  mesh_log_.forget();
  std::map<std::string, MeshUse> uses;
  for (const auto& [key, object] : objects_.objects()) {
    if (object.content->mesh_use) uses.emplace(object.content->mesh_uri, object.content->mesh_use);
  }
  std::map<std::string, Mesh> known = std::move(meshes_);
  meshes_.clear();
  bool is_changed = false;
  for (const auto& [uri, use] : uses) {
    Mesh& mesh = meshes_[uri];
    mesh.points = known[uri].points;
    mesh.use = use;
    const auto found = unchanged.find(uri);
    mesh.has_changed = found == unchanged.end() || found->second.lock() != mesh.points.lock();
    if (mesh.has_changed) is_changed |= objects_.fillMesh(uri, LoadedMesh(), now);
    request(uri, mesh);
  }
  return is_changed;
}

}  // namespace link_bounds
