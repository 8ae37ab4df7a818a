// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From urdfdom's model, whose links own each other, to plain values, and why it dropped geometry.
// Loops instead of recursion, because a chain of links may be longer than the stack is deep.
#include "link_bounds/robot/urdf/robot.h"

#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cctype>
#include <unordered_map>

#include "robot/urdf/not_urdf.h"
#include "robot/urdf/urdf_elements.h"
#include "robot/urdf/urdf_log.h"
#include "robot/urdf/urdf_outline.h"

namespace link_bounds {
namespace {

using LinkIndex = std::unordered_map<std::string, std::size_t>;

/// Cuts the links apart at the end. Otherwise freeing a chain of 20,000 links, each of which owns
/// the next, overflows the stack.
struct Dismantled {
  urdf::ModelInterfaceSharedPtr model;

  ~Dismantled() {
    if (!model) return;
    for (auto& [name, link] : model->links_) {
      link->child_links.clear();
      link->child_joints.clear();
      link->parent_joint.reset();
    }
  }
};

/// Why urdfdom cannot parse the element alone, in a robot with one link; "" if it can.
std::string faultOf(const std::string& element, Purpose purpose) {
  const UrdfLog log(element);
  const auto model =
      urdf::parseURDF("<robot name='r'><link name='l'>" + element + "</link></robot>");
  const auto link = model ? model->getLink("l") : nullptr;
  const bool parsed = link && (purpose == Purpose::kVisual ? link->visual_array.size()
                                                           : link->collision_array.size()) == 1;
  if (parsed) return "";
  std::string why = log.messages();
  const std::string of_link = " for Link [l]";  // which the user does not have
  const std::size_t place = why.rfind(of_link);
  if (place != std::string::npos) why.erase(place, of_link.size());
  return "it cannot be parsed (" + why + "); correct its numbers and attributes";
}

/// urdfdom reads <inertial>, then the visuals, then the collisions of a link, and stops at the
/// first element that it cannot parse. So it keeps the first `kept` elements of `purpose`; returns
/// the others with their reasons. `link_messages` are urdfdom's messages about this link.
std::vector<LostElement> lostElements(const LinkOutline& link, Purpose purpose, std::size_t kept,
                                      const std::string& link_messages) {
  std::vector<LostElement> lost;
  const std::vector<ElementOutline>& elements = link.elements(purpose);
  for (std::size_t i = kept; i < elements.size(); ++i) {
    std::string reason = faultOf(elements[i].xml, purpose);
    if (reason.empty()) {
      reason = "urdfdom drops it because of another fault in this link (" + link_messages +
               "); correct that fault";
    }
    lost.push_back({purpose, i + 1, reason});
  }
  return lost;
}

/// Adds the faults of those of the first `kept` elements of which urdfdom read only a part. That
/// part is used.
void addSurplus(const LinkOutline& outline, Purpose purpose, std::size_t kept, Link& link) {
  const std::vector<ElementOutline>& elements = outline.elements(purpose);
  for (std::size_t i = 0; i < std::min(kept, elements.size()); ++i) {
    if (!elements[i].surplus.empty()) link.lost.push_back({purpose, i + 1, elements[i].surplus});
  }
}

void addLosses(const LinkOutline& outline, const urdf::Link& source, const UrdfLog& log,
               Link& link) {
  for (const Purpose purpose : {Purpose::kVisual, Purpose::kCollision}) {
    const std::size_t kept =
        purpose == Purpose::kVisual ? source.visual_array.size() : source.collision_array.size();
    addSurplus(outline, purpose, kept, link);
    if (kept >= outline.elements(purpose).size()) continue;
    const std::string messages = log.messages("[" + link.name + "]");
    for (const LostElement& lost : lostElements(outline, purpose, kept, messages)) {
      link.lost.push_back(lost);
    }
  }
}

/// Adds links that urdfdom found but the outline did not, by name; these are all if the XML cannot
/// be read.
void addUnmatchedLinks(const urdf::ModelInterface& model, Robot& robot) {
  LinkIndex known;
  for (const Link& link : robot.links)
    known.emplace(link.name, known.size());
  for (const auto& [name, link] : model.links_) {
    if (known.count(name)) continue;
    robot.warnings.push_back("the XML around link \"" + name +
                             "\" can be read in two ways, so geometry that urdfdom could not parse "
                             "there goes unnoticed; write it as plain, well-formed XML");
    robot.links.push_back(toLink(*link));
  }
}

/// Links in the order of the text.
void addLinks(const std::vector<LinkOutline>& outlines, const urdf::ModelInterface& model,
              const UrdfLog& log, Robot& robot) {
  for (const LinkOutline& outline : outlines) {
    const auto source = model.getLink(outline.name);
    if (!source) continue;
    Link link = toLink(*source);
    addLosses(outline, *source, log, link);
    robot.links.push_back(std::move(link));
  }
  addUnmatchedLinks(model, robot);
}

Motion motionOf(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return Motion::kRotation;
    case urdf::Joint::PRISMATIC:
      return Motion::kTranslation;
    case urdf::Joint::PLANAR:
      return Motion::kPlanar;
    case urdf::Joint::FLOATING:
      return Motion::kFloating;
    default:
      return Motion::kNone;
  }
}

Joint toJoint(const urdf::Joint& source, const LinkIndex& index) {
  Joint joint;
  joint.name = source.name;
  joint.parent = index.at(source.parent_link_name);
  joint.child = index.at(source.child_link_name);
  joint.motion = motionOf(source);
  joint.parent_from_joint = toIsometry(source.parent_to_joint_origin_transform);
  joint.axis = toVector(source.axis).stableNormalized();
  const bool has_range =
      source.type == urdf::Joint::REVOLUTE || source.type == urdf::Joint::PRISMATIC;
  if (has_range && source.limits) joint.limits = Limits{source.limits->lower, source.limits->upper};
  if (hasValue(joint.motion) && source.limits) joint.max_speed = source.limits->velocity;
  if (source.mimic) {
    joint.mimic = Mimic{source.mimic->joint_name, source.mimic->multiplier, source.mimic->offset};
  }
  return joint;
}

/// The joint above each link; null for the root. Throws if a link has two.
std::vector<const urdf::Joint*> jointsAbove(const urdf::ModelInterface& model,
                                            const LinkIndex& index) {
  std::vector<const urdf::Joint*> above(index.size(), nullptr);
  for (const auto& [name, joint] : model.joints_) {
    const urdf::Joint*& place = above[index.at(joint->child_link_name)];
    if (place) {
      throw RobotError("link \"" + joint->child_link_name + "\" has two parents, by joints \"" +
                       place->name + "\" and \"" + name + "\"; remove one of them");
    }
    place = joint.get();
  }
  return above;
}

/// urdfdom 3 trusts the first byte of a UTF-8 character and skips up to three bytes beyond a text
/// that is cut inside a character. These bytes keep it inside the text.
const std::string kAfterText = "\n\n\n\n";

/// Breadth first, so that parents stand before their children.
void addJoints(const urdf::ModelInterface& model, Robot& robot) {
  LinkIndex index;
  for (const Link& link : robot.links)
    index.emplace(link.name, index.size());
  const std::vector<const urdf::Joint*> above = jointsAbove(model, index);
  std::vector<std::vector<std::size_t>> children(index.size());
  for (std::size_t child = 0; child < above.size(); ++child) {
    if (above[child]) children[index.at(above[child]->parent_link_name)].push_back(child);
  }
  robot.root = index.at(model.getRoot()->name);
  std::vector<bool> reached(index.size(), false);
  std::vector<std::size_t> queue{robot.root};
  reached[robot.root] = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const std::size_t child : children[queue[next]]) {
      reached[child] = true;
      queue.push_back(child);
      robot.joints.push_back(toJoint(*above[child], index));
      const Joint& joint = robot.joints.back();
      if (joint.mimic && (joint.motion == Motion::kPlanar || joint.motion == Motion::kFloating))
        robot.warnings.push_back("joint \"" + joint.name +
                                 "\" has a <mimic>, which is left out: it has more than one value; "
                                 "remove it");
    }
  }
  const auto detached = std::find(reached.begin(), reached.end(), false);
  if (detached != reached.end()) {
    const Link& link = robot.links[static_cast<std::size_t>(detached - reached.begin())];
    throw RobotError("link \"" + link.name + "\" is not connected to root link \"" +
                     model.getRoot()->name + "\", its joints form a loop; open the loop");
  }
}

