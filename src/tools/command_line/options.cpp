// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers are read in the classic locale.
#include "tools/command_line/options.h"

#include <getopt.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <set>
#include <sstream>
#include <utility>

namespace link_bounds {
namespace {

constexpr int kFirstCode = 256;  // the first code of long options; smaller ones are letters

/// getopt_long leaves the letter or code of the option in optopt; 0 if a long name is unknown.
std::string badOption(const char* const* argv) {
  if (optopt >= kFirstCode) return std::string(argv[optind - 1]) + ": this option takes no value";
  if (optopt > 0) {
    // Within a group of letters such as -ab, optind is still the index of that group.
    const char* const word = argv[optind] ? argv[optind] : argv[optind - 1];
    const bool is_joint =
        std::string(word).find(":=") != std::string::npos && word[0] == '-' && word[1] == optopt;
    return std::string("there is no option -") + static_cast<char>(optopt) +
           (is_joint ? "; write -- before joints whose name begins with -" : "");
  }
  return std::string("there is no option ") + argv[optind - 1];
}

}  // namespace

std::string nonEmpty(const std::string& option_name, const std::string& text) {
  if (text.empty()) throw UsageError(option_name + " is empty");
  return text;
}

std::optional<double> toNumber(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  in >> std::noskipws >> value;
  if (!in || in.peek() != std::istringstream::traits_type::eof() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

double limitOption(const std::string& option_name, const std::string& text,
                   const std::string& unit) {
  const std::optional<double> limit = toNumber(text);
  if (limit && *limit >= 0) return *limit;
  throw UsageError(option_name + " is \"" + text + "\", but must be a number of " + unit +
                   " >= 0, such as 0.1");
}

unsigned jobsOption(const std::string& option_name, const std::string& text) {
  const std::optional<double> value = toNumber(text);
  if (value && *value >= 1 && *value <= kMaxJobs && std::trunc(*value) == *value)
    return static_cast<unsigned>(*value);
  throw UsageError(option_name + " is \"" + text + "\", but must be a whole number from 1 to " +
                   std::to_string(kMaxJobs) + ", such as 2");
}

std::string geometryOption(const std::string& option_name, const std::string& text) {
  return chosen<std::string>(option_name, text,
                             {{"visual", "visual"}, {"collision", "collision"}, {"both", "both"}});
}

Option flag(const char* name, bool& target) {
  return {name, [&target](const auto&, const auto&) { target = true; }, false};
}

Option repeatable(const char* name, Option::Take take) {
  return {name, std::move(take), true, true};
}

bool parseCommandLine(int argc, char** argv, const std::vector<Option>& options,
                      const std::function<void(const std::string&)>& take_argument) {
  std::vector<option> table;
  for (const Option& entry : options)
    table.push_back({entry.name, entry.has_value ? required_argument : no_argument, nullptr,
                     kFirstCode + static_cast<int>(table.size())});
  table.push_back({nullptr, 0, nullptr, 0});
  opterr = 0;
  int code = 0;
  std::set<std::string> given;
  // The leading minus returns other arguments in order, even if POSIXLY_CORRECT is set.
  while ((code = getopt_long(argc, argv, "-:h", table.data(), nullptr)) != -1) {
    if (code == 1) {
      take_argument(optarg);
      continue;
    }
    if (code == ':') throw UsageError(std::string("option ") + argv[optind - 1] + " needs a value");
    if (code != 'h' && code < kFirstCode) throw UsageError(badOption(argv));
    const std::string name =
        code == 'h' ? "help" : table[static_cast<std::size_t>(code - kFirstCode)].name;
    const auto entry = std::find_if(options.begin(), options.end(),
                                    [&](const Option& known) { return known.name == name; });
    if (entry->has_value && !entry->is_repeatable && !given.insert(name).second)
      throw UsageError("--" + name + " is given twice; give it once");
    entry->take("--" + name, optarg ? optarg : "");
    if (name == "help" || name == "version") return false;
  }
  for (; optind < argc; ++optind)
    take_argument(argv[optind]);
  return true;
}

}  // namespace link_bounds
