// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of parameters: name, meaning and rule. The reader and --help use it; a test compares
// README's table with --help.
#pragma once

#include <limits>
#include <string>

#include "link_bounds/robot/urdf/overlap_filter.h"
#include "world/model/parameters.h"

namespace link_bounds {

namespace rules {

/// A rule returns an error such as "must be > 0", or "" if the value is valid.
template <class T>
std::string any(const T&) {
  return "";
}

/// Numbers from `min` to `max`, so not NaN; else `error`.
constexpr auto within(double min, double max, const char* error) {
  return [=](double value) { return value >= min && value <= max ? "" : std::string(error); };
}

constexpr double kMost = std::numeric_limits<double>::max();
constexpr double kAboveZero = std::numeric_limits<double>::denorm_min();

/// Longer lengths are mistakes, such as micrometres for metres. Sums of lengths up to this one stay
/// finite and exact to a nanometre.
constexpr double kMaxLength = 1e6;  // m

inline constexpr auto notNegative = within(0, kMost, "must be a finite number >= 0");
inline constexpr auto positive = within(kAboveZero, kMost, "must be a finite number > 0");
inline constexpr auto length = within(0, kMaxLength, "must be a number of metres from 0 to 1e6");
inline constexpr auto positiveLength =
    within(kAboveZero, kMaxLength, "must be a number of metres > 0, at most 1e6");
inline constexpr auto share = within(0, 0.5, "must be a number from 0 to 0.5");
inline constexpr auto notNegativeInt = within(0, kMost, "must be a whole number >= 0");
inline constexpr auto positiveInt = within(1, kMost, "must be a whole number > 0");
inline constexpr auto partCount = within(1, 256, "must be a whole number from 1 to 256");

/// One of the words; else `error`.
template <class... Words>
constexpr auto oneOf(const char* error, Words... words) {
  return
      [=](const std::string& value) { return ((value == words) || ...) ? "" : std::string(error); };
}

inline constexpr auto geometry =
    oneOf("must be visual, collision or both", "visual", "collision", "both");
inline constexpr auto markerStyle = oneOf("must be edges, faces or both", "edges", "faces", "both");
inline constexpr auto duringReaction = oneOf("must be measured or limit", "measured", "limit");

inline std::string color(const std::array<double, 4>& rgba) {
  for (const double part : rgba) {
    if (!(part >= 0 && part <= 1))
      return "must be four numbers from 0 to 1: red, green, blue, alpha";
  }
  return "";
}

inline std::string linkPadding(const std::map<std::string, double>& value) {
  for (const auto& [link, padding] : value) {
    if (!length(padding).empty())
      return "must be numbers of metres from 0 to 1e6; see link \"" + link + "\"";
  }
  return "";
}

inline std::string accelerations(const std::map<std::string, double>& value) {
  for (const auto& [joint, acceleration] : value) {
    if (!positive(acceleration).empty())
      return "must be finite numbers > 0; see joint \"" + joint + "\"";
  }
  return "";
}

inline std::string baseDeceleration(const std::map<std::string, double>& value) {
  for (const auto& [name, deceleration] : value) {
    const bool is_known = name == "linear" || name == "angular";
    if (!is_known || !positive(deceleration).empty())
      return "must have linear and angular, finite numbers > 0; see \"" + name + "\"";
  }
  return "";
}

inline std::string groups(const std::map<std::string, std::vector<std::string>>& value) {
  return value.count(kRobotGroup) ? "must not define \"robot\", which is always all links" : "";
}

inline std::string ignorePairs(const std::vector<std::string>& value) {
  const auto is_name = [](const std::string&) { return true; };
  for (const std::string& entry : value) {
    if (namePairs(entry, is_name).empty())
      return "must be pairs of names with a space between them; see \"" + entry + "\"";
  }
  return "";
}

inline std::string attached(const std::map<std::string, std::vector<std::string>>& value) {
  for (const auto& [link, objects] : value) {
    for (const std::string& object : objects) {
      if (object.find('/') == std::string::npos)
        return "must name objects NS/ID or NS/*; see \"" + object + "\" of link \"" + link + "\"";
    }
  }
  return "";
}

}  // namespace rules

/// Visits the parameters that choose and pad links. `padding` is the help text of parameter
/// padding.
template <class AnyParameters, class Visitor>
void visitLinkParameters(AnyParameters& p, Visitor&& visit, const char* padding) {
  visit("geometry", p.geometry, rules::geometry, "visual, collision or both");
  visit("links", p.links, rules::any<std::vector<std::string>>,
        "only these links; [] = every link with geometry");
  visit("ignore_links", p.ignore_links, rules::any<std::vector<std::string>>,
        "none of these links");
  visit("padding", p.padding, rules::length, padding);
  visit("link_padding", p.link_padding, rules::linkPadding, "replaces padding for that link");
}

/// Calls visit(name, value, rule, meaning) for each private parameter.
template <class AnyParameters, class Visitor>
void visitParameters(AnyParameters& p, Visitor&& visit) {
  visit("fixed_frame", p.fixed_frame, rules::any<std::string>,
        "frame of the boxes; \"\" = the URDF's root link");
  visitLinkParameters(p, visit,
                      "metres, 0 to 1e6, added on every side of link boxes and their parts (groups "
                      "and markers follow)");
  visit("groups", p.groups, rules::groups,
        "further group boxes; members are links, objects NS/ID, or NS/*: all objects of a "
        "namespace");
  visit("max_rate", p.max_rate, rules::notNegative, "Hz; 0 = every update");
  visit(
      "timeout", p.timeout, rules::notNegative,
      "ROS seconds without a newer stamp of a frame on its path until a link is stale: no box, in "
      "incomplete. 0 = never");
  visit("tf_prefix", p.tf_prefix, rules::any<std::string>,
        "goes before link names in tf; if not set here, it is found upwards as "
        "robot_state_publisher finds it");
  visit("marker_rate", p.marker_rate, rules::positive, "Hz, > 0");
  visit("marker_style", p.marker_style, rules::markerStyle, "edges, faces or both");
  visit("marker_color", p.marker_color, rules::color, "rgba of faces; edges opaque");
  visit("marker_labels", p.marker_labels, rules::any<bool>, "names as text");
  visit("overlap_margin", p.overlap_margin, rules::length,
        "metres, 0 to 1e6; pairs of boxes with distance <= it are in ~overlaps");
  visit("ignore_pairs", p.ignore_pairs, rules::ignorePairs,
        "\"a b\": links or objects NS/ID that are never a pair, in any topic or answer; * in a "
        "name is any text without a slash, as in NS/*: all objects of a namespace");
  visit(
      "attached", p.attached, rules::attached,
      "objects NS/ID or NS/* that are part of that link's rigid body, as a tool would be, in every "
      "pair, in any topic or answer");
  visit("adjacent_joints", p.adjacent_joints, rules::notNegativeInt,
        "links with this many movable joints between them, or fewer, are never a pair, in "
        "any topic or answer; >= 0");
  visit("max_pairs", p.max_pairs, rules::positiveInt,
        "pairs, > 0, in one message of ~distances: the nearest ones; bodies whose further "
        "pairs do not fit are in incomplete, and /diagnostics counts those pairs");
  visit("distance_limit", p.distance_limit, rules::length,
        "metres, 0 to 1e6; pairs of bodies with distance <= it are in ~distances");
  visit("distance_accuracy", p.distance_accuracy, rules::positiveLength,
        "metres, > 0, at most 1e6; distances are refined until distance_max - distance <= it");
  visit("distance_relative_accuracy", p.distance_relative_accuracy, rules::share,
        "0 to 0.5; or until distance_max - distance <= that part of distance_max, which is faster");
  visit("distance_warning", p.distance_warning, rules::length,
        "metres, 0 to 1e6; /diagnostics warns while ~nearest is at or below it; 0 = never");
  visit("swept_span", p.swept_span, rules::notNegative,
        "seconds, >= 0, of motion that the boxes of ~swept cover, less than 10, which tf "
        "remembers; 0 = none are sent");
  visit(
      "deceleration", p.deceleration, rules::accelerations,
      "rad/s^2 or m/s^2, > 0, with which each joint brakes at least; without it, the links beyond "
      "the joint are incomplete on ~stopping");
  visit(
      "base_deceleration", p.base_deceleration, rules::baseDeceleration,
      "linear (m/s^2) and angular (rad/s^2), > 0: the same of the root in the fixed frame, and of "
      "floating and planar joints");
  visit("acceleration", p.acceleration, rules::accelerations,
        "rad/s^2 or m/s^2, > 0, with which a joint speeds up at most; without it, in no time");
  visit("reaction_time", p.reaction_time, rules::notNegative,
        "seconds, >= 0, from the stamp of a transform until all joints brake");
  visit("during_reaction", p.during_reaction, rules::duringReaction,
        "until they brake, joints keep their measured speed, or may reach the limit of the URDF");
  visit("velocity_window", p.velocity_window, rules::positive,
        "seconds, > 0, of transforms from which speeds come; no two in a row may be farther apart");
  visit("joint_states", p.joint_states, rules::any<bool>,
        "speeds of the joints that the topic joint_states has come from there, others from tf");
  visit("parts_per_link", p.parts_per_link, rules::partCount,
        "max number of boxes per link on ~parts, 1 to 256");
  visit("mesh_timeout", p.mesh_timeout, rules::positive, "wall seconds for one mesh file, > 0");
  visit("max_mesh_bytes", p.max_mesh_bytes, rules::positiveInt,
        "bytes of one mesh file, 1 to 2147483647");
}

}  // namespace link_bounds
