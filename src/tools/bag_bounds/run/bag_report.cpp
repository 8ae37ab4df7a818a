// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All formats have the same numbers; a table rounds them.
#include "tools/bag_bounds/run/bag_report.h"

#include <array>
#include <map>

#include "tools/bag_bounds/scene/record_time.h"
#include "tools/command_line/outcome.h"
#include "tools/formats/table_text.h"

namespace link_bounds {
namespace {

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

/// Writes one report as a table or CSV. Times count from the first message.
class Writer {
 public:
  Writer(const BagReport& report, std::ostream& out) : report_(report), out_(out) {}

  void writeTable() const {
    out_ << "frame: " << printable(report_.frame) << "    unit: m    times: s after "
         << exactSeconds(report_.begin) << ", from " << shortTime(report_.from) << " to "
         << shortTime(report_.to) << "\n\n";
    writeExtremes();
    writeSpeeds();
    writeBoxes();
    if (!report_.zones.empty()) writeZones();
    if (report_.distances) writeDistances();
    writeCoverage();
    writeIncomplete(incompleteOf(report_), out_);
    for (const std::string& loss : report_.losses)
      out_ << "partial: " << printable(loss) << '\n';
  }

  void writeCsv() const {
    out_ << "kind,name,other,value,time,stamp\n";
    for (const BoxRecord& box : report_.boxes) {
      for (std::size_t k = 0; box.has_box && k < 3; ++k) {
        writeRow(std::string("min_") + kAxes[k], box.name, "", box.min[k].value, box.min[k].when);
        writeRow(std::string("max_") + kAxes[k], box.name, "", box.max[k].value, box.max[k].when);
      }
    }
    for (const BoxRecord& box : report_.boxes) {
      if (box.speed) writeRow("max_speed", box.name, "", box.speed->value, box.speed->when);
    }
    for (const BoxAt& found : report_.boxes_at) {
      for (int k = 0; found.box && k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        const RecordTime at{*report_.at, found.stamp};
        writeRow(std::string("at_min_") + kAxes[axis], found.name, "", found.box->min()[k], at);
        writeRow(std::string("at_max_") + kAxes[axis], found.name, "", found.box->max()[k], at);
      }
    }
    for (const ZoneRecord& zone : report_.zones) {
      if (zone.nearest) {
        writeRow("zone_nearest", zone.nearest->name, zone.zone.name, zone.nearest->distance,
                 zone.nearest->when);
        out_ << "zone_clearance,," << csvField(zone.zone.name) << ',' << exactNumber(zone.clearance)
             << ",,\n";
      }
      for (const Stay& stay : zone.stays) {
        writeRow("zone_entered", stay.name, zone.zone.name, std::nullopt, stay.entered);
        writeRow(std::string("zone_") + toText(stay.end), stay.name, zone.zone.name, std::nullopt,
                 stay.left);
      }
    }
    for (const BoxRecord& box : report_.boxes) {
      if (box.coverage)
        out_ << "coverage," << csvField(box.name) << ",," << exactNumber(*box.coverage) << ",,\n";
    }
    for (const auto& [name, reason] : incompleteOf(report_))
      out_ << "incomplete," << csvField(name) << ',' << csvField(reason) << ",,,\n";
    for (const std::string& loss : report_.losses)
      out_ << "partial," << csvField(loss) << ",,,,\n";
    if (!report_.distances) return;
    for (const NearestPair& pair : *report_.distances) {
      writeRow("distance", pair.distance.first, pair.distance.second, pair.distance.distance,
               pair.when);
      out_ << "clearance," << csvField(pair.distance.first) << ',' << csvField(pair.distance.second)
           << ',' << exactNumber(pair.clearance) << ",,\n";
    }
  }

 private:
  std::string time(std::int64_t recorded) const { return exactSeconds(recorded - report_.begin); }
  std::string shortTime(std::int64_t recorded) const {
    return shortSeconds(recorded, report_.begin);
  }

