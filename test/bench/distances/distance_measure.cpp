// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times are of this thread, so that what else the machine does counts less. What a clock read takes
// is subtracted. The first pose of a motion is not counted.
#include "bench/distances/distance_measure.h"

#include <algorithm>
#include <iostream>
#include <limits>

#include "bench/common/timing.h"

namespace link_bounds::bench {
namespace {

constexpr double kLimit = 0.1;       // m
constexpr double kBaseStep = 0.005;  // m per update
constexpr double kBaseTurn = 0.01;   // rad per update
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// The peers get the meshes in the frames of the links, where they are rounded to float.
constexpr double kFloat = 1e-6;  // m

/// What reading the clock takes [ns].
double clockRead() {
  std::vector<double> times;
  for (int i = 0; i < 1000; ++i) {
    const double start = threadSeconds();
    times.push_back((threadSeconds() - start) * 1e9);
  }
  return median(times);
}

template <class Run>
double timeOf(const Run& run) {
  static const double kClockRead = clockRead();
  const double start = threadSeconds();
  run();
  return std::max(0.0, (threadSeconds() - start) * 1e9 - kClockRead);
}

void check(const MeasuredDistance& ours, const MeasuredDistance& peer, const std::string& where) {
  if (peer.upper < ours.lower - kFloat || peer.lower > ours.upper + kAccuracy + kFloat)
    std::cout << "DISAGREES: " << where << ": " << peer.lower << " is not within " << ours.lower
              << " and " << ours.upper << "\n";
}

/// A pair in a pose of a motion.
struct Case {
  std::size_t pose, first, second;
  MeasuredDistance proven;                        ///< at the mesh level
  std::map<std::string, double> ns_of_ours = {};  ///< by level
};

/// One method after the other goes through a motion, so that none finds the caches full of what
/// another one has read.
class Measurement {
 public:
  Measurement(const DistanceRobot& robot, const std::vector<DistanceSetting>& settings)
      : robot_(robot), settings_(settings) {
    for (const DistanceSetting& setting : settings) {
      if (setting.method != "ours") peers_[setting.method] = setting.make(robot, kUnlimited);
    }
  }

  DistanceRows run() {
    DistanceRows result;
    for (const bool is_near : {true, false}) {
      for (const auto& [name, motion] : robot_.motions) {
        std::vector<Case> cases = casesOf(motion, is_near);
        for (const DistanceSetting& setting : settings_) {
          DistanceRow row{
              robot_.name, name, setting.method, setting.level, is_near ? "near" : "all", 0};
          if (setting.method == "ours") {
            measureOurs(setting, motion, is_near, cases, row);
          } else {
            measurePeer(setting, motion, cases, row);
          }
          row.pairs = row.ns.size();
          if (row.pairs > 0) result.push_back(std::move(row));
        }
      }
    }
    return result;
  }

 private:
  /// The judge decides what is near.
  std::vector<Case> casesOf(const std::vector<LinkPoses>& motion, bool is_near) const {
    std::vector<DistanceSetting> ours;
    addOurDistances(ours);
    const auto judge = ours.at(1).make(robot_, is_near ? kLimit : kUnlimited);
    std::vector<Case> result;
    const std::size_t poses = std::min(robot_.poses_per_peer + 1, motion.size());
    for (std::size_t pose = 0; pose < poses; ++pose) {
      judge->prepare(motion[pose]);
      for (const auto& [first, second] : robot_.pairs) {
        const MeasuredDistance proven = judge->distance(first, second);
        if (pose > 0 && (!is_near || proven.lower < kLimit))
          result.push_back({pose, first, second, proven});
      }
    }
    return result;
  }

  void measureOurs(const DistanceSetting& setting, const std::vector<LinkPoses>& motion,
                   bool is_near, std::vector<Case>& cases, DistanceRow& row) const {
    const auto method = setting.make(robot_, is_near ? kLimit : kUnlimited);
    auto next = cases.begin();
    for (std::size_t pose = 0; next != cases.end(); ++pose) {
      method->prepare(motion[pose]);
      method->place();
      for (const auto& [first, second] : robot_.pairs) {
        const double ns = timeOf([&, i = first, j = second] { method->distance(i, j); });
        if (next == cases.end() || next->pose != pose || next->first != first ||
            next->second != second)
          continue;
        row.ns.push_back(ns);
        next->ns_of_ours[setting.level] = ns;
        ++next;
      }
    }
  }

  void measurePeer(const DistanceSetting& setting, const std::vector<LinkPoses>& motion,
                   const std::vector<Case>& cases, DistanceRow& row) {
    DistanceMethod& peer = *peers_[setting.method];
    std::size_t prepared = 0;
    for (const Case& pair : cases) {
      if (!peer.has(pair.first, pair.second)) continue;
      if (prepared != pair.pose) peer.prepare(motion[pair.pose]);
      prepared = pair.pose;
      MeasuredDistance found{};
      row.ns.push_back(timeOf([&] { found = peer.distance(pair.first, pair.second); }));
      row.ns_beside.push_back(pair.ns_of_ours.at(setting.level));
      if (setting.level == "mesh") check(pair.proven, found, setting.method + ", " + robot_.name);
    }
  }

  const DistanceRobot& robot_;
  const std::vector<DistanceSetting>& settings_;
  std::map<std::string, std::unique_ptr<DistanceMethod>> peers_;
};

/// Beside the motions of joints: all links together.
std::map<std::string, std::vector<LinkPoses>> updateMotions(const DistanceRobot& robot) {
  std::map<std::string, std::vector<LinkPoses>> result = robot.motions;
  const std::vector<LinkPoses>& coherent = robot.motions.at("coherent");
  std::vector<LinkPoses>& at_rest = result["at rest"];
  at_rest.assign(coherent.size(), coherent.front());
  std::vector<LinkPoses>& on_base = result["on a base"] = at_rest;
  Eigen::Affine3d base = Eigen::Affine3d::Identity();
  for (LinkPoses& poses : on_base) {
    base = base * Eigen::Translation3d(kBaseStep, 0, 0) *
           Eigen::AngleAxisd(kBaseTurn, Eigen::Vector3d::UnitZ());
    for (Eigen::Affine3d& pose : poses)
      pose = base * pose;
  }
  return result;
}

}  // namespace

DistanceRows measurePairs(const DistanceRobot& robot,
                          const std::vector<DistanceSetting>& settings) {
  return Measurement(robot, settings).run();
}

DistanceRows measureUpdates(const DistanceRobot& robot) {
  std::vector<DistanceSetting> settings;
  addOurDistances(settings);
  addRoughDistances(settings);
  DistanceRows result;
  for (const auto& [name, motion] : updateMotions(robot)) {
    for (const DistanceSetting& setting : settings) {
      const auto method = setting.make(robot, kLimit);
      DistanceRow row{robot.name, name, "ours", setting.level, "update", robot.pairs.size()};
      for (const LinkPoses& poses : motion) {
        row.ns.push_back(timeOf([&] {
          method->prepare(poses);
          for (const auto& [first, second] : robot.pairs)
            method->follow(first, second);
        }));
      }
      row.ns.erase(row.ns.begin());
      result.push_back(row);
    }
  }
  return result;
}

}  // namespace link_bounds::bench
