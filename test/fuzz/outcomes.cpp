// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Counters and a table in Markdown.
#include "outcomes.h"

#include <cstdio>
#include <numeric>

namespace link_bounds {
namespace {

constexpr double kMinShare = 0.2;

/// Shares of fewer meshes vary too much to be checked.
constexpr long kMinMeshes = 100;

template <class Row>
long sum(const Row& row) {
  return std::accumulate(row.begin(), row.end(), 0L);
}

template <class Row>
void printRow(const std::string& name, const Row& row) {
  std::printf("| %-11s | %6ld | %7ld | %8ld | %9ld | %6ld | %9ld |\n", name.c_str(), sum(row),
              row[0], row[1], row[2], row[3], row[4]);
}

}  // namespace

Outcome refusalOf(const std::string& reason) {
  if (reason.find("died of it") != std::string::npos) return Outcome::kDied;
  if (reason.find("takes longer than") != std::string::npos) return Outcome::kTimedOut;
  return Outcome::kRefused;
}

void Outcomes::add(const std::string& format, Outcome outcome) {
  ++rows_[format][static_cast<std::size_t>(outcome)];
}

void Outcomes::print() const {
  std::puts("| format      | meshes | refused | same box | other box | died   | timed out |");
  std::puts("|-------------|--------|---------|----------|-----------|--------|-----------|");
  std::array<long, kOutcomes> total{};
  for (const auto& [format, row] : rows_) {
    printRow(format, row);
    for (std::size_t i = 0; i < kOutcomes; ++i)
      total[i] += row[i];
  }
  printRow("all", total);
}

std::string Outcomes::imbalanceOf(const std::string& format) const {
  const auto& row = rows_.at(format);
  const long count = sum(row);
  if (count < kMinMeshes) return "";
  const auto others = static_cast<double>(row[static_cast<std::size_t>(Outcome::kOtherBox)]);
  const auto same = static_cast<double>(row[static_cast<std::size_t>(Outcome::kSameBox)]);
  const double refused = static_cast<double>(count) - others - same;
  if (refused < kMinShare * static_cast<double>(count)) return format + ": few are refused";
  if (others < kMinShare * static_cast<double>(count)) return format + ": few get another box";
  return "";
}

}  // namespace link_bounds
