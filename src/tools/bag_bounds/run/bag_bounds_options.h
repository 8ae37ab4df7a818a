// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line of bag_bounds.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tools/command_line/outcome.h"
#include "tools/formats/table_text.h"
#include "world/model/parameters.h"

namespace link_bounds {

struct BagBoundsOptions {
  std::vector<std::string> bags;
  std::string urdf;                 ///< "-" is standard input
  Parameters parameters;            ///< of the node; options set some of them
  std::string zones;                ///< a file; "": none
  std::optional<double> distances;  ///< limit [m], finite, >= 0; none: not computed
  double start = 0;                 ///< s after the first message
  std::optional<double> end;        ///< s after the first message
  std::optional<double> at;         ///< s after the first message: also reports all boxes then
  Format format = Format::kTable;
  std::string out;                ///< a file; "": none
  std::string series;             ///< a file; "": none
  std::set<std::string> objects;  ///< topics of objects
  std::string tf_topic = "/tf";   ///< static transforms are on this name with "_static"
  std::string joint_states;       ///< a topic of joint states, instead of transforms; "": none
  std::string static_from;        ///< a bag whose static transforms are taken first; "": none
  double min_coverage = 0.99;     ///< of each link, object and zone, 0 to 1; see Coverage
  std::optional<unsigned> jobs;   ///< threads, or bags at once; > 0; none: one per core
  Demand demand;
  bool each = false;  ///< a line per bag, instead of one report
  /// Files that earlier runs of --each wrote; their bags are not read again.
  std::vector<std::string> resume;
  bool merge = false;                                     ///< `bags` are files that --each wrote
  std::map<std::string, std::vector<std::string>> given;  ///< values by name of the option
  bool help = false;                                      ///< the other members are then undefined
  bool version = false;                                   ///< the other members are then undefined
};

/// Throws UsageError. Call it once: getopt keeps state.
BagBoundsOptions parseOptions(int argc, char** argv);

/// What --help prints.
extern const char* const kUsage;

}  // namespace link_bounds
