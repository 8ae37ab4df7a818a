// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The table begins with the counts of rows.
#include "tools/urdf_bounds/poses/rows_table.h"

#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

using Boxes = std::vector<std::pair<std::string, Aabb>>;

Boxes linkBoxes(const RowsTable& table) {
  Boxes result;
  for (std::size_t i = 0; i < table.links.size(); ++i) {
    if (!table.boxes[i].isEmpty()) result.emplace_back(table.links[i], table.boxes[i]);
  }
  return result;
}

/// The box of the robot, unless there is none.
Boxes groupBoxes(const RowsTable& table) {
  Aabb all;
  for (const Aabb& box : table.boxes)
    all.extend(box);
  if (all.isEmpty()) return {};
  return {{"robot", all}};
}

std::string number(std::size_t row) {
  return std::to_string(row + 1);
}

std::string rowText(const RowsTable& table, const std::optional<std::size_t>& row) {
  if (!row) return "none";
  const std::string time =
      table.times.empty() ? "" : " (" + shortestNumber(table.times[*row]) + " s)";
  return "row " + number(*row) + time;
}

void writePairs(const RowsTable& table, std::ostream& out) {
  if (table.pairs.empty()) {
    out << "\n(no two links are within " << shortLength(*table.limit)
        << " of each other in any row)\n";
    return;
  }
  std::vector<Row> rows{{"first", "second", "distance", "distance max", "in row", "contacts"}};
  for (const auto& [pair, nearest] : table.pairs) {
    Row row =
        shortRow(printable(table.links[pair.first]), {nearest.distance, nearest.distance_max});
    row.insert(row.begin() + 1, printable(table.links[pair.second]));
    row.push_back(number(nearest.row));
    row.push_back(std::to_string(nearest.contacts));
    rows.push_back(std::move(row));
  }
  writeAligned(rows, out << '\n', 2);
}

/// "5", or "3 of 5" where some were left out.
std::string countText(const RowsTable& table) {
  const std::string all = std::to_string(table.count);
  return table.left_out == 0 ? all : std::to_string(table.count - table.left_out) + " of " + all;
}

void writeTable(const RowsTable& table, std::ostream& out) {
  out << "frame: " << printable(table.frame) << "    unit: m    rows: " << countText(table);
  if (table.limit) {
    out << "    with contact: " << table.with_contact
        << "    first: " << rowText(table, table.first)
        << "    worst: " << rowText(table, table.worst);
  }
  out << "\n\n";
  const std::string which = table.left_out == 0 ? "all" : countText(table);
  std::vector<Row> rows{
      {"in " + which + " rows", "min x", "min y", "min z", "max x", "max y", "max z"}};
  for (const auto& [name, box] : linkBoxes(table))
    rows.push_back(shortRow(printable(name), numbersOf(box)));
  for (const auto& [name, box] : groupBoxes(table))
    rows.push_back(shortRow(kGroupPrefix + name, numbersOf(box)));
  writeAligned(rows, out);
  if (table.limit) writePairs(table, out);
  writeIncomplete(table.incomplete, out);
}

void writeCsv(const RowsTable& table, std::ostream& out) {
  if (!table.limit) {
    out << "link,min_x,min_y,min_z,max_x,max_y,max_z\n";
    for (const auto& [name, box] : linkBoxes(table))
      writeCsvRow(name, numbersOf(box), out);
    for (const auto& [name, box] : groupBoxes(table))
      writeCsvRow(kGroupPrefix + name, numbersOf(box), out);
    return writeCsvIncomplete(table.incomplete, 6, out);
  }
  out << "first,second,distance,distance_max,row,contacts\n";
  for (const auto& [pair, nearest] : table.pairs) {
    out << csvField(table.links[pair.first]) << ',' << csvField(table.links[pair.second]) << ','
        << exactNumber(nearest.distance) << ',' << exactNumber(nearest.distance_max) << ','
        << number(nearest.row) << ',' << nearest.contacts << '\n';
  }
}

std::string jsonRow(const std::optional<std::size_t>& row) {
  return row ? number(*row) : "null";
}

std::string boxJson(const Aabb& box) {
  return "{" + jsonCorners(box) + "}";
}

void writeJson(const RowsTable& table, std::ostream& out) {
  out << "{\"frame\": " << jsonString(table.frame) << ",\n \"rows\": {\"count\": " << table.count
      << ", \"left_out\": " << table.left_out << ", \"with_contact\": "
      << (table.limit ? std::to_string(table.with_contact) : std::string("null"))
      << ", \"first\": " << jsonRow(table.first) << ", \"worst\": " << jsonRow(table.worst) << "}"
      << ",\n \"boxes\": " << jsonObject(linkBoxes(table), boxJson)
      << ",\n \"groups\": " << jsonObject(groupBoxes(table), boxJson);
  if (table.limit) {
    const auto to_json = [&](const auto& entry) {
      const auto& [pair, nearest] = entry;
      return "{\"first\": " + jsonString(table.links[pair.first]) +
             ", \"second\": " + jsonString(table.links[pair.second]) +
             ", \"distance\": " + exactNumber(nearest.distance) +
             ", \"distance_max\": " + exactNumber(nearest.distance_max) +
             ", \"row\": " + number(nearest.row) +
             ", \"contacts\": " + std::to_string(nearest.contacts) + "}";
    };
    out << ",\n \"pairs\": ";
    writeJsonList(table.pairs, to_json, out);
  }
  out << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

}  // namespace

void write(const RowsTable& table, Format format, std::ostream& out) {
  writerFor<TableWriter<RowsTable>>(format, writeTable, writeCsv, writeJson)(table, out);
}

}  // namespace link_bounds