bool isBlank(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); });
}

/// urdfdom 4 refuses an XML declaration after a comment, so it gets the text without. Earlier
/// versions accept it, and may need it to decode the text.
urdf::ModelInterfaceSharedPtr readByUrdfdom(const std::string& urdf) {
  if (auto model = urdf::parseURDF(urdf + kAfterText)) return model;
  const std::string elements = fromFirstElement(urdf);
  const std::string before = urdf.substr(0, urdf.size() - elements.size());
  const std::size_t declaration = before.rfind("<?xml");
  const bool is_late = declaration != std::string::npos && declaration != before.find('<');
  return is_late ? urdf::parseURDF(elements + kAfterText) : nullptr;
}

/// The remedy, after a semicolon, if the messages of urdfdom are about limits; else "".
std::string remedyForLimits(const std::string& messages) {
  for (const char* const about :
       {"does not specify limits", "without limits", "Could not parse limit element"}) {
    if (messages.find(about) != std::string::npos)
      return "; give that joint a <limit> whose lower, upper, effort and velocity are finite";
  }
  return "";
}

/// What is wrong with a text that urdfdom refuses. The remedy is at the end.
std::string refusalOf(const std::string& urdf, const UrdfLog& log) {
  const std::string what = "the robot description is not a usable URDF";
  const std::string why = whyNoUrdf(urdf);
  if (!why.empty()) return what + (log.isOff() ? "" : " (" + log.messages() + ")") + ": " + why;
  const char* const not_so =
      log.isOff() ? "its XML is well-formed and its root is <robot>, but " : "";
  return what + ": " + not_so + log.messages() + remedyForLimits(log.messages());
}

}  // namespace

bool hasGeometry(const Link& link, Purpose purpose) {
  const auto is_it = [purpose](const auto& element) { return element.purpose == purpose; };
  return std::any_of(link.elements.begin(), link.elements.end(), is_it) ||
         std::any_of(link.lost.begin(), link.lost.end(), is_it);
}

const char* toText(Purpose purpose) {
  return purpose == Purpose::kVisual ? "visual" : "collision";
}

Robot parseRobot(const std::string& urdf) {
  if (isBlank(urdf)) throw RobotError("the robot description is empty");
  const RobotOutline outline = outlineOf(urdf);
  const UrdfLog log(urdf);
  const Dismantled holder{readByUrdfdom(urdf)};
  const urdf::ModelInterfaceSharedPtr& model = holder.model;
  if (!model) throw RobotError(refusalOf(urdf, log));
  Robot robot;
  for (const std::string& warning : {xacroWarning(urdf), secondRobotWarning(urdf)})
    if (!warning.empty()) robot.warnings.push_back(warning);
  robot.warnings.insert(robot.warnings.end(), outline.warnings.begin(), outline.warnings.end());
  robot.name = (*model).getName();
  addLinks(outline.links, *model, log, robot);
  addJoints(*model, robot);
  return robot;
}

}  // namespace link_bounds
