// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The first line of a certificate, and how much one claims.
#pragma once

#include <fstream>

#include "link_bounds/robot/urdf/robot.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Of the clearance that was proven. All of it would take a hundred times as many boxes or
/// intervals, most of them near the nearest pose.
constexpr double kClaimed = 0.5;

/// The file of --certificate with its first line, before the search for what it is to prove; not
/// open without that option. `kind` is what it is about: pairs, reach or path. Throws UsageError if
/// the file cannot be written.
std::ofstream beginCertificate(const char* kind, const UrdfBoundsOptions& options,
                               const Robot& robot);

/// With the last line: how many of `what` the certificate covers, and JSON about the others. Throws
/// UsageError if the file could not be written.
void endCertificate(const UrdfBoundsOptions& options, const char* what, std::size_t covered,
                    const std::string& not_covered, std::ofstream& out);

/// A JSON object on one line, of a map from verdicts to numbers.
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
