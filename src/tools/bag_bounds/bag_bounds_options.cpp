// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// By getopt_long.
#include "tools/bag_bounds/bag_bounds_options.h"

#include <getopt.h>

#include "node/interface/parameter_table.h"
#include "tools/command_line/options.h"

namespace link_bounds {

const char* const kUsage =
    R"(usage: bag_bounds FILE.bag ... --urdf FILE.urdf [options]
       bag_bounds --each FILE.bag ... --urdf FILE.urdf [options] >> LINES.jsonl
       bag_bounds --merge LINES.jsonl ... [--format F]

Reads the recorded transforms of a robot and prints how far each of its links reached and when, who
entered which zone, and how near pairs of links came. The boxes are those that the node would have
published. Needs no ROS master. Bags may be compressed, cut or without an index; several are read
as one, by their record times.

  FILE.bag            bags (format 2.0) with /tf and /tf_static
  --urdf FILE         the robot, - is standard input; relative mesh names start at its folder
  --geometry G        visual (default), collision or both
  --fixed-frame F     frame of the report; default: the root link
  --zones FILE        a YAML file of boxes: NAME: {frame: F, min: [x, y, z], max: [x, y, z]};
                      without frame they are in the fixed frame
  --distances LIMIT   also the pairs whose proven distance was ever at most LIMIT [m], but none that
                      are rigidly connected or neighbours by one joint
  --objects TOPIC     markers (Marker or MarkerArray) become boxes, too, and so do boxes of another
                      node (AxisAlignedBoxArray, as ~boxes or ~stopping); may be given several times
  --tf-prefix P       tf has P/LINK for each link of the robot, as for the node's tf_prefix
  --tf-topic T        transforms are on T and T_static, instead of /tf and /tf_static
  --joint-states T    positions of joints (JointState) and the URDF's kinematics, instead of tf; the
                      root link stands, floating and planar joints have no transform
  --padding M         this and the next two are as the node's parameters: metres on every side
  --timeout S         a link without a newer transform for so long has no box; default 2, 0 = never
  --ignore-pairs "A B"  no distances between these links or objects; may be given several times
  --static-from BAG   first takes /tf_static of this bag: for a recording in parts, the first one
  --min-coverage C    share of the time between its first and last transform in which each link must
                      have a box, 0 to 1; default 0.99
  --start S           reports from S seconds after the first message on, as rosbag play -s
  --end S             reads no further than S seconds after the first message
  --at S              also all boxes S seconds after the first message, as tf2 interpolates
  --format F          table (default): rounded to micrometres
                      csv: kind,name,other,value,time,stamp
                      json: also says what is incomplete and why
  --out FILE          writes a bag of ~boxes (/link_bounds_publisher/boxes) at the record times
  --series FILE       writes csv: each box when it changed, and each distance within LIMIT
  --jobs N            threads in all, which unpack compressed bags; with --each, bags at once.
                      Default: one per core. The results are the same
  --each              one JSON line per bag, as soon as it is done; bags are not read as one
  --resume LINES      of --each: leaves out bags that have a line in this file, if bag, robot and
                      options are unchanged; may be given several times
  --merge             makes one report of files of lines: worst bags, pairs and zones
  --strict            exit with 2 if any geometry could not be used
  --allow-incomplete  what is incomplete does not change the exit code
  -h, --help          this text
  --version           the version of link_bounds

Lengths are metres, times are seconds. Exit code, the first that applies:
  1  unusable arguments, robot, zones or bags; no link ever had a box, or none in
     the frame of a zone, although nobody interrupted
  3  a zone was entered, or a distance was less than LIMIT, at a message or between two
  4  without --allow-incomplete: a name is incomplete, such as a link that never had a
     box, less than --min-coverage, or not any more at the end; a topic of --objects has no
     message, not all distances are known, a motion between two messages is undecided
     or a transform came late, nothing was compared, or a part of the bags was not
     read: damage, or interrupted
  2  see --strict
  0  everything was answered, and nothing was found
With --each and --merge it is the first of these that applies to any bag; a file of lines that ends
within a line leads to 4.
)";

