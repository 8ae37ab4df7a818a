// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Columns as wide as their heads, whose words stand one above the other.
#include "bench/core/table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>

namespace link_bounds::bench {
namespace {

constexpr int kMeshWidth = 40;
constexpr int kCountWidth = 9;
constexpr int kLeastWidth = 9;

/// The rows of meshes, and the names of what was measured on them, in order.
struct Layout {
  std::vector<std::string> meshes;
  std::vector<std::string> methods;
};

void addOnce(const std::string& name, std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

Layout layoutOf(const Results& results) {
  Layout layout;
  for (const Result& result : results) {
    if (isLinkCount(result)) continue;
    addOnce(result.mesh, layout.meshes);
    addOnce(result.method, layout.methods);
  }
  return layout;
}

/// Three digits or more.
std::string toText(double value) {
  if (std::isnan(value)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(value < 9.995 ? 2 : value < 99.95 ? 1 : 0) << value;
  return text.str();
}

std::string upper(const std::string& method) {
  return method.substr(0, method.find('_'));
}

std::string lower(const std::string& method) {
  const std::size_t end = method.find('_');
  return end == std::string::npos ? "" : method.substr(end + 1);
}

int widthOf(const std::string& method) {
  const std::size_t longest = std::max(upper(method).size(), lower(method).size());
  return std::max(kLeastWidth, static_cast<int>(longest) + 1);
}

/// The end of a long name tells more than its beginning.
std::string shortened(const std::string& name) {
  constexpr std::size_t kLongest = kMeshWidth - 1;
  return name.size() <= kLongest ? name : "~" + name.substr(name.size() - kLongest + 1);
}

/// A row: its name, two counts that may be missing, and a text per method.
template <class TextOf>
void printRow(const std::string& name, const std::string& vertices, const std::string& hull,
              const Layout& layout, const TextOf& textOf, std::ostream& out) {
  out << std::left << std::setw(kMeshWidth) << name << std::right << std::setw(kCountWidth)
      << vertices << std::setw(kCountWidth) << hull;
  for (const std::string& method : layout.methods)
    out << std::setw(widthOf(method)) << textOf(method);
  out << "\n";
}

void printMesh(const Results& results, const std::string& mesh, const Layout& layout,
               std::ostream& out) {
  const auto text = [&](const std::string& method) {
    const Result* result = find(results, mesh, method);
    return result ? toText(result->ns) : "-";
  };
  const Result& any = *find(results, mesh, layout.methods.front());
  printRow(shortened(mesh), std::to_string(any.vertices), std::to_string(any.hull), layout, text,
           out);
}

using Value = std::function<double(const Result&)>;

std::vector<double> valuesOfRobots(const Results& results, const std::string& method,
                                   const Value& value) {
  std::vector<double> values;
  for (const Result& result : results) {
    if (result.method == method && isRobot(result)) values.push_back(value(result));
  }
  return values;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void printMedians(const Results& results, const std::string& ours, const Layout& layout,
                  std::ostream& out) {
  const auto print = [&](const std::string& name, const auto& value_of) {
    const auto text = [&](const std::string& method) { return toText(value_of(method)); };
    printRow(name, "", "", layout, text, out);
  };
  const auto median_of = [&results](const Value& value) {
    return [&results, value](const std::string& method) {
      return median(valuesOfRobots(results, method, value));
    };
  };
  print("ns", median_of([](const Result& result) { return result.ns; }));
  print("times " + ours,
        [&](const std::string& method) { return median(ratios(results, method, ours, isRobot)); });
  print("volume / exact volume",
        median_of([](const Result& result) { return result.volume_ratio; }));
  print("share of meshes with exact boxes", [&](const std::string& method) {
    return mean(
        valuesOfRobots(results, method, [](const Result& result) { return result.exact.value(); }));
  });
  print("kB a box is computed from", median_of([](const Result& result) {
          return result.bytes ? static_cast<double>(result.bytes) / 1e3 : std::nan("");
        }));
  out << "Exact: to 1e-9 of the longest side, which the single precision of Bullet misses.\n";
}

void printLinkCounts(const Results& results, std::ostream& out) {
  for (const Result& result : results) {
    if (!isLinkCount(result)) continue;
    out << std::left << std::setw(kMeshWidth) << result.mesh << std::right << std::setw(kCountWidth)
        << toText(result.ns) << " ns per link, tables of "
        << toText(static_cast<double>(result.bytes) / 1e6) << " MB"
        << (result.exact.value() ? "" : ", NOT exact") << "\n";
  }
}

}  // namespace

void printTable(const Results& results, const std::string& ours, std::ostream& out) {
  const Layout layout = layoutOf(results);
  out << "ns per box\n";
  printRow("", "", "", layout, upper, out);
  printRow("mesh", "vertices", "hull", layout, lower, out);
  for (const std::string& mesh : layout.meshes)
    printMesh(results, mesh, layout, out);
  out << "\nMedians over the robot meshes\n";
  printMedians(results, ours, layout, out);
  out << "\nUpdates of many links, all turning at random, by " << ours << "\n";
  printLinkCounts(results, out);
}

}  // namespace link_bounds::bench
