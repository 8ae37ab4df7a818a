// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each refusal says what could be given instead.
#include "tools/urdf_bounds/input.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <locale>
#include <memory>
#include <sstream>

#include "link_bounds/robot/urdf/kinematics.h"
#include "tools/urdf_bounds/terminal.h"
#include "tools/urdf_bounds/urdf_bounds_options.h"

namespace link_bounds {
namespace {

/// Far above any real URDF; keeps an endless input from filling the memory.
constexpr std::size_t kMaxUrdfBytes = std::size_t{1} << 28;

void checkNames(const Robot& robot, const std::map<std::string, double>& given) {
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

/// One warning for all of them.
void checkLimits(const Robot& robot, const std::map<std::string, double>& given) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  for (const Joint& joint : robot.joints) {
    const auto found = given.find(joint.name);
    if (found == given.end() || joint.mimic || !joint.limits) continue;
    const auto [lower, upper] = *joint.limits;
    if (found->second >= lower && found->second <= upper) continue;
    text << (text.tellp() > 0 ? ", \"" : "\"") << joint.name << "\" at " << found->second
         << " (limits " << lower << " to " << upper << ")";
  }
  if (text.tellp() > 0)
    warn("beyond the limits of its joint in the URDF: " + text.str() +
         "; the boxes are those of this pose all the same");
}

}  // namespace

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
    if (text.size() > kMaxUrdfBytes) throw UsageError(name + " is too large for a URDF");
  }
  if (std::ferror(in.get())) throw UsageError("cannot read " + name + ": " + std::strerror(errno));
  return text;
}

std::string folderOf(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::vector<Eigen::Isometry3d> posesFor(const Robot& robot,
                                        const std::map<std::string, double>& given) {
  checkNames(robot, given);
  checkLimits(robot, given);
  return linkPoses(robot, jointValues(robot, given));
}

}  // namespace link_bounds
