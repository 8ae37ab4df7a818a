// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The interface for Python, and the texts of help(). link_bounds/__init__.pyi has the same
// signatures.
#include <pybind11/stl.h>

#include "link_bounds/robot/urdf/kinematics.h"
#include "python/joint_input.h"
#include "python/posed_calls.h"
#include "python/proof_calls.h"
#include "python/text.h"
#include "tools/command_line/text_file.h"
#include "tools/formats/safe_text.h"

namespace py = pybind11;

namespace link_bounds {
namespace {

constexpr char kRobotDoc[] = R"(A robot of a URDF with its meshes, loaded once.

Robot(urdf, geometry='visual', packages=None, allow_incomplete=False)

  urdf              the path of a URDF file, or its text, which begins with '<'; relative names of
                    meshes start at the folder of the file, or at the current one
  geometry          'visual', 'collision' or 'both'
  packages          {package: folder} for meshes 'package://...'; other packages are found along
                    ROS_PACKAGE_PATH, as rospack does
  allow_incomplete  geometry that cannot be used is left out, and its links are in .incomplete

Lengths are metres, angles radians; all coordinates are in the frame of the root link.

q, a pose, is one of
  a dict {joint: value}      joints that are not named are at 0
  an array [joints]          in the order of .joints
  an array [rows, joints]    many poses; doubles in C order are not copied
  a list of dicts            many poses
Any mapping of names counts as a dict. Joints that mimic another one follow it. The limits of the
URDF are not enforced. Many poses are computed by `jobs` threads (0: one per core) without the GIL;
Ctrl-C ends that.

Several threads may use one robot.

Raises RobotError, in the words of urdf_bounds, for a URDF or a mesh that cannot be used, and
ValueError for arguments that cannot be used. A RuntimeWarning says what urdf_bounds warns of, and
at the first distances or proof which links have geometry of the other kind only.
)";

constexpr char kBoxesDoc[] = R"(The exact axis-aligned bounding boxes of all links.

  q        one pose or many, see Robot
  jobs     threads for many poses; 0: one per core
  returns  float64 [links, 2, 3], or [rows, links, 2, 3] for many poses: smallest and largest
           corner [m], in the order of .links, rounded outward

The numbers are those of urdf_bounds. With allow_incomplete, a link without a box has nan.
Raises ValueError, which names the joint and the row, for wrong shapes, names and values.
)";

constexpr char kDistancesDoc[] = R"(How far links are apart, between two proven bounds.

  q        one pose or many, see Robot
  limit    pairs whose distance is proven to be larger are left out [m], >= 0
  jobs     threads for many poses; 0: one per core
  returns  a structured array, one entry per pair, sorted by row, first and second:
             row           of q; 0 for one pose
             first         index in .links, smaller than second
             second        index in .links
             distance      proven: no points of the two are nearer [m]; 0: they may touch
             distance_max  the distance of on_first and on_second [m]
             on_first      [3] a point of the first link
             on_second     [3] a point of the second one
             normal        [3] unit, from the first to the second; 0 where distance is 0
             level         what decided: link_bounds.BOX, HULL or MESH

Links that fixed joints connect, or one movable joint, are no pair. distance_max - distance is at
most 1e-4 m, unless a search or a mesh is too large, which the two numbers show.
Raises ValueError as boxes() does.
)";

constexpr char kReachDoc[] = R"(Boxes that the links never leave while the joints move, proven.

  ranges      {joint: (lower, upper)} or {joint: value}, whatever the limits of the URDF; other
              joints move within their limits, continuous ones everywhere
  accuracy    each face is within this of a pose that attains it [m], > 0
  budget      the search ends after this [s], > 0, with what is proven by then
  fixed_base  floating and planar joints of the root stay at 0
  returns     {link: Reach}; a link of which nothing is proven is not in it, and a RuntimeWarning
              says why, as it does where the accuracy is not reached

Raises ValueError for ranges that cannot be used. Ctrl-C ends it.
)";

constexpr char kPairsDoc[] = R"(Which links can collide while the joints move, with proofs.

  ranges      as for reach()
  clearance   links that are as near collide [m], >= 0
  accuracy    of the clearances that are proven [m], > 0
  budget      the search ends after this [s], > 0; what is open by then is UNDECIDED
  adjacent    links with a joint between them are examined, too
  touching    links that are as near in all poses are TOUCHING [m], >= 0
  fixed_base  floating and planar joints of the root stay at 0
  jobs        threads; 0: one per core
  returns     a list of Pair, in the order of .links

