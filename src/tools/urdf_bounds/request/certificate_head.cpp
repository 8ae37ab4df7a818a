// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/request/certificate_head.h"

#include "tools/command_line/options.h"
#include "tools/text/safe_text.h"

namespace link_bounds {

std::ofstream beginCertificate(const char* kind, const UrdfBoundsOptions& options,
                               const Robot& robot) {
  std::ofstream out;
  if (!options.certificate) return out;
  out.open(*options.certificate);
  const char* const geometry = !options.collision ? "visual"
                               : options.visual   ? "both"
                                                  : "collision";
  out << "{\"certificate\": 1, \"of\": \"" << kind << "\", \"robot\": " << jsonString(robot.name)
      << ", \"geometry\": \"" << geometry
      << "\", \"clearance\": " << exactNumber(options.clearance.value_or(0))
      << ", \"touching\": " << exactNumber(options.touching.value_or(kDefaultTouching))
      << ", \"base\": \"" << (options.has_fixed_base ? "fixed" : "free") << "\", \"given\": {";
  const char* separator = "";
  for (const auto& [joint, range] : options.joints) {
    out << separator << jsonString(joint) << ": [" << exactNumber(range.lower) << ", "
        << exactNumber(range.upper) << "]";
    separator = ", ";
  }
  out << "}}\n";
  if (!out.flush()) throw UsageError("cannot write " + *options.certificate);
  return out;
}

void endCertificate(const UrdfBoundsOptions& options, std::ofstream& out) {
  out.close();
  if (!out) throw UsageError("cannot write " + *options.certificate);
}

}  // namespace link_bounds
