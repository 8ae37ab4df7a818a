// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/request/certificate_head.h"

#include <cerrno>
#include <cstring>

#include "tools/command_line/options.h"
#include "tools/formats/safe_text.h"

namespace link_bounds {

std::ofstream beginCertificate(const char* kind, const UrdfBoundsOptions& options,
                               const Robot& robot) {
  std::ofstream out;
  if (!options.certificate) return out;
  out.open(*options.certificate);
  const auto given = [](const auto& joint) {
    return jsonString(joint.first) + ": [" + exactNumber(joint.second.lower) + ", " +
           exactNumber(joint.second.upper) + "]";
  };
  out << "{\"certificate\": 1, \"of\": \"" << kind << "\", \"robot\": " << jsonString(robot.name)
      << ", \"geometry\": \"" << options.geometry
      << "\", \"clearance\": " << exactNumber(options.clearance.value_or(0))
      << ", \"touching\": " << exactNumber(options.touching.value_or(kDefaultTouching))
      << ", \"base\": \"" << (options.has_fixed_base ? "fixed" : "free") << "\", \"given\": {"
      << joined(options.joints, ", ", given) << "}}\n";
  if (!out.flush())
    throw UsageError("cannot write " + *options.certificate + ": " + std::strerror(errno));
  return out;
}

void endCertificate(const UrdfBoundsOptions& options, const char* what, std::size_t covered,
                    const std::string& not_covered, std::ofstream& out) {
  out << "{\"" << what << "\": " << covered << ", \"not_covered\": " << not_covered << "}\n";
  out.close();
  if (!out) throw UsageError("cannot write " + *options.certificate + "; is the disk full?");
}

}  // namespace link_bounds
