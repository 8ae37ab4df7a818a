// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes a model of a description and parameters.
#include "world/model/model.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "packages/package_path.h"
#include "robot/bounded_robot.h"
#include "robot/urdf/trimmed.h"
#include "text/joined.h"
#include "world/model/object_key.h"
#include "world/tf/edge_history.h"

namespace link_bounds {
namespace {

SceneGroup allLinks(std::size_t count) {
  SceneGroup group;
  group.name = kRobotGroup;
  for (std::size_t i = 0; i < count; ++i)
    group.members.push_back(i);
  return group;
}

/// The links that can be members of groups.
struct KnownLinks {
  std::map<std::string, std::size_t> bounded;
  std::set<std::string> without_geometry;
};

/// A name that fits both a link and an object means the link.
void addMember(SceneGroup& group, const std::string& member, const KnownLinks& known) {
  const auto found = known.bounded.find(member);
  if (found != known.bounded.end()) {
    group.members.push_back(found->second);
  } else if (known.without_geometry.count(member)) {
    return;
  } else if (const auto ns = withoutEnd(member, "/*")) {
    group.namespaces.push_back(*ns);
  } else if (const auto key = parseObjectName(member)) {
    group.objects.push_back(*key);
  } else {
    group.lacks_members = true;
  }
}

std::vector<SceneGroup> makeGroups(std::size_t links, const Parameters& parameters,
                                   const KnownLinks& known) {
  std::vector<SceneGroup> groups{allLinks(links)};
  for (const auto& [name, members] : parameters.groups) {
    groups.emplace_back().name = name;
    for (const std::string& member : members)
      addMember(groups.back(), member, known);
  }
  return groups;
}

bool isAsked(const Link& link, const Selection& selection) {
  return (selection.visual && hasGeometry(link, Purpose::kVisual)) ||
         (selection.collision && hasGeometry(link, Purpose::kCollision));
}

/// One warning per group without members, and per group that names links whose geometry is only of
/// the kind that ~geometry excludes: the group's box does not contain them.
std::vector<std::string> groupWarnings(const Parameters& parameters, const Robot& robot,
                                       const Selection& selection) {
  std::vector<std::string> warnings;
  for (const auto& [group, members] : parameters.groups) {
    if (members.empty())
      warnings.push_back("box \"" + group +
                         "\" of ~groups has no members, so it is in no message; "
                         "name some in ~groups");
    std::vector<std::string> names;
    for (const Link& link : robot.links) {
      const bool has_any =
          hasGeometry(link, Purpose::kVisual) || hasGeometry(link, Purpose::kCollision);
      const bool is_left_out = has_any && !isAsked(link, selection);
      if (is_left_out && std::count(members.begin(), members.end(), link.name) > 0)
        names.push_back(link.name);
    }
    if (!names.empty())
      warnings.push_back("box \"" + group + "\" of ~groups does not cover " + quotedList(names) +
                         ", with geometry of the other kind only; set ~geometry to both");
  }
  return warnings;
}

KnownLinks knownLinks(const Robot& robot, const Model& model, const Selection& selection) {
  KnownLinks known;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    known.bounded[model.links[i].name] = i;
  for (const Link& link : robot.links) {
    if (!isAsked(link, selection)) known.without_geometry.insert(link.name);
  }
  return known;
}

/// The rigid bodies of the links with these `indices`, in the same order.
RigidBodies bodiesOf(const Robot& robot, const std::vector<std::size_t>& indices) {
  const RigidBodies all = rigidBodies(robot);
  RigidBodies bodies{{}, all.parents};
  for (const std::size_t index : indices)
    bodies.of_links.push_back(all.of_links[index]);
  return bodies;
}

/// The pairs that an entry of ignore_pairs stands for; none if it cannot be split into names.
std::vector<NamePair> pairsOf(const std::string& entry, const std::set<std::string>& links) {
  return namePairs(entry, [&links](const std::string& name) {
    return links.count(name) || parseObjectName(name) || isPattern(name);
  });
}

std::vector<NamePair> ignoredPairs(const Parameters& parameters,
                                   const std::set<std::string>& links) {
  std::vector<NamePair> result;
  for (const std::string& entry : parameters.ignore_pairs) {
    const std::vector<NamePair> pairs = pairsOf(entry, links);
    result.insert(result.end(), pairs.begin(), pairs.end());
  }
  return result;
}

void checkIgnoredPairs(const Parameters& parameters, const std::set<std::string>& links) {
  for (const std::string& entry : parameters.ignore_pairs) {
    if (!pairsOf(entry, links).empty()) continue;
    throw ParameterError("parameter ~ignore_pairs: \"" + entry +
                         "\" cannot be split into two names of links or objects; correct it");
  }
}

/// Objects can also be attached to links without geometry: these have a rigid body, too.
std::vector<Attachment> attachmentsOf(const Parameters& parameters, const Robot& robot) {
  const RigidBodies bodies = rigidBodies(robot);
  std::vector<Attachment> result;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const auto found = parameters.attached.find(robot.links[i].name);
    if (found == parameters.attached.end()) continue;
    for (const std::string& objects : found->second)
      result.push_back({objects, bodies.of_links[i]});
  }
  return result;
}

/// One warning per name of a joint that the robot does not have.
std::vector<std::string> unknownJoints(const Parameters& parameters, const Robot& robot) {
  std::vector<std::string> warnings;
  const auto check = [&](const std::map<std::string, double>& values, const char* parameter) {
    for (const auto& [name, value] : values) {
      const auto is_it = [&name = name](const Joint& joint) { return joint.name == name; };
      if (std::any_of(robot.joints.begin(), robot.joints.end(), is_it)) continue;
      warnings.push_back("parameter ~" + std::string(parameter) + " names joint \"" + name +
                         "\", which the robot description does not have; correct the name");
    }
  };
  check(parameters.deceleration, "deceleration");
  check(parameters.acceleration, "acceleration");
  return warnings;
}

/// Names in further parameters that should be links, each with its parameter. Skips names with a
/// slash in groups and pairs, which may be objects.
std::map<std::string, std::string> otherNames(const Parameters& parameters,
                                              const std::vector<NamePair>& ignored_pairs,
                                              const std::set<std::string>& links) {
  std::map<std::string, std::string> result;
  for (const auto& [name, objects] : parameters.attached)
    result.emplace(name, "attached");
  for (const auto& [group, members] : parameters.groups) {
    for (const std::string& name : members) {
      if (name.find('/') == std::string::npos) result.emplace(name, "groups/" + group);
    }
  }
  for (const NamePair& pair : ignored_pairs) {
    for (const std::string& name : {pair.first, pair.second}) {
      const auto fits = [&name](const std::string& link) { return fitsPattern(link, name); };
      const bool is_object = name.find('/') != std::string::npos;
      if (!is_object && std::none_of(links.begin(), links.end(), fits))
        result.emplace(name, "ignore_pairs");
    }
  }
  return result;
}

/// The names of links for which `is_it` is true, quoted and separated by commas.
template <class IsIt>
std::string namesThat(const std::vector<BoundedLink>& links, IsIt is_it) {
  std::vector<std::string> names;
  for (const BoundedLink& link : links) {
    if (is_it(link.name)) names.push_back(link.name);
  }
  return quotedList(names);
}

/// Warnings about links whose names are also those of objects or of neighbours' boxes.
std::vector<std::string> nameWarnings(const std::vector<BoundedLink>& links) {
  std::vector<std::string> warnings;
  const std::string hidden = namesThat(links, isNeighbourName);
  if (!hidden.empty())
    warnings.push_back(
        "other nodes leave out of ~neighbours what has the name of a "
        "neighbour's box, with a slash at its begin and another one: " +
        hidden + "; give these links other names");
  const std::string ambiguous = namesThat(links, [](const std::string& name) {
    return !isNeighbourName(name) && parseObjectName(name);
  });
  if (!ambiguous.empty())
    warnings.push_back("links have names that markers may have, NS/ID: " + ambiguous +
                       "; such a marker gets a second box of that name, so give these links "
                       "other names");
  return warnings;
}

/// Warnings about valid parameters that make something have no effect.
std::vector<std::string> valueWarnings(const Parameters& parameters, bool has_no_link) {
  std::vector<std::string> warnings;
  if (has_no_link)
    warnings.emplace_back(
        "no link is bounded: parameters ~links, ~ignore_links and ~geometry leave no link with "
        "geometry; correct them");
  if (parameters.distance_warning > parameters.distance_limit)
    warnings.emplace_back(
        "parameter ~distance_warning is larger than ~distance_limit, beyond which nothing is "
        "measured; raise ~distance_limit");
  constexpr double kHistory = static_cast<double>(EdgeHistory::kLength) / 1e9;
  if (parameters.swept_span >= kHistory)
    warnings.emplace_back(
        "parameter ~swept_span is no shorter than the ten seconds that tf remembers, so ~swept has "
        "no box of what moves; lower it");
  return warnings;
}

}  // namespace

