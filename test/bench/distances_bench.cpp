// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times distances of robots' links, ours and others: distances_bench [--quick] [--json FILE]
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <stdexcept>

#include "benchmark_main.h"
#include "distance_methods.h"
#include "machine.h"
#include "result.h"

namespace link_bounds::bench {
namespace {

constexpr double kLimit = 0.1;  // m

/// One method on one robot in one motion.
struct Row {
  std::string robot, motion, method, level;
  std::string which;         ///< "near": pairs within the limit by our proof; "all": every pair
  std::vector<double> ns;    ///< one for each pair and pose
  double us_per_update = 0;  ///< of all pairs of a pose, mean
};

/// Of this thread, so that what else the machine does counts less.
double microseconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

/// A peer that is not installed is not compiled.
std::vector<DistanceSetting> distanceSettings() {
  std::vector<DistanceSetting> settings;
  addOurDistances(settings);
#ifdef LINK_BOUNDS_WITH_FCL
  addFclDistances(settings);
#else
  std::cout << "left out, because this system lacks it: fcl\n";
#endif
#ifdef LINK_BOUNDS_WITH_BULLET
  addBulletDistances(settings);
#else
  std::cout << "left out, because this system lacks it: bullet\n";
#endif
  return settings;
}

/// The peers get the meshes in the frames of the links, where they are rounded to float.
constexpr double kFloat = 1e-6;  // m

/// Ours is the judge: it proves both bounds, which the distance of a peer must fit.
void check(const MeasuredDistance& ours, const MeasuredDistance& peer, const std::string& where) {
  if (peer.upper < ours.lower - kFloat || peer.lower > ours.upper + kAccuracy + kFloat)
    std::cout << "DISAGREES: " << where << ": " << peer.lower << " is not within " << ours.lower
              << " and " << ours.upper << "\n";
}

/// In "near" rows only pairs count that our method proves to be within the limit.
class Measurement {
 public:
  Measurement(const DistanceRobot& robot, const std::string& motion,
              const std::vector<DistanceSetting>& settings, bool is_near)
      : robot_(robot), is_near_(is_near) {
    const double limit = is_near ? kLimit : std::numeric_limits<double>::infinity();
    for (const DistanceSetting& setting : settings) {
      methods_.push_back(setting.make(robot, limit));
      rows_.push_back(
          {robot.name, motion, setting.method, setting.level, is_near ? "near" : "all", {}});
    }
    judge_ = distanceSettings().at(1).make(robot, limit);
  }

  std::vector<Row> run(const std::vector<LinkPoses>& motion) {
    for (const LinkPoses& poses : motion) {
      judge_->prepare(poses);
      for (const auto& method : methods_)
        method->prepare(poses);
      for (const auto& [first, second] : robot_.pairs)
        measure(first, second);
    }
    for (Row& row : rows_)
      row.us_per_update /= static_cast<double>(motion.size());
    return rows_;
  }

 private:
  void measure(std::size_t first, std::size_t second) {
    const MeasuredDistance proven = judge_->distance(first, second);
    const bool counts = !is_near_ || proven.lower < kLimit;
    for (std::size_t i = 0; i < methods_.size(); ++i) {
      if (!methods_[i]->has(first, second)) continue;
      if (!counts && rows_[i].method != "ours") continue;
      const double start = microseconds();
      const MeasuredDistance found = methods_[i]->distance(first, second);
      const double us = microseconds() - start;
      rows_[i].us_per_update += us;
      if (counts) rows_[i].ns.push_back(1e3 * us);
      if (counts && rows_[i].level == "mesh")
        check(proven, found, rows_[i].method + ", " + robot_.name);
    }
  }

  const DistanceRobot& robot_;
  bool is_near_;
  std::vector<std::unique_ptr<DistanceMethod>> methods_;
  std::unique_ptr<DistanceMethod> judge_;
  std::vector<Row> rows_;
};

double share(std::vector<double> values, double part) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void print(const Row& row, std::ostream& out) {
  out << std::left << std::setw(32) << row.robot << std::setw(10) << row.motion << std::setw(5)
      << row.which << std::setw(15) << row.method << std::setw(5) << row.level << std::right
      << std::fixed << std::setprecision(2) << std::setw(8) << row.ns.size() << " pairs, us: p50 "
      << std::setw(8) << median(row.ns) / 1e3 << "  p90 " << std::setw(8)
      << share(row.ns, 0.9) / 1e3 << "  an update " << std::setw(9) << row.us_per_update << "\n"
      << std::flush;
}

void writeJson(const std::vector<Row>& rows, std::ostream& out) {
  const char* separator = "[\n";
  for (const Row& row : rows) {
    if (row.ns.empty()) continue;
    out << separator << "{\"robot\": " << std::quoted(row.robot)
        << ", \"motion\": " << std::quoted(row.motion) << ", \"which\": " << std::quoted(row.which)
        << ", \"level\": " << std::quoted(row.level) << ", \"method\": " << std::quoted(row.method)
        << ", \"ns_per_pair\": " << std::to_string(median(row.ns))
        << ", \"us_per_update\": " << std::to_string(row.us_per_update)
        << ", \"pairs\": " << row.ns.size() << "}";
    separator = ",\n";
  }
  out << "\n]\n";
}

void benchmarkDistances(bool quick, std::ostream* json) {
  std::cout << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName()
            << "\npeers: " << LINK_BOUNDS_PEERS
            << "\nnear: pairs within 0.1 m; a clock read of about 0.2 us is in each time\n\n";
  const char* const folder = std::getenv("LINK_BOUNDS_DATA");
  const std::vector<DistanceSetting> settings = distanceSettings();
  std::vector<Row> rows;
  for (const DistanceRobot& robot :
       distanceRobots(folder ? folder : "", LINK_BOUNDS_DEMO_URDF, quick ? 5 : 50, std::cout)) {
    for (const auto& [name, motion] : robot.motions) {
      for (const bool is_near : {true, false}) {
        for (const Row& row : Measurement(robot, name, settings, is_near).run(motion)) {
          if (!row.ns.empty()) print(row, std::cout);
          rows.push_back(row);
        }
      }
    }
  }
  if (json) writeJson(rows, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkDistances);
}
