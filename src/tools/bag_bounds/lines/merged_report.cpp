// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The report of --merge: bags by name, then the totals and the nearest pair of all bags.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tools/bag_bounds/lines/bag_line.h"
#include "tools/bag_bounds/lines/each_bag.h"
#include "tools/bag_bounds/scene/record_time.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"
#include "tools/formats/safe_text.h"
#include "tools/formats/table_text.h"

namespace link_bounds {
namespace {

using Lines = std::map<std::string, ReadLine>;

/// The better of two lines of one bag. A line gives way if its machine could not open the bag,
/// died, or had only an unusable begin of it. Throws UsageError if both have a verdict and differ.
ReadLine betterOf(const ReadLine& first, const ReadLine& second) {
  const auto was_read = [&](const ReadLine& line) {
    const ReadLine& other = &line == &first ? second : first;
    const bool is_unusable = line.verdict == verdictOf(kUnusable);
    return line.bag.size && !line.hasDied() && !(is_unusable && isBeginOf(line.bag, other.bag));
  };
  if (was_read(first) != was_read(second)) return was_read(first) ? first : second;
  if (first.text == second.text) return first;
  if (!was_read(first))
    return std::min(first, second, [](const auto& a, const auto& b) { return a.text < b.text; });
  throw UsageError("the lines of bag " + first.bag.name + " in " + first.file + " and " +
                   second.file + " differ; leave the older file out");
}

void checkQuestion(const ReadLine& known, const ReadLine& other) {
  if (known.question == other.question) return;
  throw UsageError("the lines of " + known.file + " and " + other.file +
                   " are of different robots, options or versions; merge each kind alone");
}

/// The sum of a zone over all bags. Zones are in the order of the zone file, as in the lines.
struct ZoneSum {
  std::string name;
  std::uint64_t entries = 0;
  std::size_t bags = 0;  ///< in which it was entered
};

bool isNearer(const PairOfLine& a, const PairOfLine& b) {
  return std::make_pair(a.clearance, a.distance) < std::make_pair(b.clearance, b.distance);
}

class MergedReport {
 public:
  explicit MergedReport(const std::vector<std::string>& files) {
    std::vector<LineFile> read;
    for (const std::string& name : files)
      read.push_back(readLines(name));
    cut_ = placesOfCut(read);
    for (const LineFile& file : read)
      if (!file.two_bags.empty()) throw UsageError(file.two_bags);
    for (const LineFile& file : read) {
      for (const auto& [bag, line] : file.lines) {
        if (!lines_.empty()) checkQuestion(lines_.begin()->second, line);
        const auto [known, is_new] = lines_.emplace(bag, line);
        if (!is_new) known->second = betterOf(known->second, line);
      }
    }
    if (lines_.empty()) throw UsageError("there is no line to merge in " + joined(files, ", "));
    for (const auto& [bag, line] : lines_)
      add(line);
  }

  int exitCode(const Demand& demand) const {
    if (!left_out_.empty()) say("note: " + left_out_);
    for (const std::string& place : cut_)
      warn(place + " was cut, and its bag has no whole line; --resume reads it again");
    if (demand.allow_incomplete) return complete_code_;
    const int code = cut_.empty() ? exit_code_ : worseCode(exit_code_, kOpen);
    if (code == kOpen)
      warn("not everything was answered: the lines say what; --allow-incomplete accepts that");
    if (code == kFinding && (!cut_.empty() || verdicts_.count(verdictOf(kOpen)) > 0))
      warn("not everything was answered: the lines say what");
    return code;
  }

  void writeTable(std::ostream& out) const {
    std::vector<Row> rows{
        {"bag", "verdict", "nearest pair", "distance", "at", "clearance", "coverage", "entries"}};
    for (const auto& [bag, line] : lines_) {
      const auto& worst = line.worst;
      rows.push_back({printable(bag), printable(line.verdict),
                      worst ? printable(worst->first + " - " + worst->second) : "-",
                      worst ? shortNumber(worst->distance) : "-",
                      worst ? shortTime(worst->time) : "-",
                      worst ? shortNumber(worst->clearance) : "-",
                      line.coverage ? shortNumber(line.coverage->second) : "-",
                      std::to_string(entriesOf(line))});
    }
    writeAligned(rows, out, 3);
    writeZones(out);
    out << '\n' << lines_.size() << (lines_.size() == 1 ? " bag:" : " bags:");
    for (const auto& [verdict, count] : verdicts_)
      out << (verdict == verdicts_.begin()->first ? " " : ", ") << count << ' '
          << printable(verdict);
    out << '\n';
    if (worst_)
      out << "nearest pair of all: " << printable(worst_->worst->first) << " - "
          << printable(worst_->worst->second) << ", " << shortNumber(worst_->worst->distance)
          << " m, in " << printable(worst_->bag.name) << " at " << shortTime(worst_->worst->time)
          << " s\n";
    for (const auto& [bag, line] : lines_) {
      if (line.reason.empty()) continue;
      const bool names_it = line.reason.compare(0, bag.size() + 1, bag + ":") == 0;
      out << printable(line.verdict + ": " + (names_it ? "" : bag + ": ") + line.reason) << '\n';
    }
  }

