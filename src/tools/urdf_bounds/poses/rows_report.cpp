// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes and distances of many rows of joint values. Threads share the rows in blocks. Each
// thread sums up its rows, and the sums are merged into the summary, which does not depend on the
// sharing.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <limits>
#include <set>

#include "robot/posed/posed_robot.h"
#include "robot/threads/row_threads.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"
#include "tools/urdf_bounds/poses/distance_table.h"
#include "tools/urdf_bounds/poses/reports.h"
#include "tools/urdf_bounds/poses/rows_table.h"

namespace link_bounds {
namespace {

/// Number of rows between two progress reports, and between two writes to the file of --series.
constexpr std::size_t kBlock = 1024;

/// How near each pair was in the rows that one thread has seen.
class PairRecords {
 public:
  explicit PairRecords(double limit) : limit_(limit) {}

  void add(const LinkPairDistance& pair, std::size_t row) {
    const BodyDistance& distance = pair.distance;
    const bool is_contact = !(distance.lower > 0);
    merge({pair.first, pair.second}, {distance.lower, distance.upper, row, is_contact ? 1U : 0U});
  }

  void add(const PairRecords& other) {
    for (const auto& [pair, nearest] : other.pairs_)
      merge(pair, nearest);
  }

  /// The max distance of the two links that can still change the records [m].
  double needed(std::size_t first, std::size_t second) const {
    const auto found = pairs_.find({first, second});
    return found == pairs_.end() ? limit_ : found->second.distance;
  }

  const auto& pairs() const { return pairs_; }

 private:
  void merge(const std::pair<std::size_t, std::size_t>& pair, const NearestRow& nearest) {
    const auto [entry, is_new] = pairs_.emplace(pair, nearest);
    if (is_new) return;
    NearestRow& known = entry->second;
    const std::size_t contacts = known.contacts + nearest.contacts;
    if (std::make_pair(nearest.distance, nearest.row) < std::make_pair(known.distance, known.row))
      known = nearest;
    known.contacts = contacts;
  }

  double limit_;
  std::map<std::pair<std::size_t, std::size_t>, NearestRow> pairs_;
};

/// The state and the results of one thread.
struct RowWorker {
  PosedRobot posed;
  PairRecords records;
  std::vector<Aabb> boxes;
  std::vector<bool> has_box;  ///< by link: it had a box in all rows so far
  std::set<std::size_t> unmeasured;
  std::size_t with_contact = 0;
  std::size_t first = std::numeric_limits<std::size_t>::max();
  bool has_compared = false;
};

/// How many of the first `end` rows have a fault.
std::size_t faultyRows(const JointTable& table, std::size_t end) {
  const auto is_faulty = [](const std::string& fault) { return !fault.empty(); };
  const auto begin = table.faults.begin();
  return static_cast<std::size_t>(
      std::count_if(begin, begin + static_cast<std::ptrdiff_t>(end), is_faulty));
}

class RowsRun {
 public:
  RowsRun(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
          const JointTable& table, const JointValues& given)
      : options_(options), bounded_(bounded), table_(table), given_(given) {
    const std::size_t count = bounded.links.size();
    for (unsigned i = 0; i < jobs(); ++i) {
      workers_.push_back({PosedRobot(robot, bounded),
                          PairRecords(options.distances.value_or(0)),
                          std::vector<Aabb>(count),
                          std::vector<bool>(count, true),
                          {}});
    }
    if (options.series) openSeries(*options.series);
  }

  /// Returns the number of rows that were examined: fewer than all after Ctrl-C.
  std::size_t run() {
    const std::size_t rows = table_.rows();
    std::size_t done = 0;
    for (; done < rows && !isInterrupted(); done = std::min(done + kBlock, rows)) {
      if (hasTerminal()) drawBar(done, rows, "rows");
      const std::size_t end = std::min(done + kBlock, rows);
      texts_.assign(end - done, "");
      forRows(done, end, jobs(), kPosesAtOnce,
              [&](unsigned thread, std::size_t first, std::size_t last) {
                for (std::size_t row = first; row < last; ++row) {
                  if (table_.faults[row].empty()) add(workers_[thread], row, texts_[row - done]);
                }
              });
      for (const std::string& text : texts_)
        series_ << text;
    }
    if (hasTerminal()) eraseBar();
    if (options_.series && !series_.flush())
      throw UsageError("cannot write " + *options_.series + "; is the disk full?");
    return done;
  }

  /// The report of the first `done` rows.
  RowsTable result(const std::string& frame, std::size_t done) {
    RowsTable table;
    table.frame = frame;
    table.count = table_.rows();
    table.left_out = faultyRows(table_, done) + table_.rows() - done;
    table.times = table_.times;
    table.limit = options_.distances;
    RowWorker& all = workers_.front();
    for (auto worker = workers_.begin() + 1; worker != workers_.end(); ++worker)
      merge(*worker, all);
    table.boxes = all.boxes;
    table.with_contact = all.with_contact;
    if (all.with_contact > 0) table.first = all.first;
    table.pairs = all.records.pairs();
    std::optional<std::pair<double, std::size_t>> worst;
    for (const auto& entry : table.pairs) {
      const auto found = std::make_pair(entry.second.distance, entry.second.row);
      if (!worst || found < *worst) worst = found;
    }
    if (worst) table.worst = worst->second;
    for (std::size_t i = 0; i < bounded_.links.size(); ++i) {
      const BoundedLink& link = bounded_.links[i];
      table.links.push_back(link.name);
      if (!link.isWhole())
        table.incomplete.emplace_back(link.name, link.missing);
      else if (!all.has_box[i])
        table.incomplete.emplace_back(link.name, "its size and pose give no finite box in a row");
      else if (all.unmeasured.count(i))
        table.incomplete.emplace_back(link.name,
                                      "its size and pose give no finite distance in a row");
    }
    addIncompleteGroup(table.incomplete);
    return table;
  }

