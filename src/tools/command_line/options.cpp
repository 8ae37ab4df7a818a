// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers are read in the classic locale.
#include "tools/command_line/options.h"

#include <getopt.h>

#include <cmath>
#include <locale>
#include <sstream>

namespace link_bounds {
namespace {

/// Threads beyond any machine.
constexpr unsigned kMaxJobs = 1024;

}  // namespace

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

unsigned jobsOption(const std::string& text) {
  const std::optional<double> value = toNumber(text);
  if (value && *value >= 1 && *value <= kMaxJobs && std::trunc(*value) == *value)
    return static_cast<unsigned>(*value);
  throw UsageError("--jobs is \"" + text + "\", but must be a whole number from 1 to " +
                   std::to_string(kMaxJobs) + ", such as 2");
}

/// getopt_long leaves the letter or code in optopt where it knows one.
std::string badOption(const char* const* argv, int first_code) {
  if (optopt >= first_code) return std::string(argv[optind - 1]) + ": this option takes no value";
  if (optopt > 0) return std::string("there is no option -") + static_cast<char>(optopt);
  return std::string("there is no option ") + argv[optind - 1];
}

}  // namespace link_bounds
