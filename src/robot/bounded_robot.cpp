// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Resolves the meshes of all links before the first is loaded, so that files load side by side.
#include "robot/bounded_robot.h"

#include <algorithm>

#include "geometry/parts/link_splitter.h"

namespace link_bounds {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool isSelected(Purpose purpose, const Selection& selection) {
  return purpose == Purpose::kVisual ? selection.visual : selection.collision;
}

bool isSelected(const Link& link, const Selection& selection) {
  if (!selection.links.empty() && !contains(selection.links, link.name)) return false;
  return !contains(selection.ignore_links, link.name);
}

double paddingOf(const std::string& link, const Selection& selection) {
  const auto found = selection.link_padding.find(link);
  return found == selection.link_padding.end() ? selection.padding : found->second;
}

/// A mesh element, and the shape that gets its points when they are loaded.
struct Request {
  const Element* element;
  std::size_t link;   ///< index in BoundedRobot::links
  std::size_t shape;  ///< index in BoundedLink::shapes
  MeshFile file;
};

struct Draft {
  BoundedRobot robot;
  std::vector<Request> requests;

  /// Adds a message to the robot's problems, and to what the link misses.
  void addProblem(BoundedLink& link, Purpose purpose, std::size_t number, const std::string& uri,
                  const std::string& reason) {
    std::string what = std::string(toText(purpose)) + " " + std::to_string(number);
    if (!uri.empty()) what += " (" + uri + ")";
    robot.problems.push_back("link \"" + link.name + "\", " + what + ": " + reason);
    link.missing += (link.missing.empty() ? "" : "; ") + what + ": " + reason;
  }
};

void addMesh(Draft& draft, BoundedLink& link, const Element& element, const MeshSource& source) {
  try {
    const MeshFile file = resolveMeshUri(element.mesh_uri, source.package_path, source.base_folder);
    draft.requests.push_back({&element, draft.robot.links.size(), link.shapes.size(), file});
    link.shapes.push_back({nullptr, Solid::kNone, element.size, element.link_from_shape});
  } catch (const MeshError& error) {
    draft.addProblem(link, element.purpose, element.number, element.mesh_uri, error.what());
  }
}

/// Adds a link if it has selected geometry, usable or not.
void addLink(Draft& draft, const Robot& robot, std::size_t index, const Selection& selection,
             const MeshSource& source) {
  const Link& source_link = robot.links[index];
  BoundedLink link;
  link.name = source_link.name;
  link.padding = paddingOf(link.name, selection);
  for (const LostElement& lost : source_link.lost) {
    if (isSelected(lost.purpose, selection)) {
      draft.addProblem(link, lost.purpose, lost.number, "", lost.reason);
    }
  }
  for (const Element& element : source_link.elements) {
    if (!isSelected(element.purpose, selection)) continue;
    if (element.mesh_uri.empty()) {
      link.shapes.push_back({nullptr, element.solid, element.size, element.link_from_shape});
    } else {
      addMesh(draft, link, element, source);
    }
  }
  if (link.shapes.empty() && link.isWhole()) return;
  draft.robot.links.push_back(std::move(link));
  draft.robot.indices.push_back(index);
}

/// Gives the shapes their points; each mesh that failed to load becomes a problem.
void addPoints(Draft& draft, const std::vector<LoadedMesh>& meshes) {
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const Request& request = draft.requests[i];
    BoundedLink& link = draft.robot.links[request.link];
    link.shapes[request.shape].points = meshes[i].points;
    if (meshes[i].points) {
      draft.robot.meshes.emplace(request.file.path, meshes[i].points);
      continue;
    }
    draft.addProblem(link, request.element->purpose, request.element->number,
                     request.element->mesh_uri,
                     "cannot use " + request.file.path + ": " + meshes[i].error);
  }
}

/// Whether it is a mesh that failed to load, which would count as a point at its origin.
bool isEmpty(const Shape& shape) {
  return shape.solid == Solid::kNone && !shape.points;
}

void dropEmptyShapes(BoundedLink& link) {
  link.shapes.erase(std::remove_if(link.shapes.begin(), link.shapes.end(), isEmpty),
                    link.shapes.end());
}

/// The shapes of each link but the empty ones, with their triangles. To be called before
/// dropEmptyShapes, which changes the indices that requests hold.
std::vector<std::vector<DivisibleShape>> divisibleShapes(const Draft& draft,
                                                         const std::vector<LoadedMesh>& meshes) {
  std::vector<std::vector<DivisibleShape>> divisible;
  for (const BoundedLink& link : draft.robot.links) {
    divisible.emplace_back();
    for (const Shape& shape : link.shapes)
      divisible.back().push_back({shape, nullptr});
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const Request& request = draft.requests[i];
    divisible[request.link][request.shape].mesh = meshes[i].triangles;
  }
  const auto is_empty = [](const DivisibleShape& shape) { return isEmpty(shape.shape); };
  for (std::vector<DivisibleShape>& shapes : divisible)
    shapes.erase(std::remove_if(shapes.begin(), shapes.end(), is_empty), shapes.end());
  return divisible;
}

/// To be called after dropEmptyShapes: the only part of a link that cannot be split is the link.
void addParts(const std::vector<std::vector<DivisibleShape>>& divisible, std::size_t max_parts,
              BoundedRobot& robot) {
  LinkSplitter splitter(max_parts);
  for (std::size_t i = 0; i < divisible.size(); ++i)
    robot.parts.push_back(splitter.split(robot.links[i], divisible[i]));
}

}  // namespace

BoundedRobot boundRobot(const Robot& robot, const Selection& selection, const MeshSource& source,
                        MeshStore& store) {
  Draft draft;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (isSelected(robot.links[i], selection)) addLink(draft, robot, i, selection, source);
  }
  std::vector<MeshFile> files;
  for (const Request& request : draft.requests)
    files.push_back(request.file);
  const bool has_parts = selection.parts_per_link > 1;
  const std::vector<LoadedMesh> meshes = store.load(
      files, source.progress, has_parts ? MeshContent::kPointsAndTriangles : MeshContent::kPoints);
  addPoints(draft, meshes);
  std::vector<std::vector<DivisibleShape>> divisible;
  if (has_parts) divisible = divisibleShapes(draft, meshes);
  for (BoundedLink& link : draft.robot.links)
    dropEmptyShapes(link);
  if (has_parts)
    addParts(divisible, static_cast<std::size_t>(selection.parts_per_link), draft.robot);
  return std::move(draft.robot);
}

}  // namespace link_bounds