Raises ValueError for arguments that cannot be used. Ctrl-C ends it.
)";

constexpr char kPathDoc[] =
    R"(Whether the robot collides on its way along poses, proven between them, too.

  q              [rows, joints], or a list of dicts: two way points or more, see Robot
  clearance      bodies that are as near collide [m], >= 0; 0: those that touch
  velocities     like q [rad/s, m/s], with times: the motion is cubic, as joint_trajectory_controller
                 interpolates; without them it is linear in the joints
  accelerations  like q [rad/s^2, m/s^2], with velocities: the motion is of fifth order
  times          [rows], growing [s]; numbers, no datetime64 or timedelta64
  objects        the path of a YAML file of objects around the robot, as for urdf_bounds --objects
  srdf           the path of a SRDF; pairs that it disables are left out
  budget         the search ends after this [s], > 0; what is open by then is UNDECIDED
  jobs           threads; 0: one per core
  returns        a list of Segment, one per way point but the last

Links that fixed joints connect, or one movable joint, are no pair. The verdicts are those of
urdf_bounds --path. Raises ValueError, which names the joint and the row, for arguments that cannot
be used, and RobotError for a file that cannot be used. Ctrl-C ends it.
)";

bool isPath(const py::handle& given) {
  return py::isinstance<py::str>(given) || py::isinstance<py::bytes>(given) ||
         py::hasattr(given, "__fspath__");
}

RobotRequest requestOf(const py::object& urdf, const std::string& geometry,
                       const py::object& packages, bool allow_incomplete) {
  RobotRequest request;
  const py::object encode = py::module::import("os").attr("fsencode");
  const std::string given = py::cast<std::string>(encode(urdf));
  if (given.empty()) throw py::value_error("the name of the URDF file is empty");
  const std::size_t begin = given.find_first_not_of(" \t\r\n\xEF\xBB\xBF");  // the last: a BOM
  const bool is_text = begin != std::string::npos && given[begin] == '<';
  if (given.find('\0') != std::string::npos)
    throw py::value_error("the URDF, or the name of its file, has a null byte");
  request.text = is_text ? given : textOfFile(given, "a URDF");
  request.base_folder = is_text ? "." : folderOf(given);
  if (geometry != "visual" && geometry != "collision" && geometry != "both")
    throw py::value_error("geometry is \"" + geometry +
                          "\", but must be one of: both, collision, visual");
  request.selection = selectionOf(geometry);
  if (!packages.is_none()) {
    const char* const what = " must be a dict {package: folder}";
    for (const auto& [key, folder] : dictOf(packages, "packages", what)) {
      const std::string name = keyName(key, "a package");
      if (!isPath(folder))
        throw py::value_error("the folder of package \"" + name + "\" is " +
                              py::cast<std::string>(py::repr(folder)) + ", but must be a path");
      request.packages[name] = py::cast<std::string>(encode(folder));
    }
  }
  request.allow_incomplete = allow_incomplete;
  return request;
}

std::unique_ptr<SharedRobot> load(const py::object& urdf, const std::string& geometry,
                                  const py::object& packages, bool allow_incomplete) {
  const RobotRequest request = requestOf(urdf, geometry, packages, allow_incomplete);
  auto shared = interruptible([&](const StopFlag& stop) {
    try {
      return std::make_unique<SharedRobot>(request, stop);
    } catch (const JointError& error) {  // no value was given yet: the URDF is wrong
      throw RobotError(error.what());
    }
  });
  for (const std::string& warning : shared->warnings())
    warnInPython(warning);
  return shared;
}

py::list linksOf(const SharedRobot& shared) {
  py::list names;
  for (const BoundedLink& link : shared.bounded().links)
    names.append(toPython(link.name));
  return names;
}

py::list jointsOf(const SharedRobot& shared) {
  py::list names;
  for (const std::size_t joint : shared.joints())
    names.append(toPython(shared.robot().joints[joint].name));
  return names;
}

py::dict incompleteOf(const SharedRobot& shared) {
  py::dict reasons;
  for (const BoundedLink& link : shared.bounded().links) {
    if (!link.isWhole()) reasons[toPython(link.name)] = toPython(link.missing);
  }
  return reasons;
}

py::str frameOf(const SharedRobot& shared) {
  return toPython(shared.robot().links[shared.robot().root].name);
}