  void writeExtremes() const {
    std::vector<Row> rows{{"name", "axis", "min", "at", "max", "at"}};
    for (const BoxRecord& box : report_.boxes) {
      for (std::size_t k = 0; box.has_box && k < 3; ++k) {
        const Row numbers = shortRow("", {box.min[k].value, box.max[k].value});
        rows.push_back({k == 0 ? printable(box.name) : "", kAxes[k], numbers[1],
                        shortTime(box.min[k].when.recorded), numbers[2],
                        shortTime(box.max[k].when.recorded)});
      }
    }
    writeAligned(rows, out_, 2);
    if (rows.size() == 1) out_ << "(no link ever had a box)\n";
  }

  /// Leaves out boxes that never moved.
  void writeSpeeds() const {
    std::vector<Row> rows{{"name", "max speed [m/s]", "at"}};
    for (const BoxRecord& box : report_.boxes) {
      if (box.speed && box.speed->value > 0)
        rows.push_back({printable(box.name), shortNumber(box.speed->value),
                        shortTime(box.speed->when.recorded)});
    }
    if (rows.size() == 1) return;
    out_ << '\n';
    writeAligned(rows, out_);
  }

  void writeBoxes() const {
    if (!report_.at) return;
    std::vector<Row> rows{{"box at " + exactSeconds(*report_.at - report_.begin), "min x", "min y",
                           "min z", "max x", "max y", "max z"}};
    for (const BoxAt& found : report_.boxes_at) {
      if (!found.box) continue;
      rows.push_back(shortRow(printable(found.name), numbersOf(*found.box)));
    }
    out_ << '\n';
    writeAligned(rows, out_);
  }

  void writeZones() const {
    std::vector<Row> nearest{{"zone", "nearest", "distance", "at", "clearance", "entries"}};
    std::vector<Row> stays{{"zone", "entered by", "from", "to", "end"}};
    for (const ZoneRecord& record : report_.zones) {
      const std::string zone = printable(record.zone.name);
      const std::string entries = std::to_string(record.entries);
      if (record.nearest) {
        nearest.push_back(
            {zone, printable(record.nearest->name), shortNumber(record.nearest->distance),
             shortTime(record.nearest->when.recorded), shortNumber(record.clearance), entries});
      } else {
        nearest.push_back({zone, "-", "-", "-", "-", entries});
      }
      for (const Stay& stay : record.stays) {
        stays.push_back({zone, printable(stay.name), shortTime(stay.entered.recorded),
                         shortTime(stay.left.recorded), toText(stay.end)});
      }
      if (record.entries > record.stays.size())
        stays.push_back({zone,
                         "(" + std::to_string(record.entries - record.stays.size()) + " more)", "",
                         "", ""});
    }
    out_ << '\n';
    writeAligned(nearest, out_, 2);
    if (stays.size() == 1) return;
    out_ << '\n';
    writeAligned(stays, out_, 2);
  }

  void writeDistances() const {
    out_ << '\n';
    if (report_.distances->empty()) {
      if (report_.has_compared) {
        out_ << "(no pair was ever within " << shortNumber(report_.distance_limit) << " m)\n";
      } else {
        out_ << "(" << kNothingCompared << ")\n";
      }
      return;
    }
    std::vector<Row> rows{
        {"first", "second", "distance", "distance max", "at", "clearance", "level"}};
    for (const NearestPair& pair : *report_.distances) {
      Row row = shortRow(printable(pair.distance.first),
                         {pair.distance.distance, pair.distance.distance_max});
      row.insert(row.begin() + 1, printable(pair.distance.second));
      row.push_back(shortTime(pair.when.recorded));
      row.push_back(shortNumber(pair.clearance));
      row.emplace_back(toText(static_cast<DistanceLevel>(pair.distance.level)));
      rows.push_back(std::move(row));
    }
    writeAligned(rows, out_, 2);
  }

  /// Leaves out links and objects that were covered all the time.
  void writeCoverage() const {
    std::vector<Row> rows{{"name", "coverage"}};
    for (const BoxRecord& box : report_.boxes) {
      if (box.coverage && *box.coverage < 1)
        rows.push_back({printable(box.name), shortNumber(*box.coverage)});
    }
    if (rows.size() == 1) return;
    out_ << '\n';
    writeAligned(rows, out_);
  }

