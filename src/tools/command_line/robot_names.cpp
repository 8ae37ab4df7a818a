// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command_line/robot_names.h"

#include <set>

#include "tools/command_line/options.h"
#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

/// Throws UsageError if two of `parts` have the same name after validUtf8().
template <class Parts>
void checkNamesOf(const char* what, const Parts& parts) {
  std::set<std::string> names;
  for (const auto& part : parts) {
    const std::string name = validUtf8(part.name);
    if (!names.insert(name).second)
      throw UsageError(std::string("two ") + what + " of the robot are called \"" + name +
                       "\" where bytes that are not UTF-8 are replaced; rename one, or save the "
                       "robot description as UTF-8");
  }
}

}  // namespace

void checkNames(const Robot& robot) {
  checkNamesOf("links", robot.links);
  checkNamesOf("joints", robot.joints);
}

}  // namespace link_bounds