std::string tfName(const std::string& tf_prefix, const std::string& link) {
  if (!link.empty() && link.front() == '/') return link.substr(1);
  const std::string prefix = trimmed(tf_prefix, "/");
  return prefix.empty() ? link : prefix + "/" + link;
}

Selection selectionOf(const LinkParameters& parameters) {
  Selection selection = selectionOf(parameters.geometry);
  selection.links = parameters.links;
  selection.ignore_links = parameters.ignore_links;
  selection.padding = parameters.padding;
  selection.link_padding = parameters.link_padding;
  return selection;
}

std::vector<std::string> unknownLinks(const LinkParameters& parameters,
                                      const std::set<std::string>& links,
                                      const std::map<std::string, std::string>& others) {
  std::map<std::string, std::string> named;
  for (const std::string& link : parameters.links)
    named.emplace(link, "links");
  for (const std::string& link : parameters.ignore_links)
    named.emplace(link, "ignore_links");
  for (const auto& [link, padding] : parameters.link_padding)
    named.emplace(link, "link_padding");
  named.insert(others.begin(), others.end());
  std::vector<std::string> warnings;
  for (const auto& [name, parameter] : named) {
    if (links.count(name) > 0) continue;
    warnings.push_back("parameter ~" + parameter + " names link \"" + name +
                       "\", which the robot description does not have; correct the name");
  }
  return warnings;
}

