// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All formats have the same numbers in the same order.
#include "tools/urdf_bounds/poses/distance_table.h"

#include <algorithm>
#include <locale>
#include <sstream>

#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

Numbers distanceNumbers(const BodyDistance& distance) {
  Numbers numbers{distance.lower, distance.upper};
  for (const auto* vector : {&distance.on_first, &distance.on_second, &distance.normal})
    numbers.insert(numbers.end(), vector->data(), vector->data() + 3);
  return numbers;
}

}  // namespace

bool isRough(double lower, double upper) {
  constexpr double kRounding = 1 + 1e-9;  // allows for rounding of the two bounds
  return upper - lower > kRounding * DistanceGoal().accuracy;
}

std::size_t roughPairs(const DistanceTable& distances) {
  const auto is_rough = [](const LinkDistance& pair) {
    return isRough(pair.distance.lower, pair.distance.upper);
  };
  const auto count = std::count_if(distances.pairs.begin(), distances.pairs.end(), is_rough);
  return static_cast<std::size_t>(count);
}

void writeTable(const DistanceTable& distances, std::ostream& out) {
  if (distances.pairs.empty()) {
    std::ostringstream limit;
    limit.imbue(std::locale::classic());
    limit << distances.limit;
    out << "(no two links are within " << limit.str() << " m of each other)\n";
    return;
  }
  std::vector<Row> rows{{"first", "second", "distance", "distance max", "on first x", "y", "z",
                         "on second x", "y", "z", "normal x", "y", "z", "level"}};
  for (const LinkDistance& pair : distances.pairs) {
    Row row = shortRow(printable(pair.first), distanceNumbers(pair.distance));
    row.insert(row.begin() + 1, printable(pair.second));
    row.emplace_back(toText(pair.distance.level));
    rows.push_back(std::move(row));
  }
  writeAligned(rows, out, 2);
}

void writeCsvHead(std::ostream& out) {
  out << "first,second,distance,distance_max,on_first_x,on_first_y,on_first_z,on_second_x,"
         "on_second_y,on_second_z,normal_x,normal_y,normal_z,level\n";
}

std::string csvLine(const LinkDistance& pair) {
  std::string line = csvField(pair.first) + "," + csvField(pair.second);
  for (const double number : distanceNumbers(pair.distance))
    line += "," + exactNumber(number);
  return line + "," + toText(pair.distance.level) + "\n";
}

void writeCsv(const DistanceTable& distances, std::ostream& out) {
  writeCsvHead(out);
  for (const LinkDistance& pair : distances.pairs)
    out << csvLine(pair);
}

std::string toJson(const DistanceTable& distances) {
  return jsonList(distances.pairs, [](const LinkDistance& pair) {
    return "{" + jsonMembers(pair.first, pair.second, pair.distance) + "}";
  });
}

}  // namespace link_bounds
