// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/run/bag_bounds_options.h"

#include <sys/stat.h>

#include "node/interface/parameter_table.h"
#include "tools/command_line/options.h"
#include "tools/formats/safe_text.h"

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
                      have a box, of the time in which an object is there in which it must have one,
                      and of the time in which links have boxes in which each zone must be compared
                      with all of them, 0 to 1; default 0.99
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
  --allow-incomplete  what is incomplete does not change the exit code, unless Ctrl-C or SIGTERM
                      ended the run
  -h, --help          this text
  --version           the version of link_bounds

Lengths are metres, times are seconds. Exit code, the first that applies:
  1  unusable arguments, robot, zones or bags; no link ever had a box, or none in
     the frame of a zone, although nobody interrupted and nothing was found
  3  a zone was entered, or a distance was less than LIMIT or 0, at a message or between two
  4  without --allow-incomplete: a name is incomplete, such as a link or object that never had a
     box, less than --min-coverage, or not any more at the end, or a zone; a topic of
     --objects has no message, or only ignored ones, not all distances are known, a motion between
     two messages is undecided, a transform came late or a static one replaced another, nothing was
     compared, or a part of the bags was not read: damage, transforms or objects that were left
     out; in any case: interrupted
  2  see --strict
  0  everything was answered, and nothing was found
With --each and --merge it is the first of these that applies to any bag; a file of lines that ends
within a line leads to 4.
)";

