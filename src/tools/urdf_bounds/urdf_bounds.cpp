// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From a URDF file and joint values to boxes, or other volumes, on standard output.
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

#include "link_bounds/robot/bounded_robot.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "link_bounds/robot/worker/mesh_process.h"
#include "packages/package_path.h"
#include "tools/urdf_bounds/box_table.h"
#include "tools/urdf_bounds/terminal.h"
#include "tools/urdf_bounds/urdf_bounds_options.h"
#include "tools/urdf_bounds/volume_table.h"

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

using LinkPoses = std::unordered_map<std::string, Eigen::Isometry3d>;

/// In the frame of the root link.
LinkPoses posesByName(const Robot& robot, const std::vector<double>& values) {
  const std::vector<Eigen::Isometry3d> poses = linkPoses(robot, values);
  LinkPoses result;
  for (std::size_t i = 0; i < poses.size(); ++i)
    result.emplace(robot.links[i].name, poses[i]);
  return result;
}

/// The volume of each link that has one by `volume_of`, which gives an optional. A link whose
/// volume is missing or covers only part is named, with a reason, as incomplete.
template <class Volume, class VolumeOf>
void fillTable(const std::vector<BoundedLink>& links, const LinkPoses& root_from_link,
               const VolumeOf& volume_of, std::vector<std::pair<std::string, Volume>>& volumes,
               Reasons& incomplete) {
  for (const BoundedLink& link : links) {
    const std::optional<Volume> volume = volume_of(link, root_from_link.at(link.name));
    if (volume) volumes.emplace_back(link.name, *volume);
    if (!link.isWhole()) {
      incomplete.emplace_back(link.name, link.missing);
    } else if (!volume) {
      incomplete.emplace_back(link.name, "its size and pose give no finite box");
      warn("link \"" + link.name + "\": " + incomplete.back().second);
    }
  }
}

/// Writes the boxes of the links and the box around them; returns what is incomplete.
Reasons writeBoxes(const UrdfBoundsOptions& options, const std::string& frame,
                   const std::vector<BoundedLink>& links, const LinkPoses& root_from_link) {
  BoxTable table;
  table.frame = frame;
  const auto box_of = [](const BoundedLink& link, const Eigen::Isometry3d& pose) {
    return linkBox(link, Eigen::Affine3d(pose));
  };
  fillTable(links, root_from_link, box_of, table.boxes, table.incomplete);
  Aabb robot_box;
  for (const auto& named : table.boxes)
    robot_box.extend(named.second);
  if (!table.boxes.empty()) table.groups.emplace_back("robot", robot_box);
  writeBoxes(table, options.format, options.representation.value_or(Representation::kMinMax),
             std::cout);
  return table.incomplete;
}

/// The same with another volume, which `volume_of` computes in the frame of a link.
template <class Volume>
Reasons writeVolumes(const UrdfBoundsOptions& options, const std::string& frame,
                     const std::vector<BoundedLink>& links, const LinkPoses& root_from_link,
                     std::optional<Volume> (*volume_of)(const BoundedLink&)) {
  VolumeTable<Volume> table;
  table.frame = frame;
  const auto placed_volume = [volume_of](const BoundedLink& link, const Eigen::Isometry3d& pose) {
    const std::optional<Volume> volume = volume_of(link);
    return volume ? placed(*volume, pose) : std::nullopt;
  };
  fillTable(links, root_from_link, placed_volume, table.volumes, table.incomplete);
  writeVolumes(table, options.format, std::cout);
  return table.incomplete;
}

Reasons writeTable(const UrdfBoundsOptions& options, const std::string& frame,
                   const std::vector<BoundedLink>& links, const LinkPoses& root_from_link) {
  switch (options.volume) {
    case VolumeKind::kBox:
      break;
    case VolumeKind::kSphere:
      return writeVolumes(options, frame, links, root_from_link, boundingSphere);
    case VolumeKind::kOrientedBox:
      return writeVolumes(options, frame, links, root_from_link, orientedBox);
  }
  return writeBoxes(options, frame, links, root_from_link);
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
  const LinkPoses root_from_link = posesByName(robot, jointValues(robot, options.joints));

  Selection selection;
  selection.visual = options.visual;
  selection.collision = options.collision;
  MeshSource source{rosPackages(), folderOf(options.file), progressBar()};
  const std::string worker = meshWorker();
  MeshStore store(
      [&worker](const MeshFile& file) { return importInProcess(worker, file, MeshLimits()); });
  const BoundedRobot bounded = boundRobot(robot, selection, source, store);
  for (const std::string& problem : bounded.problems)
    warn(problem);

  const std::string& frame = robot.links[robot.root].name;
  const Reasons incomplete = writeTable(options, frame, bounded.links, root_from_link);
  if (options.verbose) reportMemory(bounded);
  if (!finishOutput()) return 1;
  return options.strict && !incomplete.empty() ? 2 : 0;
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
