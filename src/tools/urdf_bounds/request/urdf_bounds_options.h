// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line of urdf_bounds.
#pragma once

#include <optional>
#include <string>

#include "robot/urdf/joint_ranges.h"
#include "tools/command_line/outcome.h"
#include "tools/formats/table_text.h"

namespace link_bounds {

/// The kind of report: boxes of one pose or of the rows of a table, or proofs about all poses or
/// about the motion from row to row.
enum class Report { kPose, kRows, kPath, kReach, kPairs };

/// The bounding volumes of the paper's Figure 2; kBox is axis-aligned.
enum class VolumeKind { kBox, kSphere, kOrientedBox };

/// The three pairs of vectors (a, b) of the paper's Figure 3.
enum class Representation { kMinMax, kMinWidth, kCenterRadius };

/// Defaults of --accuracy, --budget and --touching.
constexpr double kDefaultAccuracy = 0.01;  // m
constexpr double kDefaultBudget = 60;      // s
constexpr double kDefaultTouching = 1e-4;  // m, of --pairs

struct UrdfBoundsOptions {
  std::string file;    ///< "-" is standard input
  GivenRanges joints;  ///< [rad or m]; lower == upper, except for kReach and kPairs
  Report report = Report::kPose;
  std::string geometry = "visual";  ///< or collision, or both
  VolumeKind volume = VolumeKind::kBox;
  std::optional<Representation> representation;  ///< for kBox; none: min-max
  std::optional<double> distances;               ///< limit [m], finite, >= 0; none: not printed
  std::optional<std::string> poses;        ///< for kRows and kPath: a file; "-" is standard input
  std::optional<std::string> columns;      ///< for `poses`: names, separated by commas
  std::optional<std::string> series;       ///< for kRows: a file to write
  std::optional<std::string> objects;      ///< for kPath: a file
  std::optional<unsigned> jobs;            ///< for kRows and kPath, > 0; none: one per core
  std::optional<double> accuracy;          ///< [m], > 0; none: kDefaultAccuracy
  std::optional<double> budget;            ///< [s], > 0; none: kDefaultBudget
  std::optional<double> clearance;         ///< for kPairs and kPath [m], >= 0; none: 0
  std::optional<double> touching;          ///< for kPairs [m], >= 0; none: kDefaultTouching
  std::optional<std::string> srdf;         ///< for kPairs and kPath: a file
  std::optional<std::string> certificate;  ///< for kReach, kPairs and kPath: a file to write
  bool adjacent = false;                   ///< for kPairs
  bool has_fixed_base = false;             ///< floating and planar joints at the root stay at 0
  Format format = Format::kTable;
  bool as_srdf = false;         ///< for kPairs, instead of `format`
  bool accept_sampled = false;  ///< for `as_srdf`: also disables pairs by samples alone
  bool as_markers = false;      ///< for kReach, instead of `format`
  bool verbose = false;
  Demand demand;
  bool help = false;     ///< the other members are then undefined
  bool version = false;  ///< the other members are then undefined
};

/// Throws UsageError. Call it once: getopt keeps state.
UrdfBoundsOptions parseOptions(int argc, char** argv);

/// What --help prints.
extern const char* const kUsage;

}  // namespace link_bounds
