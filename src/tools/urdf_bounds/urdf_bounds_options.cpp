// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// By getopt_long. The text after := must be a number to its last character.
#include "tools/urdf_bounds/urdf_bounds_options.h"

#include <getopt.h>

#include "tools/command_line/options.h"

namespace link_bounds {

namespace {

enum Code {
  kGeometry = 256,
  kRepresentation,
  kFormat,
  kVolume,
  kDistances,
  kPoses,
  kColumns,
  kPath,
  kObjects,
  kSeries,
  kJobs,
  kReach,
  kPairs,
  kAccuracy,
  kBudget,
  kClearance,
  kTouching,
  kSrdf,
  kCertificate,
  kBase,
  kAdjacent,
  kAcceptSampled,
  kVerbose,
  kStrict,
  kAllowIncomplete,
  kHelp,
  kVersion
};

constexpr option kLongOptions[] = {{"geometry", required_argument, nullptr, kGeometry},
                                   {"representation", required_argument, nullptr, kRepresentation},
                                   {"format", required_argument, nullptr, kFormat},
                                   {"volume", required_argument, nullptr, kVolume},
                                   {"distances", required_argument, nullptr, kDistances},
                                   {"poses", required_argument, nullptr, kPoses},
                                   {"columns", required_argument, nullptr, kColumns},
                                   {"path", no_argument, nullptr, kPath},
                                   {"objects", required_argument, nullptr, kObjects},
                                   {"series", required_argument, nullptr, kSeries},
                                   {"jobs", required_argument, nullptr, kJobs},
                                   {"reach", no_argument, nullptr, kReach},
                                   {"pairs", no_argument, nullptr, kPairs},
                                   {"accuracy", required_argument, nullptr, kAccuracy},
                                   {"budget", required_argument, nullptr, kBudget},
                                   {"clearance", required_argument, nullptr, kClearance},
                                   {"touching", required_argument, nullptr, kTouching},
                                   {"srdf", required_argument, nullptr, kSrdf},
                                   {"certificate", required_argument, nullptr, kCertificate},
                                   {"base", required_argument, nullptr, kBase},
                                   {"adjacent", no_argument, nullptr, kAdjacent},
                                   {"accept-sampled", no_argument, nullptr, kAcceptSampled},
                                   {"verbose", no_argument, nullptr, kVerbose},
                                   {"strict", no_argument, nullptr, kStrict},
                                   {"allow-incomplete", no_argument, nullptr, kAllowIncomplete},
                                   {"help", no_argument, nullptr, kHelp},
                                   {"version", no_argument, nullptr, kVersion},
                                   {nullptr, 0, nullptr, 0}};

/// A value, or a range a..b.
Limits jointRange(const std::string& joint, const std::string& text) {
  const std::size_t dots = text.find("..");
  const std::optional<double> lower = toNumber(text.substr(0, dots));
  const std::optional<double> upper =
      dots == std::string::npos ? lower : toNumber(text.substr(dots + 2));
  if (!lower || !upper) {
    throw UsageError("the value of joint \"" + joint + "\" is \"" + text +
                     "\", but must be a number, such as 0.5, or with --reach and --pairs a range, "
                     "such as -0.5..1");
  }
  if (*lower <= *upper) return {*lower, *upper};
  throw UsageError("the range of joint \"" + joint + "\" is \"" + text +
                   "\", but must go from the smaller number to the larger one");
}

/// An argument with := is a joint, another one the file.
void addArgument(const std::string& argument, UrdfBoundsOptions& options) {
  const std::size_t sign = argument.rfind(":=");
  if (sign != std::string::npos) {
    const std::string joint = argument.substr(0, sign);
    const Limits range = jointRange(joint, argument.substr(sign + 2));
    if (!options.joints.emplace(joint, range).second) {
      throw UsageError("joint \"" + joint + "\" is given twice");
    }
  } else if (options.file.empty()) {
    if (argument.empty()) throw UsageError("the name of the URDF file is empty");
    options.file = argument;
  } else {
    throw UsageError("\"" + argument + "\" is one file too many, after \"" + options.file +
                     "\"; a joint is written joint:=value");
  }
}

void addGeometry(const std::string& name, UrdfBoundsOptions& options) {
  enum Kind { kVisual = 1, kCollision = 2, kBoth = 3 };
  const Kind kind = chosen<Kind>("--geometry", name,
                                 {{"visual", kVisual}, {"collision", kCollision}, {"both", kBoth}});
  options.visual = (kind & kVisual) != 0;
  options.collision = (kind & kCollision) != 0;
}

double positive(const std::string& option_name, const std::string& text, const char* what) {
  const std::optional<double> value = toNumber(text);
  if (value && *value > 0) return *value;
  throw UsageError(option_name + " is \"" + text + "\", but must be a number of " + what +
                   " > 0, such as 0.01");
}

void addFormat(const std::string& name, UrdfBoundsOptions& options) {
  options.as_srdf = name == "srdf";
  options.as_markers = name == "markers";
  if (options.as_srdf || options.as_markers) return;
  options.format = chosen<std::optional<Format>>("--format", name,
                                                 {{"table", Format::kTable},
                                                  {"csv", Format::kCsv},
                                                  {"json", Format::kJson},
                                                  {"markers", std::nullopt},
                                                  {"srdf", std::nullopt}})
                       .value_or(Format::kTable);
}

void setReport(Report report, UrdfBoundsOptions& options) {
  if (options.report != Report::kPose && options.report != report)
    throw UsageError("--reach, --pairs and --path are different reports; give only one of them");
  options.report = report;
}

/// `code` is what getopt_long returned.
void addOption(int code, const char* const* argv, UrdfBoundsOptions& options) {
  switch (code) {
    case 1:
      return addArgument(optarg, options);
    case kGeometry:
      return addGeometry(optarg, options);
    case kRepresentation:
      options.representation =
          chosen<Representation>("--representation", optarg,
                                 {{"min-max", Representation::kMinMax},
                                  {"min-width", Representation::kMinWidth},
                                  {"center-radius", Representation::kCenterRadius}});
      return;
    case kFormat:
      return addFormat(optarg, options);
    case kVolume:
      options.volume = chosen<VolumeKind>(
          "--volume", optarg, {{"sphere", VolumeKind::kSphere}, {"obb", VolumeKind::kOrientedBox}});
      return;
    case kDistances:
      options.distances = limitOption("--distances", optarg);
      return;
    case kPoses:
      options.poses = optarg;
      return;
    case kColumns:
      options.columns = optarg;
      return;
    case kPath:
      return setReport(Report::kPath, options);
    case kObjects:
      options.objects = optarg;
      return;
    case kSeries:
      options.series = optarg;
      return;
    case kJobs:
      options.jobs = jobsOption(optarg);
      return;
    case kReach:
      return setReport(Report::kReach, options);
    case kPairs:
      return setReport(Report::kPairs, options);
    case kAccuracy:
      options.accuracy = positive("--accuracy", optarg, "metres");
      return;
    case kBudget:
      options.budget = positive("--budget", optarg, "seconds");
      return;
    case kClearance:
      options.clearance = limitOption("--clearance", optarg);
      return;
    case kTouching:
      options.touching = limitOption("--touching", optarg);
      return;
    case kSrdf:
      options.srdf = optarg;
      return;
    case kCertificate:
      options.certificate = optarg;
      return;
    case kBase:
      options.has_fixed_base = chosen<bool>("--base", optarg, {{"fixed", true}});
      return;
    case kAdjacent:
      options.adjacent = true;
      return;
    case kAcceptSampled:
      options.accept_sampled = true;
      return;
    case kVerbose:
      options.verbose = true;
      return;
    case kStrict:
      options.demand.strict = true;
      return;
    case kAllowIncomplete:
      options.demand.allow_incomplete = true;
      return;
    case 'h':
    case kHelp:
      options.help = true;
      return;
    case kVersion:
      options.version = true;
      return;
    case ':':
      throw UsageError(std::string("option ") + argv[optind - 1] + " needs a value");
    default:
      throw UsageError(badOption(argv, kGeometry));
  }
}

void refuseRanges(const UrdfBoundsOptions& options) {
  for (const auto& [joint, range] : options.joints) {
    if (range.lower < range.upper) {
      throw UsageError("joint \"" + joint +
                       "\" is given a range, which is for --reach and --pairs; give a value");
    }
  }
}

/// Throws if an option is given that is of no use.
void need(bool is_given, bool is_useful, const char* option, const char* report) {
  if (is_given && !is_useful)
    throw UsageError(std::string(option) + " is an option of " + report + "; add " + report);
}

/// Options that only proofs have.
void checkProof(const UrdfBoundsOptions& options) {
  const bool has_pairs = options.report == Report::kPairs;
  const bool has_reach = options.report == Report::kReach;
  const bool has_path = options.report == Report::kPath;
  need(options.accuracy.has_value(), has_reach || has_pairs, "--accuracy", "--reach or --pairs");
  need(options.budget.has_value(), has_reach || has_pairs || has_path, "--budget",
       "--reach, --pairs or --path");
  need(options.clearance.has_value(), has_pairs || has_path, "--clearance", "--pairs or --path");
  need(options.has_fixed_base, has_reach || has_pairs, "--base", "--reach or --pairs");
  need(options.touching.has_value(), has_pairs, "--touching", "--pairs");
  need(options.srdf.has_value(), has_pairs || has_path, "--srdf", "--pairs or --path");
  need(options.certificate.has_value(), has_reach || has_pairs, "--certificate",
       "--reach or --pairs");
  need(options.adjacent, has_pairs, "--adjacent", "--pairs");
  need(options.accept_sampled, options.as_srdf, "--accept-sampled", "--format srdf");
  need(options.as_srdf, has_pairs, "--format srdf", "--pairs");
  need(options.as_markers, has_reach, "--format markers", "--reach");
}

/// Options that only tables of joint values have.
void checkTable(const UrdfBoundsOptions& options) {
  const bool has_rows = options.report == Report::kRows;
  const bool has_path = options.report == Report::kPath;
  need(has_path, options.poses.has_value(), "--path", "--poses FILE");
  need(options.objects.has_value(), has_path, "--objects", "--path");
  if (options.series && has_path)
    throw UsageError(
        "--series writes rows, --path is about what is between them; give only one of "
        "the two");
  need(options.columns.has_value(), has_rows || has_path, "--columns", "--poses FILE");
  need(options.jobs.has_value(), has_rows || has_path, "--jobs", "--poses FILE");
  need(options.series.has_value(), has_rows, "--series", "--poses FILE");
  if (options.poses && !has_rows && !has_path)
    throw UsageError(
        "--poses gives the joint values, --reach and --pairs are about all of them; "
        "give only one of the two");
  if (options.poses == "-" && options.file == "-")
    throw UsageError("the URDF and --poses cannot both come from standard input; name a file");
}

/// Options that only some reports have.
void checkReport(const UrdfBoundsOptions& options) {
  checkProof(options);
  checkTable(options);
  const Report report = options.report;
  if (report != Report::kReach && report != Report::kPairs) refuseRanges(options);
  if (report == Report::kPose) return;
  const bool has_distances = options.distances && report != Report::kRows;
  const char* const of_a_pose = options.representation               ? "--representation"
                                : has_distances                      ? "--distances"
                                : options.volume != VolumeKind::kBox ? "--volume"
                                                                     : nullptr;
  const char* const other = report == Report::kReach   ? "--reach"
                            : report == Report::kPairs ? "--pairs"
                            : report == Report::kPath  ? "--path"
                                                       : "--poses";
  if (of_a_pose) {
    throw UsageError(
        std::string(of_a_pose) + " is about one pose, " + other + " about " +
        (report == Report::kReach || report == Report::kPairs ? "all of them" : "many") +
        "; give only one of the two");
  }
}

}  // namespace

UrdfBoundsOptions parseOptions(int argc, char** argv) {
  UrdfBoundsOptions options;
  opterr = 0;
  int code = 0;
  // The leading minus returns other arguments in order, even if POSIXLY_CORRECT is set.
  while ((code = getopt_long(argc, argv, "-:h", kLongOptions, nullptr)) != -1) {
    addOption(code, argv, options);
    if (options.help || options.version) return options;
  }
  for (; optind < argc; ++optind)
    addArgument(argv[optind], options);
  if (options.file.empty()) throw UsageError("no URDF file is given");
  if (options.poses && options.report == Report::kPose) options.report = Report::kRows;
  checkReport(options);
  if (options.representation && options.volume != VolumeKind::kBox) {
    throw UsageError(
        "--representation is about axis-aligned boxes, --volume asks for another one;"
        " give only one of them");
  }
  if (options.distances && options.volume != VolumeKind::kBox) {
    throw UsageError(
        "--distances come with axis-aligned boxes, --volume asks for another one; give only one of"
        " them");
  }
  return options;
}

}  // namespace link_bounds
