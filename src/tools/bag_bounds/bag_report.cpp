// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times are printed from integers, so that no nanosecond is lost.
#include "tools/bag_bounds/bag_report.h"

#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>

#include "tools/text/safe_text.h"

namespace link_bounds {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // ns
constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
constexpr std::array<const char*, 3> kLevels{"BOX", "HULL", "MESH"};

/// Exact.
std::string seconds(std::int64_t nanoseconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%s%" PRId64 ".%09" PRId64, nanoseconds < 0 ? "-" : "",
                std::abs(nanoseconds / kSecond), std::abs(nanoseconds % kSecond));
  return text;
}

std::string quoted(const std::string& text) {
  return "\"" + text + "\"";
}

const char* toText(StayEnd end) {
  switch (end) {
    case StayEnd::kLeft:
      return "left";
    case StayEnd::kLost:
      return "lost";
    case StayEnd::kReportEnded:
      break;
  }
  return "report_ended";
}

/// The words of one report, whose times begin with the first message.
class Writer {
 public:
  Writer(const BagReport& report, std::ostream& out) : report_(report), out_(out) {}

  void writeTable() const {
    out_ << "frame: " << printable(report_.frame) << "    unit: m    times: s after "
         << seconds(report_.begin) << ", from " << shortTime(report_.from) << " to "
         << shortTime(report_.to) << "\n\n";
    writeExtremes();
    if (!report_.zones.empty()) writeZones();
    if (report_.distances) writeDistances();
    writeIncomplete(incompleteOf(report_), out_);
  }

  void writeCsv() const {
    out_ << "kind,name,other,value,time,stamp\n";
    for (const BoxRecord& box : report_.boxes) {
      for (std::size_t k = 0; box.has_box && k < 3; ++k) {
        writeRow(std::string("min_") + kAxes[k], box.name, "", box.min[k].value, box.min[k].when);
        writeRow(std::string("max_") + kAxes[k], box.name, "", box.max[k].value, box.max[k].when);
      }
    }
    for (const ZoneRecord& zone : report_.zones) {
      if (zone.nearest)
        writeRow("zone_nearest", zone.nearest->name, zone.zone.name, zone.nearest->distance,
                 zone.nearest->when);
      for (const Stay& stay : zone.stays) {
        writeRow("zone_entered", stay.name, zone.zone.name, std::nullopt, stay.entered);
        writeRow(std::string("zone_") + toText(stay.end), stay.name, zone.zone.name, std::nullopt,
                 stay.left);
      }
    }
    if (!report_.distances) return;
    for (const NearestPair& pair : *report_.distances)
      writeRow("distance", pair.distance.first, pair.distance.second, pair.distance.distance,
               pair.when);
  }

  void writeJson() const {
    out_ << "{\"frame\": " << jsonString(report_.frame)
         << ",\n \"begin\": " << seconds(report_.begin) << ",\n \"from\": " << time(report_.from)
         << ",\n \"to\": " << time(report_.to) << ",\n \"messages\": " << report_.messages
         << ",\n \"extremes\": "
         << jsonList(report_.boxes, [this](const auto& box) { return toJson(box); })
         << ",\n \"zones\": "
         << jsonList(report_.zones, [this](const auto& zone) { return toJson(zone); });
    if (report_.distances) {
      out_ << ",\n \"distances\": "
           << jsonList(*report_.distances, [this](const auto& pair) { return toJson(pair); });
    }
    out_ << ",\n \"incomplete\": " << jsonObject(incompleteOf(report_), jsonString)
         << ",\n \"losses\": " << jsonList(report_.losses, jsonString) << "}\n";
  }

 private:
  std::string time(std::int64_t recorded) const { return seconds(recorded - report_.begin); }
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

