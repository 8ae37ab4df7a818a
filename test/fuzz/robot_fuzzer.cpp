// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Any text as a robot description must give a valid robot whose links have finite boxes or none, or
// RobotError. The node parses it in its own process, so a crash here would end the node.
#include <set>

#include "fuzzing.h"
#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "mutation.h"

namespace link_bounds {
namespace {

constexpr double kUnit = 1e-9;  // deviation of an axis from unit length

void checkLinks(const Robot& robot) {
  std::set<std::string> names;
  for (const Link& link : robot.links) {
    require(names.insert(link.name).second, "names of links differ");
    for (const Element& element : link.elements) {
      require(isUsablePose(element.link_from_shape), "the place of a shape is usable");
      require(element.size.allFinite() && (element.size.array() >= 0).all(), "a size is a size");
      require((element.solid == Solid::kNone) != element.mesh_uri.empty(), "a solid or a mesh");
    }
    for (const LostElement& lost : link.lost)
      require(!lost.reason.empty() && lost.number > 0, "a loss has number and reason");
  }
}

void checkJoints(const Robot& robot) {
  require(robot.root < robot.links.size(), "the root is a link");
  require(robot.joints.size() + 1 == robot.links.size(), "each link but the root has a joint");
  std::set<std::size_t> reached{robot.root};
  for (const Joint& joint : robot.joints) {
    require(reached.count(joint.parent) == 1, "parents come before their children");
    require(joint.child < robot.links.size() && reached.insert(joint.child).second,
            "a link has one parent");
    require(joint.axis.isZero(0) || std::abs(joint.axis.norm() - 1) < kUnit,
            "an axis has unit length or none");
  }
}

/// Refuses all mesh files.
void checkBoxes(const Robot& robot) {
  RobotLoader loader([](const MeshFile&) -> TriangleMesh { throw MeshError("not here"); });
  const auto no_package = [](const std::string&) { return std::string(); };
  Selection all;
  all.collision = true;
  const std::vector<Eigen::Isometry3d> poses = linkPoses(robot, jointValues(robot, {}));
  const BoundedRobot bounded = loader.load(robot, all, {no_package});
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const BoundedLink& link = bounded.links[i];
    require(robot.links.at(bounded.indices[i]).name == link.name, "a bounded link is a link");
    const Eigen::Affine3d pose(poses[bounded.indices[i]].matrix());
    const std::optional<Aabb> box = linkBox(link, pose);
    require(!box || (box->min().allFinite() && box->max().allFinite()), "a box is finite");
  }
}

std::string inRobot(const std::string& content) {
  return "<?xml version='1.0'?><robot name='r'><link name='a'/>" + content + "</robot>";
}

std::string child(const std::string& content, const std::string& joint) {
  return "<link name='b'>" + content + "</link><joint name='j' " + joint + "</joint>";
}

const std::string kFixed = "type='fixed'><parent link='a'/><child link='b'/>";
const std::string kOrigin = "<origin xyz='0.1 0.2 0.3' rpy='0.5 0.25 0.125'/>";

std::vector<std::string> seeds() {
  return {inRobot(child("<visual>" + kOrigin + "<geometry><box size='1 2 3'/></geometry></visual>",
                        kFixed)),
          inRobot(child("<collision>" + kOrigin +
                            "<geometry><cylinder radius='0.5' length='2'/></geometry></collision>",
                        "type='revolute'><parent link='a'/><child link='b'/>" + kOrigin +
                            "<axis xyz='0 0.6 0.8'/><limit lower='-1' upper='1' effort='1' "
                            "velocity='1'/>")),
          inRobot(child("<visual><geometry><mesh filename='package://p/a.stl' scale='1 1 -0.001'/>"
                        "</geometry><material name='m'><color rgba='1 0 0 1'/></material></visual>",
                        "type='continuous'><parent link='a'/><child link='b'/><mimic joint='k' "
                        "multiplier='2' offset='0.1'/>") +
                  "<link name='c'><visual><geometry><sphere radius='1'/></geometry></visual>"
                  "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
                  "izz='1'/></inertial></link><joint name='k' type='prismatic'><parent link='b'/>"
                  "<child link='c'/><axis xyz='1 0 0'/><limit effort='1' velocity='1'/></joint>"),
          inRobot("<!-- twice --><visual/><link name='a'><collision/></link>"
                  "<gazebo reference='a'/><transmission name='t'/>"),
          inRobot("<link name='%s%n'><visual><origin xyz='%s%n%s%n'/></visual></link>"),
          "<robot name=unquoted><link name=a/></robot>"};
}

}  // namespace
}  // namespace link_bounds

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace link_bounds;
  const std::string urdf(reinterpret_cast<const char*>(data), size);
  try {
    const Robot robot = parseRobot(urdf);
    checkLinks(robot);
    checkJoints(robot);
    checkBoxes(robot);
  } catch (const RobotError& error) {
    require(*error.what() != '\0', "a reason is given");
  } catch (const JointError&) {
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned random) {
  using namespace link_bounds;
  static const std::vector<std::string> kSeeds = seeds();
  const std::size_t seed_size = seeded(kSeeds, random, data, size, max_size);
  if (seed_size > 0) return seed_size;
  if (random % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
  brute_force::Random generator(random);
  const std::string urdf(reinterpret_cast<const char*>(data), size);
  return replaceInput(mutatedText(urdf, generator), data, max_size);
}