namespace {

/// In tf and in bags, names of topics begin with a slash.
std::string topicName(const std::string& option_name, const std::string& text) {
  const std::string name = nonEmpty(option_name, text);
  return name.front() == '/' ? name : "/" + name;
}

/// Throws UsageError unless `rule` is "". It says what the value must be, see namespace rules.
void checkRule(const std::string& option_name, const std::string& text, const std::string& rule) {
  if (!rule.empty()) throw UsageError(option_name + " is \"" + text + "\", but " + rule);
}

double shareOption(const std::string& option_name, const std::string& text) {
  const std::optional<double> share = toNumber(text);
  if (share && *share >= 0 && *share <= 1) return *share;
  throw UsageError(option_name + " is \"" + text + "\", but must be a number from 0 to 1");
}

Format formatOption(const std::string& option_name, const std::string& text) {
  return chosen<Format>(
      option_name, text,
      {{"table", Format::kTable}, {"csv", Format::kCsv}, {"json", Format::kJson}});
}

double seconds(const std::string& option_name, const std::string& text) {
  return limitOption(option_name, text, "seconds");
}

double paddingOption(const std::string& option_name, const std::string& text) {
  const double padding = limitOption(option_name, text);
  checkRule(option_name, text, rules::length(padding));
  return padding;
}

std::vector<Option> optionsInto(BagBoundsOptions& options) {
  const auto metres = [](const auto& name, const auto& text) { return limitOption(name, text); };
  const auto add_objects = [&](const auto& name, const auto& text) {
    options.objects.insert(topicName(name, text));
  };
  const auto add_ignored = [&](const auto& name, const auto& text) {
    checkRule(name, text, rules::ignorePairs({text}));
    options.parameters.ignore_pairs.push_back(text);
  };
  const auto add_resume = [&](const auto& name, const auto& text) {
    options.resume.push_back(nonEmpty(name, text));
  };
  return {{"urdf", into(options.urdf, nonEmpty)},
          {"geometry", into(options.parameters.geometry, geometryOption)},
          {"fixed-frame", into(options.parameters.fixed_frame, nonEmpty)},
          {"zones", into(options.zones, nonEmpty)},
          {"distances", into(options.distances, metres)},
          repeatable("objects", add_objects),
          {"tf-prefix", into(options.parameters.tf_prefix, nonEmpty)},
          {"tf-topic", into(options.tf_topic, topicName)},
          {"joint-states", into(options.joint_states, topicName)},
          {"padding", into(options.parameters.padding, paddingOption)},
          {"timeout", into(options.parameters.timeout, seconds)},
          repeatable("ignore-pairs", add_ignored),
          {"static-from", into(options.static_from, nonEmpty)},
          {"min-coverage", into(options.min_coverage, shareOption)},
          {"start", into(options.start, seconds)},
          {"end", into(options.end, seconds)},
          {"at", into(options.at, seconds)},
          {"format", into(options.format, formatOption)},
          {"out", into(options.out, nonEmpty)},
          {"series", into(options.series, nonEmpty)},
          flag("each", options.each),
          {"jobs", into(options.jobs, jobsOption)},
          repeatable("resume", add_resume),
          flag("merge", options.merge),
          flag("strict", options.demand.strict),
          flag("allow-incomplete", options.demand.allow_incomplete),
          flag("help", options.help),
          flag("version", options.version)};
}

/// Throws UsageError if a bag is given twice, even by different names. Missing files are compared
/// by name.
void checkBagsOnce(const std::vector<std::string>& bags) {
  std::set<std::string> names;
  std::set<std::pair<dev_t, ino_t>> files;
  for (const std::string& bag : bags) {
    struct stat file {};
    const bool is_new_file =
        stat(bag.c_str(), &file) != 0 || files.emplace(file.st_dev, file.st_ino).second;
    if (!names.insert(bag).second || !is_new_file)
      throw UsageError(bag + ": is given twice; give each bag once");
  }
}

/// Throws UsageError for options that do not fit --each: they are about one bag or one report.
void checkEach(const BagBoundsOptions& options) {
  for (const std::string name : {"out", "series", "format", "at"})
    if (options.given.count(name))
      throw UsageError("--each has no --" + name + "; its lines are JSON, and --merge makes a " +
                       "report of them");
  for (const std::string& bag : options.bags)
    if (validUtf8(bag) != bag)
      throw UsageError(bag +
                       ": the name is not UTF-8, which lines of JSON must be; rename the bag");
}

void checkMerge(const BagBoundsOptions& options) {
  if (options.bags.empty()) throw UsageError("--merge needs a file of lines of --each");
  const std::set<std::string> fit{"merge", "format", "allow-incomplete"};
  for (const auto& [name, values] : options.given)
    if (!fit.count(name))
      throw UsageError("--" + name + " does not fit --merge, which reads no bag; leave it out");
}

/// Throws UsageError if --objects names the topic of transforms or joint states: its messages would
/// be taken for these.
void checkObjects(const BagBoundsOptions& options) {
  const bool has_joints = !options.joint_states.empty();
  const std::set<std::string> others =
      has_joints ? std::set<std::string>{options.joint_states}
                 : std::set<std::string>{options.tf_topic, options.tf_topic + "_static"};
  for (const std::string& topic : options.objects)
    if (others.count(topic))
      throw UsageError("--objects is " + topic + ", which has " +
                       (has_joints ? "positions of joints" : "transforms") +
                       "; name a topic of markers or boxes");
}

void check(const BagBoundsOptions& options) {
  if (options.merge) return checkMerge(options);
  if (options.each) checkEach(options);
  if (!options.each && !options.resume.empty()) throw UsageError("--resume needs --each");
  if (options.bags.empty()) throw UsageError("no bag is given");
  checkBagsOnce(options.bags);
  checkObjects(options);
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
  std::vector<Option> table = optionsInto(options);
  for (Option& option : table) {
    option.take = [&options, key = option.name, take = option.take](const auto& name,
                                                                    const auto& value) {
      take(name, value);
      options.given[key].push_back(value);
    };
  }
  const auto add_bag = [&](const std::string& argument) {
    options.bags.push_back(nonEmpty("the name of a bag", argument));
  };
  if (parseCommandLine(argc, argv, table, add_bag)) check(options);
  return options;
}

}  // namespace link_bounds
