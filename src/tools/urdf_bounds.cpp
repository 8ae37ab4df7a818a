// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From a URDF file and joint values to boxes on standard output.
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <unordered_map>

#include "box_table.h"
#include "link_bounds/bounded_robot.h"
#include "link_bounds/kinematics.h"
#include "link_bounds/mesh_process.h"
#include "package_path.h"
#include "terminal.h"
#include "urdf_bounds_options.h"

namespace link_bounds {
namespace {

constexpr std::size_t kLargestUrdfBytes = std::size_t{1} << 28;

/// The text of a file or of standard input ("-"); throws UsageError with the reason.
std::string readText(const std::string& file) {
  const bool is_stdin = file == "-";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(
      is_stdin ? stdin : std::fopen(file.c_str(), "rb"), std::fclose);
  const std::string name = is_stdin ? "standard input" : file;
  if (!in) throw UsageError("cannot read " + name + ": " + std::strerror(errno));
  std::string text;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof(buffer), in.get())) {
    text.append(buffer, count);
    if (text.size() > kLargestUrdfBytes) throw UsageError(name + " is too large for a URDF");
  }
  if (std::ferror(in.get())) throw UsageError("cannot read " + name + ": " + std::strerror(errno));
  return text;
}

std::string folderOf(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Says which joints there are if a name is wrong, and which values mean nothing.
void checkJoints(const Robot& robot, const std::map<std::string, double>& given) {
  std::map<std::string, const Joint*> movable;
  std::string names;
  for (const Joint& joint : robot.joints) {
    if (joint.motion == Motion::kNone) continue;
    movable.emplace(joint.name, &joint);
    if (!joint.mimic) names += " " + joint.name;
  }
  for (const auto& [name, value] : given) {
    const auto found = movable.find(name);
    if (found == movable.end()) {
      throw UsageError("\"" + name + "\" is no movable joint of the robot; those that can be set:" +
                       (names.empty() ? " none" : names));
    }
    if (found->second->mimic) {
      warn("the value given for joint \"" + name + "\" is ignored, it mimics joint \"" +
           found->second->mimic->joint + "\"");
    }
  }
}

/// A link whose box is missing or covers only part is named, with a reason, as incomplete.
BoxTable boxTable(const Robot& robot, const BoundedRobot& bounded,
                  const std::vector<Eigen::Isometry3d>& root_from_link) {
  std::unordered_map<std::string, std::size_t> index;
  for (const Link& link : robot.links)
    index.emplace(link.name, index.size());
  BoxTable table;
  table.frame = robot.links[robot.root].name;
  Aabb robot_box;
  for (const BoundedLink& link : bounded.links) {
    const std::optional<Aabb> box =
        linkBox(link, Eigen::Affine3d(root_from_link[index.at(link.name)]));
    if (box) {
      table.boxes.emplace_back(link.name, *box);
      robot_box.extend(*box);
    }
    if (!link.isWhole()) {
      table.incomplete.emplace_back(link.name, link.missing);
    } else if (!box) {
      table.incomplete.emplace_back(link.name, "its size and pose give no finite box");
      warn("link \"" + link.name + "\": " + table.incomplete.back().second);
    }
  }
  if (!table.boxes.empty()) table.groups.emplace_back("robot", robot_box);
  return table;
}

/// Each mesh file with the memory it keeps, and what loading took at most.
void reportMemory(const BoundedRobot& bounded) {
  std::size_t total = 0;
  for (const auto& [path, points] : bounded.meshes) {
    say(std::to_string(points->bytes()) + " bytes, " + std::to_string(points->size()) +
        " vertices that can be extreme, " + path);
    total += points->bytes();
  }
  say(std::to_string(total) + " bytes in " + std::to_string(bounded.meshes.size()) + " mesh files");
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return;
  say(std::to_string(usage.ru_maxrss) + " kB of memory at the peak");
}

/// Standard output may be a full disk or a closed pipe.
bool finishOutput() {
  if (std::cout.flush()) return true;
  say("error: cannot write to standard output");
  return false;
}

int run(const UrdfBoundsOptions& options) {
  const Robot robot = parseRobot(readText(options.file));
  for (const std::string& warning : robot.warnings)
    warn(warning);
  checkJoints(robot, options.joints);
  const auto root_from_link = linkPoses(robot, jointValues(robot, options.joints));

  Selection selection;
  selection.visual = options.visual;
  selection.collision = options.collision;
  MeshSource source{rosPackages(), folderOf(options.file), progressBar()};
  const std::string worker = siblingProgram("mesh_worker");
  MeshStore store(
      [&worker](const MeshFile& file) { return importInProcess(worker, file, MeshLimits()); });
  const BoundedRobot bounded = boundRobot(robot, selection, source, store);
  for (const std::string& problem : bounded.problems)
    warn(problem);

  const BoxTable table = boxTable(robot, bounded, root_from_link);
  if (options.verbose) reportMemory(bounded);
  writeBoxes(table, options.format, options.representation, std::cout);
  if (!finishOutput()) return 1;
  return options.strict && !table.incomplete.empty() ? 2 : 0;
}

int runGuarded(int argc, char** argv) {
  try {
    const UrdfBoundsOptions options = parseOptions(argc, argv);
    if (!options.help) return run(options);
    std::cout << kUsage;
    return finishOutput() ? 0 : 1;
  } catch (const std::bad_alloc&) {
    say("error: out of memory");
  } catch (const std::exception& error) {
    say(std::string("error: ") + error.what());
    say("see urdf_bounds --help");
  }
  return 1;
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) {
  // A pipe that the reader closes is then an error to report like any other.
  std::signal(SIGPIPE, SIG_IGN);
  return link_bounds::runGuarded(argc, argv);
}