  bool hasCompared() const { return workers_.front().has_compared; }

 private:
  unsigned jobs() const {
    const std::size_t useful = (table_.rows() + kPosesAtOnce - 1) / kPosesAtOnce;
    return static_cast<unsigned>(
        std::min<std::size_t>(options_.jobs.value_or(coreCount()), useful));
  }

  void openSeries(const std::string& file) {
    series_.open(file);
    series_ << "row," << (table_.times.empty() ? "" : "time,");
    if (options_.distances) {
      writeCsvHead(series_);
    } else {
      series_ << "link,a_x,a_y,a_z,b_x,b_y,b_z\n";
    }
    if (!series_) throw UsageError("cannot write " + file + "; is its folder there?");
  }

  std::string beginOf(std::size_t row) const {
    return std::to_string(row + 1) + "," +
           (table_.times.empty() ? "" : exactNumber(table_.times[row]) + ",");
  }

  void add(RowWorker& worker, std::size_t row, std::string& text) {
    worker.posed.move(valuesOf(table_, row, given_));
    for (std::size_t i = 0; i < bounded_.links.size(); ++i) {
      const std::optional<Aabb>& box = worker.posed.box(i);
      if (box)
        worker.boxes[i].extend(*box);
      else
        worker.has_box[i] = false;
    }
    if (options_.distances) return addDistances(worker, row, text);
    if (options_.series) text = boxText(worker.posed, row);
  }

  /// Without a series, skips distances that are not smaller than in an earlier row.
  void addDistances(RowWorker& worker, std::size_t row, std::string& text) {
    PosedRobot::Wanted wanted;
    if (!options_.series) {
      wanted = [&](std::size_t first, std::size_t second) {
        return worker.records.needed(first, second);
      };
    }
    const PoseDistances found = worker.posed.distances(*options_.distances, wanted);
    worker.has_compared = worker.has_compared || worker.posed.hasPairs();
    worker.unmeasured.insert(found.unmeasured.begin(), found.unmeasured.end());
    bool has_contact = false;
    const std::string begin = options_.series ? beginOf(row) : "";
    for (const LinkPairDistance& pair : found.pairs) {
      worker.records.add(pair, row);
      has_contact = has_contact || !(pair.distance.lower > 0);
      if (options_.series) {
        text += begin + csvLine({bounded_.links[pair.first].name, bounded_.links[pair.second].name,
                                 pair.distance});
      }
    }
    if (!has_contact) return;
    ++worker.with_contact;
    worker.first = std::min(worker.first, row);
  }

  std::string boxText(const PosedRobot& posed, std::size_t row) const {
    std::string text;
    const auto add = [&](const std::string& name, const Aabb& box) {
      text += beginOf(row) + csvField(name);
      for (const Eigen::Vector3d& corner : {box.min(), box.max()}) {
        for (int axis = 0; axis < 3; ++axis)
          text += "," + exactNumber(corner[axis]);
      }
      text += "\n";
    };
    for (std::size_t i = 0; i < bounded_.links.size(); ++i) {
      if (posed.box(i)) add(bounded_.links[i].name, *posed.box(i));
    }
    if (!posed.robotBox().isEmpty()) add(std::string(kGroupPrefix) + "robot", posed.robotBox());
    return text;
  }

  static void merge(const RowWorker& from, RowWorker& to) {
    to.records.add(from.records);
    for (std::size_t i = 0; i < to.boxes.size(); ++i) {
      to.boxes[i].extend(from.boxes[i]);
      to.has_box[i] = to.has_box[i] && from.has_box[i];
    }
    to.unmeasured.insert(from.unmeasured.begin(), from.unmeasured.end());
    to.with_contact += from.with_contact;
    to.first = std::min(to.first, from.first);
    to.has_compared = to.has_compared || from.has_compared;
  }

  const UrdfBoundsOptions& options_;
  const BoundedRobot& bounded_;
  const JointTable& table_;
  const JointValues& given_;
  std::vector<RowWorker> workers_;
  std::vector<std::string> texts_;  ///< the lines of --series, for each row of a block
  std::ofstream series_;
};

}  // namespace

/// How many pairs of the summary have an inexact distance, see isRough().
static std::size_t roughPairs(const RowsTable& table) {
  return static_cast<std::size_t>(std::count_if(
      table.pairs.begin(), table.pairs.end(),
      [](const auto& entry) { return isRough(entry.second.distance, entry.second.distance_max); }));
}

Outcome writeRows(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const JointTable& table, const JointValues& given) {
  RowsRun run(options, robot, bounded, table, given);
  const std::size_t done = run.run();
  const RowsTable summary = run.result(robot.links[robot.root].name, done);
  write(summary, options.format, std::cout);
  Outcome outcome;
  outcome.has_finding = summary.with_contact > 0;
  outcome.lost_geometry = !summary.incomplete.empty();
  if (bounded.links.empty()) outcome.open.emplace_back("no link has a box");
  if (options.distances && !run.hasCompared())
    outcome.open.emplace_back("no two links were compared");
  outcome.addOpen("incomplete names", summary.incomplete.size());
  outcome.addOpen("distances less accurate than " + shortLength(DistanceGoal().accuracy),
                  roughPairs(summary));
  outcome.addOpen("rows that were left out", faultyRows(table, done));
  outcome.addOpen("rows after the interrupt", table.rows() - done);
  return outcome;
}

}  // namespace link_bounds
