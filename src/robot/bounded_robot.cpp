// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Resolves the meshes of all links before the first is loaded, so that files load side by side.
#include "robot/bounded_robot.h"

#include <algorithm>
#include <new>

#include "link_bounds/geometry/parts/link_parts.h"
#include "text/joined.h"

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

/// How messages for the user name an element.
std::string nameOf(Purpose purpose, std::size_t number, const std::string& uri) {
  return std::string(toText(purpose)) + " " + std::to_string(number) +
         (uri.empty() ? "" : " (" + uri + ")");
}

struct Draft {
  BoundedRobot robot;
  std::vector<Request> requests;

  /// Adds a message to the robot's problems, and to `missing` of the link.
  void addProblem(BoundedLink& link, Purpose purpose, std::size_t number, const std::string& uri,
                  const std::string& reason) {
    const std::string what = nameOf(purpose, number, uri);
    robot.problems.push_back("link \"" + link.name + "\", " + what + ": " + reason);
    link.missing += (link.missing.empty() ? "" : "; ") + what + ": " + reason;
  }
};

void addMesh(Draft& draft, BoundedLink& link, const Element& element, const MeshSource& source) {
  try {
    const MeshFile file = resolveMeshUri(element.mesh_uri, source.package_path, source.base_folder);
    draft.requests.push_back({&element, draft.robot.links.size(), link.shapes.size(), file});
    link.shapes.push_back({nullptr, Solid::kNone, element.size, element.link_from_shape});
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {  // package_path may throw any
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
      draft.robot.mesh_uris.emplace(request.element->mesh_uri, meshes[i].points);
      continue;
    }
    draft.addProblem(link, request.element->purpose, request.element->number,
                     request.element->mesh_uri,
                     "cannot use " + request.file.path + ": " + meshes[i].error);
  }
}

/// True for a mesh that failed to load, which would count as a point at its origin.
bool isEmpty(const Shape& shape) {
  return shape.solid == Solid::kNone && !shape.points;
}

void dropEmptyShapes(BoundedLink& link) {
  link.shapes.erase(std::remove_if(link.shapes.begin(), link.shapes.end(), isEmpty),
                    link.shapes.end());
}

/// A shape and the mesh that it came from; null for a solid.
struct LoadedShape {
  Shape shape;
  const LoadedMesh* mesh = nullptr;
};

/// The shapes of each link but the empty ones. To be called before dropEmptyShapes, which changes
/// the indices that requests hold.
std::vector<std::vector<LoadedShape>> loadedShapes(const Draft& draft,
                                                   const std::vector<LoadedMesh>& meshes) {
  std::vector<std::vector<LoadedShape>> loaded;
  for (const BoundedLink& link : draft.robot.links) {
    loaded.emplace_back();
    for (const Shape& shape : link.shapes)
      loaded.back().push_back({shape});
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
    loaded[draft.requests[i].link][draft.requests[i].shape].mesh = &meshes[i];
  const auto is_empty = [](const LoadedShape& shape) { return isEmpty(shape.shape); };
  for (std::vector<LoadedShape>& shapes : loaded)
    shapes.erase(std::remove_if(shapes.begin(), shapes.end(), is_empty), shapes.end());
  return loaded;
}

bool isEqual(const DivisibleShape& a, const DivisibleShape& b) {
  return a.shape.points == b.shape.points && a.shape.solid == b.shape.solid &&
         a.shape.size == b.shape.size &&
         a.shape.link_from_shape.matrix() == b.shape.link_from_shape.matrix();
}

/// Splits the links of a robot. Links of equal shapes, as wheels are, share the points of parts.
class LinkSplitter {
 public:
  explicit LinkSplitter(std::size_t max_parts) : max_parts_(max_parts) {}

  /// The parts of a link with its name and padding. `shapes` are those of the link. If memory does
  /// not suffice, the link itself is its only part. An exception of `check_interrupt` is passed on.
  std::vector<BoundedLink> split(const BoundedLink& link, const std::vector<DivisibleShape>& shapes,
                                 const CheckInterrupt& check_interrupt) try {
    std::vector<BoundedLink> parts;
    for (const LinkPart& part : partsOf(shapes, check_interrupt))
      parts.push_back({link.name, part, link.padding, link.missing});
    return parts;
  } catch (const std::bad_alloc&) {
    if (link.shapes.empty()) return {};
    return {link};
  }

 private:
  struct SplitLink {
    std::vector<DivisibleShape> shapes;
    std::vector<LinkPart> parts;
  };

  const std::vector<LinkPart>& partsOf(const std::vector<DivisibleShape>& shapes,
                                       const CheckInterrupt& check_interrupt) {
    for (const SplitLink& link : known_) {
      if (std::equal(link.shapes.begin(), link.shapes.end(), shapes.begin(), shapes.end(), isEqual))
        return link.parts;
    }
    known_.push_back({shapes, splitIntoParts(shapes, max_parts_, check_interrupt)});
    return known_.back().parts;
  }

  std::size_t max_parts_;
  std::vector<SplitLink> known_;  ///< links that were split before
};

/// To be called after dropEmptyShapes: the only part of a link that cannot be split is the link.
/// Splitting a link may take as long as loading a mesh.
void addParts(const std::vector<std::vector<LoadedShape>>& loaded, std::size_t max_parts,
              const MeshSource& source, const MeshRemedy& remedy, BoundedRobot& robot) {
  LinkSplitter splitter(max_parts);
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    std::vector<DivisibleShape> divisible;
    for (const auto& [shape, mesh] : loaded[i])
      divisible.push_back({shape, mesh ? mesh->triangles : nullptr});
    const BoundedLink& link = robot.links[i];
    try {
      const CheckInterrupt deadline = meshDeadline(source.limits, source.is_cancelled);
      robot.parts.push_back(splitter.split(link, divisible, deadline));
    } catch (const MeshError& error) {
      robot.parts.push_back({link});
      robot.part_problems.push_back("link \"" + link.name + "\" has one part: " + error.what() +
                                    "; " + remedy(error.fault()));
    }
  }
}

