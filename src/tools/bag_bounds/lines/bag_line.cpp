// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The name comes first, so that a line that was cut still names its bag. Lines are read as YAML,
// which includes JSON on one line.
#include "tools/bag_bounds/lines/bag_line.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "text/joined.h"
#include "tools/bag_bounds/run/bag_report.h"
#include "tools/bag_bounds/run/fingerprint.h"
#include "tools/command_line/options.h"
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
          kUnusable, kUnusable};
}

/// The begin of a line. It cannot occur within a string, whose quotes are escaped.
constexpr char kStart[] = "{\"bag\": ";

std::string reasonIn(const YAML::Node& line) {
  std::vector<std::string> texts;
  if (line["reason"]) texts.push_back(line["reason"].as<std::string>());
  for (const auto& entry : texts.empty() ? line["incomplete"] : YAML::Node())
    texts.push_back(entry.first.as<std::string>() + " " + entry.second.as<std::string>());
  for (const YAML::Node& loss : line["losses"])
    texts.push_back(loss.as<std::string>());
  for (const YAML::Node& open : texts.empty() ? line["open"] : YAML::Node())
    texts.push_back(open.as<std::string>());
  return joined(texts, "; ");
}

/// The index behind the string whose opening quote is at `begin`.
std::size_t endOfString(const std::string& json, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < json.size() && json[end] != '"')
    end += json[end] == '\\' ? 2 : 1;
  return std::min(end + 1, json.size());
}

/// YAML needs a question mark before a key of more than 1024 bytes, so each key gets one.
std::string withMarkedKeys(const std::string& json) {
  std::string yaml;
  std::size_t end = 0;
  for (auto begin = json.find('"'); begin != std::string::npos; begin = json.find('"', end)) {
    yaml.append(json, end, begin - end);
    end = endOfString(json, begin);
    if (json.compare(end, 1, ":") == 0) yaml += "? ";
    yaml.append(json, begin, end - begin);
  }
  return yaml.append(json, end);
}

/// Throws YAML::Exception.
ReadLine parse(const std::string& text) {
  const YAML::Node line = YAML::Load(withMarkedKeys(text));
  ReadLine result;
  result.text = text;
  result.bag.name = line["bag"].as<std::string>();
  if (!line["size"].IsNull()) {
    result.bag.size = line["size"].as<std::uint64_t>();
    result.bag.head = line["head"].as<std::string>();
  }
  result.question = line["question"].as<std::string>();
  result.verdict = line["verdict"].as<std::string>();
  result.exit_code = line["exit"].as<int>();
  result.complete_code = result.exit_code;
  if (line["complete_exit"]) result.complete_code = line["complete_exit"].as<int>();
  result.reason = reasonIn(line);
  if (line["left_out"]) result.left_out = line["left_out"].as<std::string>();
  if (const YAML::Node least = line["coverage"]; least && !least.IsNull())
    result.coverage = {least["name"].as<std::string>(), least["share"].as<double>()};
  if (const YAML::Node worst = line["worst"]; worst && !worst.IsNull())
    result.worst = {worst["first"].as<std::string>(), worst["second"].as<std::string>(),
                    worst["clearance"].as<double>(), worst["distance"].as<double>(),
                    worst["time"].as<std::string>()};
  for (const YAML::Node& zone : line["zones"])
    result.zones.push_back({zone["name"].as<std::string>(), zone["entries"].as<std::uint64_t>()});
  return result;
}

/// std::nullopt if the line was cut. Throws YAML::Exception if it is whole, but lacks a key.
std::optional<ReadLine> tryParse(const std::string& text) try {
  return text.back() == '}' ? std::optional(parse(text)) : std::nullopt;
} catch (const YAML::ParserException&) {
  return std::nullopt;
}

/// Removes additions of editors and other systems: a byte order mark and a carriage return.
std::string plain(std::string text) {
  constexpr char kMark[] = "\xef\xbb\xbf";
  if (text.rfind(kMark, 0) == 0) text.erase(0, sizeof(kMark) - 1);
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return text;
}

/// Whether verdict and exit code go together.
bool isConsistent(const ReadLine& line) {
  const bool is_rest =
      line.exit_code == kOpen && (line.complete_code == 0 || line.complete_code == 2);
  if (line.complete_code != line.exit_code && !is_rest) return false;
  const bool is_unusable = line.hasDied() || line.verdict == verdictOf(kUnusable);
  return is_unusable ? line.exit_code == kUnusable : line.verdict == verdictOf(line.exit_code);
}

/// Whether the text may be the begin of a line that was cut.
bool isBegun(const std::string& text) {
  return std::string(kStart).compare(0, text.size(), text, 0, sizeof(kStart) - 1) == 0;
}

