// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line of urdf_bounds.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "tools/urdf_bounds/volume_table.h"

namespace link_bounds {

struct UrdfBoundsOptions {
  std::string file;                      ///< "-" is standard input
  std::map<std::string, double> joints;  ///< rad or m
  bool visual = true;
  bool collision = false;
  VolumeKind volume = VolumeKind::kBox;
  std::optional<Representation> representation;  ///< of kBox; none: min-max
  std::optional<double> distances;               ///< limit [m], finite, >= 0; none: not printed
  Format format = Format::kTable;
  bool verbose = false;
  bool strict = false;
  bool help = false;     ///< the other members are then undefined
  bool version = false;  ///< likewise
};

/// Throws UsageError. Call it once: getopt keeps state.
UrdfBoundsOptions parseOptions(int argc, char** argv);

/// What --help prints.
extern const char* const kUsage;

}  // namespace link_bounds
