// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// A robot description as plain values: links in the order of the text, each with its placed
/// shapes, and joints from the root outward.
///
/// Units are those of URDF: metres and radians. urdfdom reads the text, as in robot_state_publisher
/// and rviz. Its model does not say what it could not parse, so it is compared with the XML.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

/// The description cannot be used at all; what() is the reason, in words for the user.
class RobotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Purpose { kVisual, kCollision };

/// "visual" or "collision".
const char* toText(Purpose purpose);

/// One `<visual>` or `<collision>` element of a link.
struct Element {
  Purpose purpose = Purpose::kVisual;
  std::size_t number = 0;      ///< counts the elements of this purpose in its link, from 1
  Solid solid = Solid::kNone;  ///< kNone for a mesh
  Eigen::Vector3d size = Eigen::Vector3d::Zero();                 ///< of the solid [m], see Shape
  std::string mesh_uri;                                           ///< as written; "" for a solid
  Eigen::Affine3d link_from_shape = Eigen::Affine3d::Identity();  ///< origin times mesh scale
};

/// An element of the URDF that cannot be used, or only in part; that part is then in
/// Link::elements.
struct LostElement {
  Purpose purpose;
  std::size_t number;  ///< from 1
  std::string reason;
};

struct Link {
  std::string name;
  std::vector<Element> elements;
  std::vector<LostElement> lost;
};

/// Whether the link has an element of that purpose, lost or not.
bool hasGeometry(const Link& link, Purpose purpose);

enum class Motion {
  kNone,         ///< fixed
  kRotation,     ///< revolute, continuous
  kTranslation,  ///< prismatic
  kPlanar,       ///< two translations and a rotation
  kFloating      ///< any pose
};

/// Whether one value says where a joint of that motion is.
inline bool hasValue(Motion motion) {
  return motion == Motion::kRotation || motion == Motion::kTranslation;
}

struct Mimic {
  std::string joint;
  double multiplier;
  double offset;  ///< rad or m
};

/// The range of a joint [rad or m].
struct Limits {
  double lower;
  double upper;
};

struct Joint {
  std::string name;
  std::size_t parent;  ///< index of a link
  std::size_t child;   ///< index of a link
  Motion motion;
  Eigen::Isometry3d parent_from_joint;
  Eigen::Vector3d axis;  ///< unit length, in the frame of the joint; zero if it is so in the URDF
  std::optional<Mimic> mimic;
  std::optional<Limits> limits;          ///< of revolute and prismatic joints, if the URDF has them
  std::optional<double> max_speed = {};  ///< [rad/s or m/s], if the URDF has a limit
  /// The floating or planar joint of which this is one value; "" if it is a joint of the URDF.
  std::string part_of = {};
};

struct Robot {
  std::string name;
  std::vector<Link> links;    ///< in the order of the `<link>` elements
  std::vector<Joint> joints;  ///< parents before children
  std::size_t root = 0;       ///< index of the root link
  std::vector<std::string> warnings;
};

/// Throws RobotError if the text is not a URDF, or its links are not one tree. Several threads may
/// call it; one at a time runs.
Robot parseRobot(const std::string& urdf);

}  // namespace link_bounds
