// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// By getopt_long. The text after := must be a number to its last character.
#include "tools/urdf_bounds/urdf_bounds_options.h"

#include <getopt.h>

#include "tools/command_line/options.h"

namespace link_bounds {

const char* const kUsage =
    R"(usage: urdf_bounds FILE.urdf|- [joint:=value ...] [options]

Prints the exact axis-aligned bounding box of every link of a robot that has geometry, and of the
whole robot, in the frame of its root link. Needs no ROS master.

  FILE.urdf           the robot; relative mesh names start at its folder
  -                   read the robot from standard input; relative mesh names start here
  joint:=value        position of a movable joint [rad or m]; 0 if not given; joints that mimic
                      another one follow it
  --geometry G        visual (default), collision or both
  --representation R  min-max (default): smallest and largest corner
                      min-width: smallest corner and widths
                      center-radius: centre and half-extents
  --format F          table (default): rounded to micrometres
                      csv: link,a_x,a_y,a_z,b_x,b_y,b_z, groups last as group:NAME
                      json: always min-max; also says what is incomplete and why
  --volume V          instead of the box, for every link but not for the whole robot:
                      sphere: centre and radius of a bounding sphere
                      obb: centre, full widths and orientation (a quaternion) of a small box that
                      turns with the link
  --distances LIMIT   also how far links are apart: the pairs whose proven distance is at most
                      LIMIT [m], but none that are rigidly connected or neighbours by one joint;
                      csv: only these, as first,second,distance,distance_max,on_first_x, ...
  --verbose           the memory that each mesh takes, on standard error
  --strict            exit with 2 if any geometry could not be used
  -h, --help          this text
  --version           the version of link_bounds

Lengths are metres. Exit code: 0 all good, 1 unusable robot or arguments, 2 see --strict.
)";

namespace {

enum Code {
  kGeometry = 256,
  kRepresentation,
  kFormat,
  kVolume,
  kDistances,
  kVerbose,
  kStrict,
  kHelp,
  kVersion
};

constexpr option kLongOptions[] = {{"geometry", required_argument, nullptr, kGeometry},
                                   {"representation", required_argument, nullptr, kRepresentation},
                                   {"format", required_argument, nullptr, kFormat},
                                   {"volume", required_argument, nullptr, kVolume},
                                   {"distances", required_argument, nullptr, kDistances},
                                   {"verbose", no_argument, nullptr, kVerbose},
                                   {"strict", no_argument, nullptr, kStrict},
                                   {"help", no_argument, nullptr, kHelp},
                                   {"version", no_argument, nullptr, kVersion},
                                   {nullptr, 0, nullptr, 0}};

double jointValue(const std::string& joint, const std::string& text) {
  if (const std::optional<double> value = toNumber(text)) return *value;
  throw UsageError("the value of joint \"" + joint + "\" is \"" + text +
                   "\", but must be a number, such as 0.5");
}

/// An argument with := is a joint, another one the file.
void addArgument(const std::string& argument, UrdfBoundsOptions& options) {
  const std::size_t sign = argument.rfind(":=");
  if (sign != std::string::npos) {
    const std::string joint = argument.substr(0, sign);
    const double value = jointValue(joint, argument.substr(sign + 2));
    if (!options.joints.emplace(joint, value).second) {
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
      options.format = chosen<Format>(
          "--format", optarg,
          {{"table", Format::kTable}, {"csv", Format::kCsv}, {"json", Format::kJson}});
      return;
    case kVolume:
      options.volume = chosen<VolumeKind>(
          "--volume", optarg, {{"sphere", VolumeKind::kSphere}, {"obb", VolumeKind::kOrientedBox}});
      return;
    case kDistances:
      options.distances = limitOption("--distances", optarg);
      return;
    case kVerbose:
      options.verbose = true;
      return;
    case kStrict:
      options.strict = true;
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