/// The name of the bag in a line that was cut, as JSON; "" if the name itself was cut.
std::string nameIn(const std::string& cut) {
  const std::size_t end = cut.find(", \"size\": ");
  const std::size_t begin = sizeof(kStart) - 1;
  return end == std::string::npos || end < begin ? "" : cut.substr(begin, end - begin);
}

/// Whether `later` cannot be a later state of the bag `earlier`.
bool isOther(const BagIdentity& earlier, const BagIdentity& later) {
  return (earlier.size != later.size || earlier.head != later.head) && !isBeginOf(earlier, later);
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  /// A line that another program appended to a cut line is a line of its own.
  void add(const std::string& text) {
    ++number_;
    if (text.empty()) return;
    const std::size_t start = text.rfind(kStart);
    if (start == std::string::npos && !isBegun(text)) refuse();
    const std::optional<ReadLine> line =
        start == std::string::npos ? std::nullopt : read(text.substr(start));
    if (start != 0 || !line) result_.cut.push_back({place(), nameIn(text)});
    if (!line) return;
    if (!isConsistent(*line))
      throw UsageError(place() + " has the verdict \"" + line->verdict + "\", but the exit code " +
                       std::to_string(line->exit_code) + " (" +
                       std::to_string(line->complete_code) +
                       " with --allow-incomplete), which does not go with it; remove it");
    watchFindings(*line);
    ReadLine& known = result_.lines[line->bag.name];
    known = *line;
    known.file = file_;
  }

  LineFile take() { return std::move(result_); }

 private:
  [[noreturn]] void refuse() const {
    throw UsageError(place() + " is no line of bag_bounds --each; remove it, or name another file");
  }

  std::optional<ReadLine> read(const std::string& text) const try {
    return tryParse(text);
  } catch (const YAML::Exception&) {
    refuse();
  }

  /// A later line must not hide what was found in another bag of its name.
  void watchFindings(const ReadLine& line) {
    if (!line.bag.size) return;
    const auto found = found_.find(line.bag.name);
    if (found != found_.end() && isOther(found->second, line.bag))
      result_.two_bags = place() + " is of bag " + line.bag.name +
                         ", and so is an earlier line with a finding, but of another size or " +
                         "content: if these are two bags, make their lines with different paths; " +
                         "if it was replaced, remove the earlier line";
    if (line.verdict == verdictOf(kFinding)) found_[line.bag.name] = line.bag;
  }

  std::string place() const { return file_ + ", line " + std::to_string(number_); }

  const std::string& file_;
  std::size_t number_ = 0;
  std::map<std::string, BagIdentity> found_;  ///< bags with a finding, by name
  LineFile result_;
};

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

bool isBeginOf(const BagIdentity& begin, const BagIdentity& whole) {
  return begin.size < whole.size && (begin.size == 0 || begin.head == whole.head);
}

BagLine lineOf(const BagIdentity& bag, const std::string& question, const BagRun& run,
               const Demand& demand) {
  const BagReport report = run.report();
  const Outcome outcome = run.outcome(report);
  const std::string useless = run.whyUseless(report);
  if (outcome.is_unusable) return unusableLine(bag, question, useless);
  Demand complete = demand;
  complete.allow_incomplete = true;
  Demand strict = demand;
  strict.allow_incomplete = false;
  const int code = exitCode(outcome, strict);
  const int complete_code = exitCode(outcome, complete);
  const std::string rest =
      code == kOpen ? "\"complete_exit\": " + std::to_string(complete_code) + ", " : "";
  const std::string reason = useless.empty() ? "" : "\"reason\": " + jsonString(useless) + ", ";
  return {start(bag, question, verdictOf(code), code) + ", " + rest + reason + summaryJson(report) +
              ", \"open\": [" + joined(outcome.open, ", ", jsonString) + "]}\n",
          code, complete_code};
}

BagLine unusableLine(const BagIdentity& bag, const std::string& question,
                     const std::string& reason) {
  return lineWithout(bag, question, verdictOf(kUnusable), reason);
}

BagLine diedLine(const BagIdentity& bag, const std::string& question, const std::string& reason) {
  return lineWithout(bag, question, "DIED", reason);
}

std::vector<std::string> placesOfCut(const std::vector<LineFile>& files) {
  std::set<std::string> whole;
  for (const LineFile& file : files)
    for (const auto& [bag, line] : file.lines)
      whole.insert(jsonString(bag));
  std::vector<std::string> places;
  for (const LineFile& file : files)
    for (const LineFile::Cut& cut : file.cut)
      if (whole.count(cut.name) == 0) places.push_back(cut.place);
  return places;
}

LineFile readLines(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw UsageError("cannot read " + file + ": " + std::strerror(errno));
  Reader reader(file);
  for (std::string text; std::getline(in, text);)
    reader.add(plain(text));
  if (in.bad()) throw UsageError("cannot read " + file + " to its end");
  return reader.take();
}

}  // namespace link_bounds