  void writeZones() const {
    std::vector<Row> nearest{{"zone", "nearest", "distance", "at", "entries"}};
    std::vector<Row> stays{{"zone", "entered by", "from", "to", "end"}};
    for (const ZoneRecord& record : report_.zones) {
      const std::string zone = printable(record.zone.name);
      const std::string entries = std::to_string(record.entries);
      if (record.nearest) {
        nearest.push_back({zone, printable(record.nearest->name),
                           shortRow("", {record.nearest->distance})[1],
                           shortTime(record.nearest->when.recorded), entries});
      } else {
        nearest.push_back({zone, "-", "-", "-", entries});
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
      out_ << "(no pair was ever within " << shortRow("", {report_.distance_limit})[1] << " m)\n";
      return;
    }
    std::vector<Row> rows{{"first", "second", "distance", "distance max", "at", "level"}};
    for (const NearestPair& pair : *report_.distances) {
      Row row = shortRow(printable(pair.distance.first),
                         {pair.distance.distance, pair.distance.distance_max});
      row.insert(row.begin() + 1, printable(pair.distance.second));
      row.push_back(shortTime(pair.when.recorded));
      row.emplace_back(kLevels.at(pair.distance.level));
      rows.push_back(std::move(row));
    }
    writeAligned(rows, out_, 2);
  }

  void writeRow(const std::string& kind, const std::string& name, const std::string& other,
                std::optional<double> value, const Moment& when) const {
    out_ << kind << ',' << csvField(name) << ',' << csvField(other) << ','
         << (value ? exactNumber(*value) : "") << ',' << time(when.recorded) << ','
         << seconds(when.stamp) << '\n';
  }

  /// A JSON array with one element per line.
  template <class Element, class ToJson>
  static std::string jsonList(const std::vector<Element>& elements, const ToJson& to_json) {
    std::string result;
    for (const Element& element : elements)
      result += (result.empty() ? "\n  " : ",\n  ") + to_json(element);
    return "[" + result + "]";
  }

  std::string when(const Moment& moment) const {
    return "\"time\": " + time(moment.recorded) + ", \"stamp\": " + seconds(moment.stamp);
  }

  /// Three arrays: values, times and stamps.
  std::string extremes(const std::string& key, const std::array<Extreme, 3>& found) const {
    std::string values, times, stamps;
    for (const Extreme& extreme : found) {
      const char* comma = values.empty() ? "" : ", ";
      values += comma + exactNumber(extreme.value);
      times += comma + time(extreme.when.recorded);
      stamps += comma + seconds(extreme.when.stamp);
    }
    return quoted(key) + ": [" + values + "], " + quoted(key + "_time") + ": [" + times + "], " +
           quoted(key + "_stamp") + ": [" + stamps + "]";
  }

  std::string toJson(const BoxRecord& box) const {
    const std::string name = "{\"name\": " + jsonString(box.name);
    if (!box.has_box) return name + "}";
    return name + ", " + extremes("min", box.min) + ", " + extremes("max", box.max) + "}";
  }

  std::string toJson(const Stay& stay) const {
    return "{\"name\": " + jsonString(stay.name) + ", \"entered\": {" + when(stay.entered) +
           "}, \"end\": {" + when(stay.left) + "}, \"how\": " + quoted(toText(stay.end)) + "}";
  }

  std::string toJson(const ZoneRecord& record) const {
    std::string nearest = "null";
    if (record.nearest) {
      nearest = "{\"name\": " + jsonString(record.nearest->name) +
                ", \"distance\": " + exactNumber(record.nearest->distance) + ", " +
                when(record.nearest->when) + "}";
    }
    return "{\"name\": " + jsonString(record.zone.name) +
           ", \"frame\": " + jsonString(record.zone.frame) + ", \"nearest\": " + nearest +
           ", \"entries\": " + std::to_string(record.entries) + ", \"stays\": " +
           jsonList(record.stays, [this](const Stay& stay) { return toJson(stay); }) + "}";
  }

  std::string toJson(const NearestPair& pair) const {
    const Distance& distance = pair.distance;
    const auto vector = [](const auto& v) { return jsonNumbers(Eigen::Vector3d(v.x, v.y, v.z)); };
    return "{\"first\": " + jsonString(distance.first) +
           ", \"second\": " + jsonString(distance.second) +
           ", \"distance\": " + exactNumber(distance.distance) +
           ", \"distance_max\": " + exactNumber(distance.distance_max) +
           ", \"on_first\": " + vector(distance.on_first) +
           ", \"on_second\": " + vector(distance.on_second) +
           ", \"normal\": " + vector(distance.normal) +
           ", \"level\": " + quoted(kLevels.at(distance.level)) + ", " + when(pair.when) + "}";
  }

  const BagReport& report_;
  std::ostream& out_;
};

}  // namespace

std::string shortSeconds(std::int64_t time, std::int64_t begin) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f", static_cast<double>(time - begin) / kSecond);
  return text;
}

Reasons incompleteOf(const BagReport& report) {
  Reasons reasons;
  for (const BoxRecord& box : report.boxes) {
    if (!box.has_box && !box.reason.empty()) {
      reasons.emplace_back(box.name, "never had a box: " + box.reason);
      continue;
    }
    if (!box.partial.empty()) reasons.emplace_back(box.name, box.partial);
    if (box.gaps > 0) {
      reasons.emplace_back(box.name, "had no box " + std::to_string(box.gaps) +
                                         (box.gaps == 1 ? " time, " : " times, ") +
                                         shortSeconds(box.gaps_length, 0) + " s in all, first at " +
                                         shortSeconds(box.first_gap, report.begin) +
                                         " s: " + box.reason);
    }
  }
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
      return writer.writeJson();
  }
}

}  // namespace link_bounds
