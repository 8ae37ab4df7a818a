// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A report as JSON: in full, with one box, zone, stay, pair or reason per line, or its summary in
// one line. doc/tools.md describes the keys.
#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "tools/bag_bounds/run/bag_report.h"
#include "tools/bag_bounds/scene/record_time.h"
#include "tools/formats/table_text.h"
#include "world/moment/distance_message.h"

namespace link_bounds {
namespace {

/// Writes one report. Times count from the first message.
class JsonWriter {
 public:
  explicit JsonWriter(const BagReport& report) : report_(report) {}

  void write(std::ostream& out) const {
    out << '{';
    writeHead(out);
    out << ",\n \"extremes\": "
        << jsonList(report_.boxes, [this](const auto& box) { return toJson(box); })
        << ",\n \"boxes\": "
        << jsonList(report_.boxes_at, [this](const auto& box) { return toJson(box); })
        << ",\n \"zones\": "
        << jsonList(report_.zones, [this](const auto& zone) { return toJson(zone); });
    if (report_.distances) {
      out << ",\n \"distances\": "
          << jsonList(*report_.distances, [this](const auto& pair) { return toJson(pair); });
    }
    writeLosses(out);
    out << ",\n \"open\": " << jsonList(report_.open, jsonString) << "}\n";
  }

  void writeSummary(std::ostream& out) const {
    writeHead(out);
    out << ",\n \"coverage\": " << leastCovered();
    if (report_.distances) {
      out << ",\n \"pairs\": " << report_.distances->size() << ",\n \"worst\": " << nearestPair();
    }
    out << ",\n \"zones\": "
        << jsonList(report_.zones, [this](const auto& zone) { return entriesOf(zone); });
    writeLosses(out);
  }

 private:
  void writeHead(std::ostream& out) const {
    out << "\"frame\": " << jsonString(report_.frame)
        << ",\n \"begin\": " << exactSeconds(report_.begin)
        << ",\n \"from\": " << time(report_.from) << ",\n \"to\": " << time(report_.to)
        << ",\n \"messages\": " << report_.messages;
  }

  void writeLosses(std::ostream& out) const {
    out << ",\n \"incomplete\": " << jsonObject(incompleteOf(report_), jsonString)
        << ",\n \"losses\": " << jsonList(report_.losses, jsonString)
        << ",\n \"left_out\": " << jsonString(report_.left_out);
  }

  /// The link or object with the min coverage; of several, the first in the order of ~boxes.
  std::string leastCovered() const {
    const BoxRecord* least = nullptr;
    for (const BoxRecord& box : report_.boxes)
      if (box.coverage && (!least || *box.coverage < *least->coverage)) least = &box;
    if (!least) return "null";
    return "{\"name\": " + jsonString(least->name) +
           ", \"share\": " + exactNumber(*least->coverage) + "}";
  }

  /// The pair with the smallest proven clearance; of several, the nearest one, and of these the
  /// first by name.
  std::string nearestPair() const {
    const auto nearest = std::min_element(
        report_.distances->begin(), report_.distances->end(), [](const auto& a, const auto& b) {
          return std::make_pair(a.clearance, a.distance.distance) <
                 std::make_pair(b.clearance, b.distance.distance);
        });
    return nearest == report_.distances->end() ? "null" : toJson(*nearest);
  }

  std::string entriesOf(const ZoneRecord& record) const {
    std::string first = "null";
    if (record.first) {
      first = "{\"name\": " + jsonString(record.first->name) + ", " + when(record.first->entered) +
              after(record.first->outside_at) + "}";
    }
    return "{\"name\": " + jsonString(record.zone.name) + ", " + approachTo(record) +
           ", \"first\": " + first + "}";
  }

  std::string time(std::int64_t recorded) const { return exactSeconds(recorded - report_.begin); }

  std::string when(const RecordTime& moment) const {
    return "\"time\": " + time(moment.recorded) + ", \"stamp\": " + stampSeconds(moment.stamp);
  }

  /// The stamp before an entry or exit, which happened between this one and its own stamp.
  static std::string after(const std::optional<std::int64_t>& stamp) {
    return stamp ? ", \"after\": " + stampSeconds(*stamp) : "";
  }

  /// Three arrays: values, times and stamps.
  std::string extremes(const std::string& key, const std::array<Extreme, 3>& found) const {
    std::string values, times, stamps;
    for (const Extreme& extreme : found) {
      const char* comma = values.empty() ? "" : ", ";
      values += comma + exactNumber(extreme.value);
      times += comma + time(extreme.when.recorded);
      stamps += comma + stampSeconds(extreme.when.stamp);
    }
    return jsonString(key) + ": [" + values + "], " + jsonString(key + "_time") + ": [" + times +
           "], " + jsonString(key + "_stamp") + ": [" + stamps + "]";
  }

  std::string toJson(const BoxRecord& box) const {
    const std::string name = "{\"name\": " + jsonString(box.name) +
                             (box.coverage ? ", \"coverage\": " + exactNumber(*box.coverage) : "");
    if (!box.has_box) return name + "}";
    std::string speed;
    if (box.speed)
      speed = ", \"max_speed\": {\"value\": " + exactNumber(box.speed->value) + ", " +
              when(box.speed->when) + "}";
    return name + ", " + extremes("min", box.min) + ", " + extremes("max", box.max) + speed + "}";
  }

  std::string toJson(const BoxAt& found) const {
    std::string result = "{\"name\": " + jsonString(found.name);
    if (found.box)
      result += ", " + jsonCorners(*found.box) + ", " + when({*report_.at, found.stamp});
    return result + "}";
  }

  std::string toJson(const Stay& stay) const {
    return "{\"name\": " + jsonString(stay.name) + ", \"entered\": {" + when(stay.entered) +
           after(stay.outside_at) + "}, \"end\": {" + when(stay.left) + after(stay.inside_at) +
           "}, \"how\": " + jsonString(toText(stay.end)) + "}";
  }

  std::string approachTo(const ZoneRecord& record) const {
    std::string nearest = "null";
    if (record.nearest) {
      nearest = "{\"name\": " + jsonString(record.nearest->name) +
                ", \"distance\": " + exactNumber(record.nearest->distance) + ", " +
                when(record.nearest->when) + "}";
    }
    return "\"nearest\": " + nearest +
           ", \"clearance\": " + (record.nearest ? exactNumber(record.clearance) : "null") +
           ", \"coverage\": " + exactNumber(record.coverage) +
           ", \"undecided\": " + std::to_string(record.undecided) +
           ", \"entries\": " + std::to_string(record.entries);
  }

  std::string toJson(const ZoneRecord& record) const {
    return "{\"name\": " + jsonString(record.zone.name) +
           ", \"frame\": " + jsonString(record.zone.frame) + ", " + approachTo(record) +
           ", \"stays\": " +
           jsonList(record.stays, [this](const Stay& stay) { return toJson(stay); }) + "}";
  }

  std::string toJson(const NearestPair& pair) const {
    return "{" +
           jsonMembers(pair.distance.first, pair.distance.second, bodyDistanceOf(pair.distance),
                       ", \"clearance\": " + exactNumber(pair.clearance)) +
           ", " + when(pair.when) + "}";
  }

  const BagReport& report_;
};

}  // namespace

void writeJson(const BagReport& report, std::ostream& out) {
  JsonWriter(report).write(out);
}

/// Removes the line breaks, which are only between elements: strings have theirs escaped.
std::string summaryJson(const BagReport& report) {
  std::ostringstream out;
  JsonWriter(report).writeSummary(out);
  std::string text = out.str();
  text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
  return text;
}

}  // namespace link_bounds