py::dict poseOf(const std::map<std::string, double>& pose) {
  py::dict result;
  for (const auto& [joint, value] : pose)
    result[toPython(joint)] = py::float_(value);
  return result;
}

void addRobot(py::module& module) {
  py::class_<SharedRobot> robot(module, "Robot", kRobotDoc);
  robot.attr("__module__") = "link_bounds";
  robot.def(py::init(&load), py::arg("urdf"), py::arg("geometry") = "visual",
            py::arg("packages") = py::none(), py::arg("allow_incomplete") = false);
  robot.def_property_readonly("links", &linksOf,
                              "Names of the links with geometry, in the order of the URDF.");
  robot.def_property_readonly("joints", &jointsOf,
                              "Names of the joints that can be set. Those that mimic another one "
                              "follow it.\nOf a floating or planar joint j: j.x, j.y, ...");
  robot.def_property_readonly("frame", &frameOf, "The root link, in whose frame all results are.");
  robot.def_property_readonly("incomplete", &incompleteOf,
                              "{link: reason} of links whose boxes do not cover everything; empty "
                              "without allow_incomplete.");
  robot.def("boxes", &boxesOf, py::arg("q"), py::arg("jobs") = 0U, kBoxesDoc);
  robot.def("distances", &distancesOf, py::arg("q"), py::arg("limit"), py::arg("jobs") = 0U,
            kDistancesDoc);
  robot.def(
      "reach",
      [](const SharedRobot& shared, const py::object& ranges, double accuracy, double budget,
         bool fixed_base) {
        return reachOfRobot(shared, {ranges, accuracy, budget, fixed_base});
      },
      py::arg("ranges") = py::none(), py::arg("accuracy") = 0.01, py::arg("budget") = 60.0,
      py::arg("fixed_base") = false, kReachDoc);
  robot.def(
      "pairs",
      [](const SharedRobot& shared, const py::object& ranges, double clearance, double accuracy,
         double budget, bool adjacent, double touching, bool fixed_base, unsigned jobs) {
        return pairsOfRobot(shared, {ranges, accuracy, budget, fixed_base}, clearance, touching,
                            adjacent, jobs);
      },
      py::arg("ranges") = py::none(), py::arg("clearance") = 0.0, py::arg("accuracy") = 0.01,
      py::arg("budget") = 60.0, py::arg("adjacent") = false,
      py::arg("touching") = PairGoal().touching, py::arg("fixed_base") = false,
      py::arg("jobs") = 0U, kPairsDoc);
  robot.def(
      "check_path",
      [](const SharedRobot& shared, const py::object& q, double clearance,
         const py::object& velocities, const py::object& accelerations, const py::object& times,
         const py::object& objects, const py::object& srdf, double budget, unsigned jobs) {
        return checkPath(
            shared, {q, velocities, accelerations, times, objects, srdf, clearance, budget, jobs});
      },
      py::arg("q"), py::arg("clearance") = 0.0, py::arg("velocities") = py::none(),
      py::arg("accelerations") = py::none(), py::arg("times") = py::none(),
      py::arg("objects") = py::none(), py::arg("srdf") = py::none(), py::arg("budget") = 60.0,
      py::arg("jobs") = 0U, kPathDoc);
}

void addSegment(py::module& module) {
  py::class_<Segment> segment(module, "Segment",
                              "What is proven of the motion between two way points.");
  segment.attr("__module__") = "link_bounds";
  segment.def_property_readonly(
      "start", [](const Segment& self) { return self.start; },
      "Row at which it begins; it ends at the next one.");
  segment.def_property_readonly(
      "verdict", [](const Segment& self) { return toText(self.proof.verdict); },
      "SAFE, COLLIDES or UNDECIDED, as urdf_bounds --path says it.");
  segment.def_property_readonly(
      "clearance", [](const Segment& self) { return self.proof.clearance; },
      "Proven: at no time two bodies are nearer [m].");
  segment.def_property_readonly(
      "nearest", [](const Segment& self) { return self.proof.nearest; },
      "In pose, first and second are at most so far apart [m]; inf if no pose was measured.");
  segment.def_property_readonly(
      "first", [](const Segment& self) { return toPython(self.first); },
      "Name of a link or an object.");
  segment.def_property_readonly(
      "second", [](const Segment& self) { return toPython(self.second); },
      "Name of a link or an object.");
  segment.def_property_readonly(
      "at", [](const Segment& self) { return self.proof.share; },
      "When that is: the share of the time from row to row, 0 to 1.");
  segment.def_property_readonly(
      "pose", [](const Segment& self) { return poseOf(self.pose); },
      "{joint: value}: a pose that collides, or the nearest one that was found.");
  segment.def("__repr__", [](const Segment& self) {
    const std::string pair = self.first.empty() ? ""
                                                : ", nearest " + validUtf8(self.first) + " and " +
                                                      validUtf8(self.second);
    return "<Segment " + std::to_string(self.start) + ": " + toText(self.proof.verdict) + pair +
           ">";
  });
}