  void writeRow(const std::string& kind, const std::string& name, const std::string& other,
                std::optional<double> value, const RecordTime& when) const {
    out_ << kind << ',' << csvField(name) << ',' << csvField(other) << ','
         << (value ? exactNumber(*value) : "") << ',' << time(when.recorded) << ','
         << stampSeconds(when.stamp) << '\n';
  }

  const BagReport& report_;
  std::ostream& out_;
};

/// Why a box was missing for too long; "" if it was not. The box of an object must never be
/// missing.
std::string lossOf(const BoxRecord& box, const BagReport& report) {
  const bool is_short = box.coverage && *box.coverage < report.min_coverage;
  const bool is_late = box.delay > kRemembered;
  const bool counts = box.is_object || box.is_lost || is_short || is_late;
  if (!box.has_box || !counts) return "";
  std::string share;
  if (is_short) {
    share = "had a box in " + shortNumber(*box.coverage) + " of its time, less than " +
            shortNumber(report.min_coverage) + " of --min-coverage";
  } else if (is_late) {
    share =
        "had its first box " + shortSeconds(box.delay, 0) +
        " s after its transforms began, of which tf remembers ten seconds, as where a static one "
        "came late: how it moved before is not known";
  }
  if (box.gaps == 0)
    return share.empty() || box.reason.empty() ? share : share + ": " + withRemedy(box);
  return (share.empty() ? share : share + "; ") + "had no box " + std::to_string(box.gaps) +
         (box.gaps == 1 ? " time, " : " times, ") + shortSeconds(box.gaps_length, 0) +
         " s in all, first at " + shortSeconds(box.first_gap, report.begin) + " s: " + box.reason;
}

std::string lossOf(const ZoneRecord& record, const BagReport& report) {
  const bool is_short = record.coverage < report.min_coverage;
  if (!is_short && !record.is_lost && !record.is_late) return "";
  std::string fault = ", but not at the end, or where the clock jumped back";
  if (is_short) {
    fault = ", less than " + shortNumber(report.min_coverage) + " of --min-coverage";
  } else if (record.is_late) {
    fault = ", but first when tf had forgotten how they moved before";
  }
  return "compared in " + shortNumber(record.coverage) + " of the time in which links had boxes" +
         fault + ": tf did not connect its frame \"" + record.zone.frame +
         "\" with all of them; record what connects it";
}

}  // namespace

std::string withRemedy(const BoxRecord& box) {
  return box.reason + (box.remedy.empty() ? "" : "; " + box.remedy);
}

/// Lists each name once, with all reasons why it is incomplete.
Reasons incompleteOf(const BagReport& report) {
  Reasons reasons;
  std::map<std::string, std::size_t> places;
  const auto add = [&](const std::string& name, const std::string& reason) {
    if (reason.empty()) return;
    const auto [place, is_new] = places.emplace(name, reasons.size());
    if (is_new) {
      reasons.emplace_back(name, reason);
    } else {
      reasons[place->second].second += "; " + reason;
    }
  };
  for (const BoxRecord& box : report.boxes) {
    if (!box.has_box) {
      if (!box.reason.empty()) add(box.name, "never had a box: " + withRemedy(box));
      continue;
    }
    add(box.name, box.partial);
    add(box.name, lossOf(box, report));
  }
  for (const BoxAt& found : report.boxes_at)
    add(found.name, found.problem);
  for (const ZoneRecord& record : report.zones)
    add("zone " + record.zone.name, lossOf(record, report));
  return reasons;
}

void write(const BagReport& report, Format format, std::ostream& out) {
  const Writer writer(report, out);
  switch (format) {
    case Format::kTable:
      return writer.writeTable();
    case Format::kCsv:
      return writer.writeCsv();
    case Format::kJson:
      return writeJson(report, out);
  }
}

}  // namespace link_bounds
