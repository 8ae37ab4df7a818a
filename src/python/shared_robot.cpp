// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Loads triangles at once, because files may have changed by the first question about distances.
#include "python/shared_robot.h"

#include "packages/package_path.h"
#include "python/text.h"
#include "robot/bounded_robot.h"
#include "robot/urdf/simple_joints.h"
#include "text/joined.h"
#include "tools/urdf_bounds/request/objects.h"

namespace link_bounds {
namespace {

PackagePath packagePath(const std::map<std::string, std::string>& packages) {
  return [&packages, others = rosPackages()](const std::string& name) {
    const auto found = packages.find(name);
    return found != packages.end() ? found->second : others(name);
  };
}

BoundedRobot load(const Robot& robot, Selection selection, const PackagePath& packages,
                  const std::string& base_folder, const StopFlag& stop) {
  selection.triangles = true;
  const MeshSource source{packages, base_folder, {}, {}, [&stop] { return stop.load(); }};
  return RobotLoader().load(robot, selection, source);
}

void refuseLosses(const std::vector<std::string>& problems) {
  if (!problems.empty()) throw RobotError(joined(problems, "\n"));
}

}  // namespace

SharedRobot::SharedRobot(const RobotRequest& request, const StopFlag& stop)
    : robot_(parseRobot(request.text)),
      simple_(withSimpleJoints(robot_)),
      joints_(settableJoints(simple_)),
      allow_incomplete_(request.allow_incomplete),
      left_out_(leftOutNote(robot_, request.selection)),
      packages_(request.packages),
      bounded_(load(robot_, request.selection, packagePath(packages_), request.base_folder, stop)) {
  if (!allow_incomplete_ || stop) refuseLosses(bounded_.problems);
  borrow();  // makes the first one
}

BoundedRobot SharedRobot::loadObjects(const Robot& objects, const std::string& base_folder,
                                      const StopFlag& stop) const {
  BoundedRobot bounded = load(objects, {}, packagePath(packages_), base_folder, stop);
  nameObjects(bounded);
  if (!allow_incomplete_ || stop) refuseLosses(bounded.problems);
  return bounded;
}

void SharedRobot::warnOfLeftOut() const {
  if (left_out_.empty() || said_left_out_) return;
  warnInPython(left_out_ + "; geometry='both' takes them, too");
  said_left_out_ = true;
}

std::vector<std::string> SharedRobot::warnings() const {
  std::vector<std::string> result = robot_.warnings;
  for (std::string& problem : allProblems(bounded_))
    result.push_back(std::move(problem));
  return result;
}

SharedRobot::Borrowed SharedRobot::borrow() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!idle_.empty()) {
      Borrowed posed(idle_.back().release(), GiveBack{this});
      idle_.pop_back();
      return posed;
    }
  }
  return Borrowed(new PosedRobot(robot_, bounded_), GiveBack{this});
}

void SharedRobot::GiveBack::operator()(PosedRobot* posed) const {
  const std::lock_guard<std::mutex> lock(owner->mutex_);
  owner->idle_.push_back(std::unique_ptr<PosedRobot>(posed));
}

}  // namespace link_bounds