void addReach(py::module& module) {
  py::class_<Reach> reach(module, "Reach", "A box that a link never leaves, proven.");
  reach.attr("__module__") = "link_bounds";
  reach.def_property_readonly("box", &boxOf, "float64 [2, 3]: smallest and largest corner [m].");
  reach.def_property_readonly(
      "gap", &gapOf, "float64 [2, 3]: the pose that attains a face is this far from it [m].");
  reach.def_property_readonly(
      "attained",
      [](const Reach& self) {
        py::list poses;
        for (const ReachFace& face : self.faces)
          poses.append(poseOf(face.pose));
        return poses;
      },
      "Six poses {joint: value}, one near each face: min x, y, z, then max x, y, z.");
  reach.def("__repr__", [](const Reach& self) {
    return "<Reach " + py::cast<std::string>(py::repr(boxOf(self).attr("tolist")())) + ">";
  });
}

void addPair(py::module& module) {
  py::class_<NamedProof> pair(module, "Pair", "What is proven of two links.");
  pair.attr("__module__") = "link_bounds";
  pair.def_property_readonly(
      "first", [](const NamedProof& self) { return toPython(self.first); }, "Name of a link.");
  pair.def_property_readonly(
      "second", [](const NamedProof& self) { return toPython(self.second); }, "Name of a link.");
  pair.def_property_readonly(
      "verdict", [](const NamedProof& self) { return toText(self.proof.verdict); },
      "NEVER, ALWAYS, TOUCHING, CONTACT_SAMPLED, SOMETIMES, UNDECIDED or ADJACENT, as urdf_bounds "
      "--pairs says it.");
  pair.def_property_readonly(
      "clearance", [](const NamedProof& self) { return self.proof.clearance; },
      "Proven: in no pose the links are nearer [m].");
  pair.def_property_readonly(
      "nearest", [](const NamedProof& self) { return self.proof.nearest; },
      "In pose the links are at most so far apart [m]; inf if none was tried.");
  pair.def_property_readonly(
      "pose", [](const NamedProof& self) { return poseOf(self.proof.pose); },
      "{joint: value}: a pose that collides, or the nearest one that was found.");
  pair.def_property_readonly(
      "reason", [](const NamedProof& self) { return toPython(self.proof.reason); },
      "Which joints between the links have no range, of an UNDECIDED pair; '' for any other "
      "reason.");
  pair.def("__repr__", [](const NamedProof& self) {
    return "<Pair " + validUtf8(self.first) + ", " + validUtf8(self.second) + ": " +
           toText(self.proof.verdict) + ">";
  });
}

void addErrors(py::module& module) {
  // Never freed: exceptions may be translated while the interpreter ends.
  static PyObject* const robot_error =
      PyErr_NewExceptionWithDoc("link_bounds.RobotError", "A URDF or a mesh that cannot be used.",
                                PyExc_RuntimeError, nullptr);
  module.attr("RobotError") = py::reinterpret_borrow<py::object>(robot_error);
  py::register_exception_translator([](std::exception_ptr error) {
    if (error) translate(error, robot_error);
  });
}

}  // namespace
}  // namespace link_bounds

PYBIND11_MODULE(_robot, module) {
  using namespace link_bounds;
  module.doc() = "The exact boxes of a robot's links, proven distances, and proofs.";
  watchEndOfPython();
  registerPairRow();
  addErrors(module);
  addReach(module);
  addPair(module);
  addSegment(module);
  addRobot(module);
  module.attr("BOX") = static_cast<int>(DistanceLevel::kBox);
  module.attr("HULL") = static_cast<int>(DistanceLevel::kHull);
  module.attr("MESH") = static_cast<int>(DistanceLevel::kMesh);
}