  void writeCsv(std::ostream& out) const {
    out << "bag,size,head,verdict,exit,first,second,distance,time,clearance,least_covered,coverage,"
           "entries,"
           "reason\n";
    for (const auto& [bag, line] : lines_) {
      out << csvField(bag) << ',' << (line.bag.size ? std::to_string(*line.bag.size) : "") << ','
          << csvField(line.bag.head) << ',' << csvField(line.verdict) << ',' << line.exit_code
          << ',';
      if (line.worst) {
        out << csvField(line.worst->first) << ',' << csvField(line.worst->second) << ','
            << exactNumber(line.worst->distance) << ',' << csvField(line.worst->time) << ','
            << exactNumber(line.worst->clearance) << ',';
      } else {
        out << ",,,,,";
      }
      if (line.coverage) {
        out << csvField(line.coverage->first) << ',' << exactNumber(line.coverage->second) << ',';
      } else {
        out << ",,";
      }
      out << entriesOf(line) << ',' << csvField(line.reason) << '\n';
    }
  }

  /// Lines are repeated as they are.
  void writeJson(std::ostream& out) const {
    const auto verdict = [](const auto& entry) {
      return jsonString(entry.first) + ": " + std::to_string(entry.second);
    };
    const auto zone = [](const ZoneSum& sum) {
      return "{\"name\": " + jsonString(sum.name) +
             ", \"entries\": " + std::to_string(sum.entries) +
             ", \"bags\": " + std::to_string(sum.bags) + "}";
    };
    out << "{\"count\": " << lines_.size() << ",\n \"verdicts\": {"
        << joined(verdicts_, ", ", verdict) << "},\n \"worst\": " << worstJson()
        << ",\n \"zones\": [" << joined(zones_, ", ", zone) << "],\n \"bags\": "
        << jsonList(lines_, [](const auto& entry) { return entry.second.text; }) << "}\n";
  }

 private:
  void add(const ReadLine& line) {
    ++verdicts_[line.verdict];
    exit_code_ = worseCode(exit_code_, line.exit_code);
    complete_code_ = worseCode(complete_code_, line.complete_code);
    if (left_out_.empty()) left_out_ = line.left_out;
    if (line.worst && (!worst_ || isNearer(*line.worst, *worst_->worst))) worst_ = &line;
    for (const ZoneOfLine& zone : line.zones) {
      auto sum = std::find_if(zones_.begin(), zones_.end(),
                              [&](const ZoneSum& known) { return known.name == zone.name; });
      if (sum == zones_.end()) sum = zones_.insert(zones_.end(), {zone.name});
      sum->entries += zone.entries;
      sum->bags += zone.entries > 0 ? 1 : 0;
    }
  }

  static std::uint64_t entriesOf(const ReadLine& line) {
    std::uint64_t entries = 0;
    for (const ZoneOfLine& zone : line.zones)
      entries += zone.entries;
    return entries;
  }

  static std::string shortTime(const std::string& time) {
    return shortSeconds(std::llround(toNumber(time).value_or(0) * 1e9), 0);
  }

  void writeZones(std::ostream& out) const {
    if (zones_.empty()) return;
    std::vector<Row> rows{{"zone", "entries", "in bags"}};
    for (const ZoneSum& zone : zones_)
      rows.push_back(
          {printable(zone.name), std::to_string(zone.entries), std::to_string(zone.bags)});
    out << '\n';
    writeAligned(rows, out);
  }

  std::string worstJson() const {
    if (!worst_) return "null";
    const PairOfLine& pair = *worst_->worst;
    return "{\"bag\": " + jsonString(worst_->bag.name) + ", \"first\": " + jsonString(pair.first) +
           ", \"second\": " + jsonString(pair.second) +
           ", \"clearance\": " + exactNumber(pair.clearance) +
           ", \"distance\": " + exactNumber(pair.distance) + ", \"time\": " + pair.time + "}";
  }

  Lines lines_;
  std::vector<std::string> cut_;
  std::map<std::string, std::size_t> verdicts_;
  std::vector<ZoneSum> zones_;
  const ReadLine* worst_ = nullptr;  ///< of several, the first by name of bag
  std::string left_out_;             ///< the same in all lines, as the robot is the same
  int exit_code_ = 0;
  int complete_code_ = 0;  ///< with --allow-incomplete
};

}  // namespace

int writeMerged(const BagBoundsOptions& options, std::ostream& out) {
  const MergedReport report(options.bags);
  const auto write = writerFor(options.format, &MergedReport::writeTable, &MergedReport::writeCsv,
                               &MergedReport::writeJson);
  (report.*write)(out);
  return report.exitCode(options.demand);
}

}  // namespace link_bounds
