// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The text after := must be a number to its last character.
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

#include "tools/command_line/options.h"
#include "tools/command_line/text_file.h"

namespace link_bounds {

namespace {

/// A value, or a range a..b.
Limits jointRange(const std::string& joint, const std::string& text) {
  const std::size_t dots = text.find("..");
  const std::optional<double> lower = toNumber(text.substr(0, dots));
  const std::optional<double> upper =
      dots == std::string::npos ? lower : toNumber(text.substr(dots + 2));
  // -1...1 is not -1 to 0.1.
  const bool has_third_dot = text.find("...") != std::string::npos;
  if (!lower || !upper || has_third_dot) {
    throw UsageError("the value of joint \"" + joint + "\" is \"" + text +
                     "\", but must be a number, such as 0.5, or with --reach and --pairs a range, "
                     "such as -0.5..1");
  }
  if (*lower <= *upper) return {*lower, *upper};
  throw UsageError("the range of joint \"" + joint + "\" is \"" + text +
                   "\", but must go from the smaller number to the larger one");
}

/// An argument with := sets a joint; any other one is the URDF file.
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

double positive(const std::string& option_name, const std::string& text, const std::string& what) {
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

Representation representationOption(const std::string& option_name, const std::string& text) {
  return chosen<Representation>(option_name, text,
                                {{"min-max", Representation::kMinMax},
                                 {"min-width", Representation::kMinWidth},
                                 {"center-radius", Representation::kCenterRadius}});
}

VolumeKind volumeOption(const std::string& option_name, const std::string& text) {
  return chosen<VolumeKind>(option_name, text,
                            {{"sphere", VolumeKind::kSphere}, {"obb", VolumeKind::kOrientedBox}});
}

std::vector<Option> optionsInto(UrdfBoundsOptions& options) {
  const auto limit = [](const auto& name, const auto& text) { return limitOption(name, text); };
  const auto metres = [](const auto& name, const auto& text) {
    return positive(name, text, "metres");
  };
  const auto seconds = [](const auto& name, const auto& text) {
    return positive(name, text, "seconds");
  };
  const auto fixed_base = [](const auto& name, const auto& text) {
    return chosen<bool>(name, text, {{"fixed", true}});
  };
  const auto report = [&](const char* name, Report kind) {
    return Option{name, [&options, kind](const auto&, const auto&) { setReport(kind, options); },
                  false};
  };
  return {{"geometry", into(options.geometry, geometryOption)},
          {"representation", into(options.representation, representationOption)},
          {"format", [&](const auto&, const auto& text) { addFormat(text, options); }},
          {"volume", into(options.volume, volumeOption)},
          {"distances", into(options.distances, limit)},
          {"poses", into(options.poses, nonEmpty)},
          {"columns", into(options.columns, nonEmpty)},
          report("path", Report::kPath),
          {"objects", into(options.objects, nonEmpty)},
          {"series", into(options.series, nonEmpty)},
          {"jobs", into(options.jobs, jobsOption)},
          report("reach", Report::kReach),
          report("pairs", Report::kPairs),
          {"accuracy", into(options.accuracy, metres)},
          {"budget", into(options.budget, seconds)},
          {"clearance", into(options.clearance, limit)},
          {"touching", into(options.touching, limit)},
          {"srdf", into(options.srdf, nonEmpty)},
          {"certificate", into(options.certificate, nonEmpty)},
          {"base", into(options.has_fixed_base, fixed_base)},
          flag("adjacent", options.adjacent),
          flag("accept-sampled", options.accept_sampled),
          flag("verbose", options.verbose),
          flag("strict", options.demand.strict),
          flag("allow-incomplete", options.demand.allow_incomplete),
          flag("help", options.help),
          flag("version", options.version)};
}

void refuseRanges(const UrdfBoundsOptions& options) {
  for (const auto& [joint, range] : options.joints) {
    if (range.lower < range.upper) {
      throw UsageError("joint \"" + joint +
                       "\" is given a range, which is for --reach and --pairs; give a value");
    }
  }
}

/// Throws UsageError if an option is given without the report that uses it.
void need(bool is_given, bool is_useful, const char* option, const char* report) {
  if (is_given && !is_useful)
    throw UsageError(std::string(option) + " is an option of " + report + "; add " + report);
}

/// Checks the options that only proofs use.
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
  need(options.certificate.has_value(), has_reach || has_pairs || has_path, "--certificate",
       "--reach, --pairs or --path");
  need(options.adjacent, has_pairs, "--adjacent", "--pairs");
  need(options.accept_sampled, options.as_srdf, "--accept-sampled", "--format srdf");
  need(options.as_srdf, has_pairs, "--format srdf", "--pairs");
  need(options.as_markers, has_reach, "--format markers", "--reach");
}

/// Checks the options that only tables of joint values use.
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
}

/// Checks that the options fit the report.
void checkReport(const UrdfBoundsOptions& options) {
  checkProof(options);
  checkTable(options);
  checkStandardInput({{"the URDF", options.file},
                      {"--poses", options.poses.value_or("")},
                      {"--objects", options.objects.value_or("")},
                      {"--srdf", options.srdf.value_or("")}});
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
  const auto add_argument = [&](const std::string& text) { addArgument(text, options); };
  if (!parseCommandLine(argc, argv, optionsInto(options), add_argument)) return options;
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