void addBodies(const std::vector<std::vector<LoadedShape>>& loaded, BoundedRobot& robot) {
  for (const std::vector<LoadedShape>& shapes : loaded) {
    Body body;
    for (const auto& [shape, mesh] : shapes)
      body.shapes.push_back({shape, mesh ? mesh->tree : nullptr});
    robot.bodies.push_back(std::move(body));
  }
}

/// Adds a problem for each mesh element that has points but no triangles.
void addBodyProblems(const Draft& draft, const std::vector<LoadedMesh>& meshes,
                     std::vector<std::string>& problems) {
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i].tree_error.empty()) continue;
    const Request& request = draft.requests[i];
    const Element& element = *request.element;
    problems.push_back("link \"" + draft.robot.links[request.link].name + "\", " +
                       nameOf(element.purpose, element.number, element.mesh_uri) + ": " +
                       treeProblem(request.file.path, meshes[i].tree_error));
  }
}

MeshContent contentOf(const Selection& selection) {
  const bool has_parts = selection.parts_per_link > 1;
  if (selection.triangles) return has_parts ? MeshContent::kAll : MeshContent::kPointsAndTree;
  return has_parts ? MeshContent::kPointsAndTriangles : MeshContent::kPoints;
}

}  // namespace

std::string treeProblem(const std::string& path, const std::string& error) {
  return "distances are those of the convex hull of " + path + ": " + error;
}

BoundedRobot boundRobot(const Robot& robot, const Selection& selection, const MeshSource& source,
                        MeshStore& store, const MeshRemedy& remedy) {
  Draft draft;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (isSelected(robot.links[i], selection)) addLink(draft, robot, i, selection, source);
  }
  std::vector<MeshFile> files;
  for (const Request& request : draft.requests)
    files.push_back(request.file);
  const std::vector<LoadedMesh> meshes =
      store.load(files, source.progress, contentOf(selection), source.limits, source.is_cancelled);
  addPoints(draft, meshes);
  const std::vector<std::vector<LoadedShape>> loaded = loadedShapes(draft, meshes);
  for (BoundedLink& link : draft.robot.links)
    dropEmptyShapes(link);
  if (selection.parts_per_link > 1)
    addParts(loaded, static_cast<std::size_t>(selection.parts_per_link), source, remedy,
             draft.robot);
  if (selection.triangles) {
    addBodies(loaded, draft.robot);
    addBodyProblems(draft, meshes, draft.robot.body_problems);
  }
  return std::move(draft.robot);
}

std::vector<std::string> allProblems(const BoundedRobot& robot) {
  std::vector<std::string> all = robot.problems;
  all.insert(all.end(), robot.body_problems.begin(), robot.body_problems.end());
  return all;
}

std::string leftOutNote(const Robot& robot, const Selection& selection) {
  if (selection.visual && selection.collision) return "";
  const Purpose chosen = selection.visual ? Purpose::kVisual : Purpose::kCollision;
  const Purpose other = selection.visual ? Purpose::kCollision : Purpose::kVisual;
  std::vector<std::string> names;
  for (const Link& link : robot.links) {
    if (isSelected(link, selection) && !hasGeometry(link, chosen) && hasGeometry(link, other))
      names.push_back(link.name);
  }
  if (names.empty()) return "";
  return "left out are links with " + std::string(toText(other)) +
         " geometry only: " + quotedList(names);
}

}  // namespace link_bounds
