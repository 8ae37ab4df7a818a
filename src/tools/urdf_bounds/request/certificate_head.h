// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The first and the last line of a certificate, and how much clearance it claims.
#pragma once

#include <fstream>

#include "link_bounds/robot/urdf/robot.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// The fraction of the proven clearance that a certificate claims. To claim all of it would take a
/// hundred times as many boxes or intervals, most of them near the nearest pose.
constexpr double kClaimed = 0.5;

/// Opens the file of --certificate and writes its first line; returns a closed stream without that
/// option. Call it before the search, so that a bad file name fails early. `kind` is "pairs",
/// "reach" or "path". Throws UsageError if the file cannot be written.
std::ofstream beginCertificate(const char* kind, const UrdfBoundsOptions& options,
                               const Robot& robot);

/// Writes the last line and closes the file: how many of `what` the certificate covers, and JSON
/// about the others. Throws UsageError if the file could not be written.
void endCertificate(const UrdfBoundsOptions& options, const char* what, std::size_t covered,
                    const std::string& not_covered, std::ofstream& out);

/// A JSON object on one line; `counts` maps verdicts to numbers.
template <class Counts>
std::string jsonCounts(const Counts& counts) {
  return "{" +
         joined(counts, ", ",
                [](const auto& entry) {
                  return jsonString(toText(entry.first)) + ": " + std::to_string(entry.second);
                }) +
         "}";
}

}  // namespace link_bounds
