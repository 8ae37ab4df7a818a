// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The name comes first, so that a line that was cut says what it was about.
#include "tools/bag_bounds/lines/bag_line.h"

#include <filesystem>

#include "tools/bag_bounds/run/bag_report_json.h"
#include "tools/bag_bounds/run/fingerprint.h"
#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

constexpr std::uint64_t kHeadBytes = 1 << 16;

std::string start(const BagIdentity& bag, const std::string& question, const std::string& verdict,
                  int exit_code) {
  return "{\"bag\": " + jsonString(bag.name) +
         ", \"size\": " + (bag.size ? std::to_string(*bag.size) : "null") +
         ", \"head\": " + (bag.size ? jsonString(bag.head) : "null") +
         ", \"question\": " + jsonString(question) + ", \"verdict\": " + jsonString(verdict) +
         ", \"exit\": " + std::to_string(exit_code);
}

BagLine lineWithout(const BagIdentity& bag, const std::string& question, const char* verdict,
                    const std::string& reason) {
  return {start(bag, question, verdict, kUnusable) + ", \"reason\": " + jsonString(reason) + "}\n",
          kUnusable};
}

}  // namespace

BagIdentity identityOf(const std::string& bag) {
  BagIdentity result{bag, std::nullopt, ""};
  std::error_code error;
  if (!std::filesystem::is_regular_file(bag, error)) return result;
  const std::uint64_t size = std::filesystem::file_size(bag, error);
  Fingerprint head;
  if (error || !head.addFile(bag, kHeadBytes)) return result;
  result.size = size;
  result.head = head.text();
  return result;
}

BagLine lineOf(const BagIdentity& bag, const std::string& question, const BagRun& run,
               const Demand& demand) {
  const BagReport report = run.report();
  const Outcome outcome = run.outcome(report);
  if (outcome.is_unusable) return unusableLine(bag, question, run.whyUseless(report));
  const int code = exitCode(outcome, demand);
  return {start(bag, question, verdictOf(code), code) + ", " + summaryJson(report) +
              ", \"open\": [" + joined(outcome.open, ", ", jsonString) + "]}\n",
          code};
}

BagLine unusableLine(const BagIdentity& bag, const std::string& question,
                     const std::string& reason) {
  return lineWithout(bag, question, verdictOf(kUnusable), reason);
}

BagLine diedLine(const BagIdentity& bag, const std::string& question, const std::string& reason) {
  return lineWithout(bag, question, "DIED", reason);
}

}  // namespace link_bounds