namespace {

enum Code {
  kUrdf = 256,
  kGeometry,
  kFixedFrame,
  kZones,
  kDistances,
  kObjects,
  kTfPrefix,
  kTfTopic,
  kJointStates,
  kPadding,
  kTimeout,
  kIgnorePairs,
  kStaticFrom,
  kMinCoverage,
  kStart,
  kEnd,
  kAt,
  kFormat,
  kOut,
  kSeries,
  kEach,
  kJobs,
  kResume,
  kMerge,
  kStrict,
  kAllowIncomplete,
  kHelp,
  kVersion
};

constexpr option kLongOptions[] = {{"urdf", required_argument, nullptr, kUrdf},
                                   {"geometry", required_argument, nullptr, kGeometry},
                                   {"fixed-frame", required_argument, nullptr, kFixedFrame},
                                   {"zones", required_argument, nullptr, kZones},
                                   {"distances", required_argument, nullptr, kDistances},
                                   {"objects", required_argument, nullptr, kObjects},
                                   {"tf-prefix", required_argument, nullptr, kTfPrefix},
                                   {"tf-topic", required_argument, nullptr, kTfTopic},
                                   {"joint-states", required_argument, nullptr, kJointStates},
                                   {"padding", required_argument, nullptr, kPadding},
                                   {"timeout", required_argument, nullptr, kTimeout},
                                   {"ignore-pairs", required_argument, nullptr, kIgnorePairs},
                                   {"static-from", required_argument, nullptr, kStaticFrom},
                                   {"min-coverage", required_argument, nullptr, kMinCoverage},
                                   {"start", required_argument, nullptr, kStart},
                                   {"end", required_argument, nullptr, kEnd},
                                   {"at", required_argument, nullptr, kAt},
                                   {"format", required_argument, nullptr, kFormat},
                                   {"out", required_argument, nullptr, kOut},
                                   {"series", required_argument, nullptr, kSeries},
                                   {"each", no_argument, nullptr, kEach},
                                   {"jobs", required_argument, nullptr, kJobs},
                                   {"resume", required_argument, nullptr, kResume},
                                   {"merge", no_argument, nullptr, kMerge},
                                   {"strict", no_argument, nullptr, kStrict},
                                   {"allow-incomplete", no_argument, nullptr, kAllowIncomplete},
                                   {"help", no_argument, nullptr, kHelp},
                                   {"version", no_argument, nullptr, kVersion},
                                   {nullptr, 0, nullptr, 0}};

/// Throws UsageError if there is no text.
std::string nonEmpty(const std::string& option_name, const std::string& text) {
  if (text.empty()) throw UsageError(option_name + " is empty");
  return text;
}

/// In tf and in bags, names of topics begin with a slash.
std::string topicName(const std::string& option_name, const std::string& text) {
  const std::string name = nonEmpty(option_name, text);
  return name.front() == '/' ? name : "/" + name;
}

/// `rule` is what the value must be, see rules.
void checkRule(const std::string& option_name, const std::string& text, const std::string& rule) {
  if (!rule.empty()) throw UsageError(option_name + " is \"" + text + "\", but " + rule);
}

double shareOption(const std::string& option_name, const std::string& text) {
  const std::optional<double> share = toNumber(text);
  if (share && *share >= 0 && *share <= 1) return *share;
  throw UsageError(option_name + " is \"" + text + "\", but must be a number from 0 to 1");
}

/// `code` is what getopt_long returned.
void addOption(int code, const char* const* argv, BagBoundsOptions& options) {
  switch (code) {
    case 1:
      options.bags.push_back(nonEmpty("the name of a bag", optarg));
      return;
    case kUrdf:
      options.urdf = nonEmpty("--urdf", optarg);
      return;
    case kGeometry:
      options.geometry =
          chosen<std::string>("--geometry", optarg,
                              {{"visual", "visual"}, {"collision", "collision"}, {"both", "both"}});
      return;
    case kFixedFrame:
      options.fixed_frame = nonEmpty("--fixed-frame", optarg);
      return;
    case kZones:
      options.zones = nonEmpty("--zones", optarg);
      return;
    case kDistances:
      options.distances = limitOption("--distances", optarg);
      return;
    case kObjects:
      options.objects.insert(topicName("--objects", optarg));
      return;
    case kTfPrefix:
      options.tf_prefix = nonEmpty("--tf-prefix", optarg);
      return;
    case kTfTopic:
      options.tf_topic = topicName("--tf-topic", optarg);
      return;
    case kJointStates:
      options.joint_states = topicName("--joint-states", optarg);
      return;
    case kPadding:
      options.padding = limitOption("--padding", optarg);
      checkRule("--padding", optarg, rules::length(options.padding));
      return;
    case kTimeout:
      options.timeout = limitOption("--timeout", optarg, "seconds");
      return;
    case kIgnorePairs:
      checkRule("--ignore-pairs", optarg, rules::ignorePairs({optarg}));
      options.ignore_pairs.emplace_back(optarg);
      return;
    case kStaticFrom:
      options.static_from = nonEmpty("--static-from", optarg);
      return;
    case kMinCoverage:
      options.min_coverage = shareOption("--min-coverage", optarg);
      return;
    case kStart:
      options.start = limitOption("--start", optarg, "seconds");
      return;
    case kEnd:
      options.end = limitOption("--end", optarg, "seconds");
      return;
    case kAt:
      options.at = limitOption("--at", optarg, "seconds");
      return;
    case kFormat:
      options.format = chosen<Format>(
          "--format", optarg,
          {{"table", Format::kTable}, {"csv", Format::kCsv}, {"json", Format::kJson}});
      return;
    case kOut:
      options.out = nonEmpty("--out", optarg);
      return;
    case kSeries:
      options.series = nonEmpty("--series", optarg);
      return;
    case kEach:
      options.each = true;
      return;
    case kJobs:
      options.jobs = jobsOption(optarg);
      return;
    case kResume:
      options.resume.push_back(nonEmpty("--resume", optarg));
      return;
    case kMerge:
      options.merge = true;
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
      throw UsageError(badOption(argv, kUrdf));
  }
}

/// What --each cannot do, because it is about one bag or one report.
void checkEach(const BagBoundsOptions& options) {
  for (const std::string name : {"out", "series", "format", "at"})
    if (options.given.count(name))
      throw UsageError("--each has no --" + name + "; its lines are JSON, and --merge makes a " +
                       "report of them");
  std::set<std::string> names;
  for (const std::string& bag : options.bags)
    if (!names.insert(bag).second) throw UsageError(bag + ": is given twice; give each bag once");
}

void checkMerge(const BagBoundsOptions& options) {
  if (options.bags.empty()) throw UsageError("--merge needs a file of lines of --each");
  const std::set<std::string> fit{"merge", "format", "allow-incomplete"};
  for (const auto& [name, values] : options.given)
    if (!fit.count(name))
      throw UsageError("--" + name + " does not fit --merge, which reads no bag; leave it out");
}

void check(const BagBoundsOptions& options) {
  if (options.merge) return checkMerge(options);
  if (options.each) checkEach(options);
  if (!options.each && !options.resume.empty()) throw UsageError("--resume needs --each");
  if (options.bags.empty()) throw UsageError("no bag is given");
  if (options.urdf.empty()) throw UsageError("no robot is given; add --urdf FILE");
  if (options.end && *options.end < options.start)
    throw UsageError("--end is before --start; nothing would be reported");
  if (!options.joint_states.empty() && (options.tf_topic != "/tf" || !options.static_from.empty()))
    throw UsageError(
        "--joint-states is instead of transforms; leave out --tf-topic and --static-from");
}

}  // namespace

BagBoundsOptions parseOptions(int argc, char** argv) {
  BagBoundsOptions options;
  opterr = 0;
  int code = 0;
  int index = -1;
  // The leading minus returns other arguments in order, even if POSIXLY_CORRECT is set.
  while ((code = getopt_long(argc, argv, "-:h", kLongOptions, &index)) != -1) {
    addOption(code, argv, options);
    if (options.help || options.version) return options;
    if (code >= kUrdf) options.given[kLongOptions[index].name].emplace_back(optarg ? optarg : "");
  }
  for (; optind < argc; ++optind)
    options.bags.push_back(nonEmpty("the name of a bag", argv[optind]));
  check(options);
  return options;
}

}  // namespace link_bounds
