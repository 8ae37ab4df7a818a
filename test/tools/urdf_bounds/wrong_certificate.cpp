// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A certificate by an engine whose bodies move too little, of what the right one has proven:
// wrong_certificate ROBOT.urdf CERTIFICATE CLEARANCE|reach
#include <exception>
#include <iostream>

#include "robot/urdf/simple_joints.h"
#include "tools/command_line/text_file.h"
#include "tools/urdf_bounds/pairs_certificate.h"
#include "tools/urdf_bounds/reach_certificate.h"

namespace link_bounds {

namespace {

void run(const std::string& urdf, const std::string& certificate, const std::string& what) {
  const Robot robot = withSimpleJoints(parseRobot(readText(urdf, "a URDF")));
  Selection selection;
  selection.triangles = true;
  const BoundedRobot bounded =
      RobotLoader().load(robot, selection, {{}, folderOf(urdf), {}, {}, [] { return false; }});
  const std::vector<JointRange> ranges = jointRanges(robot);
  const auto is_over = [] { return false; };
  UrdfBoundsOptions options;
  options.certificate = certificate;
  if (what == "reach") {
    options.accuracy = 0.05;  // m
    const auto reaches = reachOf(robot, bounded, ranges, {*options.accuracy});
    writeReachCertificate(options, robot, bounded, ranges, reaches, is_over);
    return;
  }
  options.clearance = std::stod(what);
  const auto proofs = provePairs(robot, bounded, ranges, {*options.clearance}, {});
  writeCertificate(options, robot, bounded, ranges, proofs, is_over);
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) try {
  if (argc != 4) throw std::runtime_error("three arguments are needed");
  link_bounds::run(argv[1], argv[2], argv[3]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
