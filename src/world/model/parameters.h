// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The parameters that decide about the values of boxes and when they are published.
#pragma once

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace link_bounds {

/// A parameter has an unusable value. The message names it and says what it must be.
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr char kRobotGroup[] = "robot";  ///< the group of all links

/// For meanings and units, see node/interface/parameter_table.h; also for struct Parameters.
struct LinkParameters {
  std::string geometry = "visual";
  std::vector<std::string> links;
  std::vector<std::string> ignore_links;
  double padding = 0.0;
  std::map<std::string, double> link_padding;
  std::string tf_prefix;
};

struct Parameters : LinkParameters {
  std::string fixed_frame;
  std::map<std::string, std::vector<std::string>> groups;
  double max_rate = 0.0;
  double timeout = 2.0;
  double marker_rate = 30.0;
  std::string marker_style = "both";
  std::array<double, 4> marker_color{{0.1, 0.7, 1.0, 0.25}};
  bool marker_labels = false;
  double overlap_margin = 0.0;
  std::vector<std::string> ignore_pairs;
  std::map<std::string, std::vector<std::string>> attached;
  int adjacent_joints = 1;
  int max_pairs = 10000;
  double distance_limit = 0.1;
  double distance_accuracy = 1e-4;
  double distance_relative_accuracy = 0;
  double distance_warning = 0.0;
  double swept_span = 0.0;
  std::map<std::string, double> deceleration;
  std::map<std::string, double> base_deceleration;
  std::map<std::string, double> acceleration;
  double reaction_time = 0.1;
  std::string during_reaction = "measured";
  double velocity_window = 0.05;
  bool joint_states = false;
  int parts_per_link = 1;
  double mesh_timeout = 30.0;
  int max_mesh_bytes = 536870912;
};

}  // namespace link_bounds