std::set<std::string> linkNames(const Robot& robot) {
  std::set<std::string> names;
  for (const Link& link : robot.links)
    names.insert(link.name);
  return names;
}

Model modelWithoutRobot(const Parameters& parameters) {
  Model model;
  model.parameters = parameters;
  model.fixed_frame = tfName("", parameters.fixed_frame);
  model.groups = makeGroups(0, parameters, KnownLinks());
  model.ignored_pairs = NamePairs(ignoredPairs(parameters, {}));
  return model;
}

MeshSource meshSource(const Parameters& parameters) {
  const MeshLimits limits{parameters.mesh_timeout,
                          static_cast<std::uint64_t>(parameters.max_mesh_bytes)};
  return {rosPackages(), "", nullptr, limits};
}

Model makeModel(const std::string& description, const Parameters& parameters, RobotLoader& loader,
                const MeshSource& source) {
  const Robot robot = parseRobot(description);
  const std::set<std::string> names = linkNames(robot);
  checkIgnoredPairs(parameters, names);
  const std::vector<NamePair> ignored_pairs = ignoredPairs(parameters, names);
  Selection selection = selectionOf(parameters);
  selection.parts_per_link = parameters.parts_per_link;
  BoundedRobot bounded = loader.load(robot, selection, source);
  Model model;
  model.parameters = parameters;
  model.fixed_frame = parameters.fixed_frame.empty()
                          ? tfName(parameters.tf_prefix, robot.links[robot.root].name)
                          : tfName("", parameters.fixed_frame);
  model.links = std::move(bounded.links);
  model.parts = std::move(bounded.parts);
  for (const BoundedLink& link : model.links) {
    model.frames.push_back(tfName(parameters.tf_prefix, link.name));
  }
  model.groups = makeGroups(model.links.size(), parameters, knownLinks(robot, model, selection));
  model.bodies = bodiesOf(robot, bounded.indices);
  model.robot = std::make_shared<const Robot>(robot);
  model.robot_links = bounded.indices;
  model.ignored_pairs = NamePairs(ignored_pairs);
  model.attached = attachmentsOf(parameters, robot);
  for (const auto& [path, points] : bounded.meshes)
    model.mesh_bytes.emplace(path, points->bytes());
  model.mesh_uris = std::move(bounded.mesh_uris);
  model.left_out = leftOutNote(robot, selection);
  model.problems = std::move(bounded.problems);
  model.warnings = unknownLinks(parameters, names, otherNames(parameters, ignored_pairs, names));
  for (const auto& warnings :
       {unknownJoints(parameters, robot), bounded.part_problems, nameWarnings(model.links),
        groupWarnings(parameters, robot, selection), valueWarnings(parameters, model.links.empty()),
        robot.warnings})
    model.warnings.insert(model.warnings.end(), warnings.begin(), warnings.end());
  return model;
}

std::optional<std::size_t> bodyOf(const Model& model, const PairMember& member) {
  if (member.link) return model.bodies.of_links[*member.link];
  for (const Attachment& attachment : model.attached) {
    if (fitsPattern(*member.name, attachment.objects)) return attachment.body;
  }
  return std::nullopt;
}

bool isPair(const Model& model, const PairMember& a, const PairMember& b) {
  const std::optional<std::size_t> body = bodyOf(model, a);
  const std::optional<std::size_t> other = body ? bodyOf(model, b) : std::nullopt;
  if (other && areBodiesJoined(model.bodies, *body, *other, model.parameters.adjacent_joints))
    return false;
  return !model.ignored_pairs.contains(*a.name, *b.name);
}

}  // namespace link_bounds
