// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Values of options, for programs that use getopt_long.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace link_bounds {

/// The command line cannot be used; what() is the reason, in words for the user.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Nothing if the text is no finite number to its last character.
std::optional<double> toNumber(const std::string& text);

/// A number >= 0 of `unit`. Throws UsageError.
double limitOption(const std::string& option_name, const std::string& text,
                   const std::string& unit = "metres");

/// A number of threads or processes, 1 to 1024. Throws UsageError.
unsigned jobsOption(const std::string& text);

/// Why getopt_long returned '?'. Codes of long options begin at `first_code`.
std::string badOption(const char* const* argv, int first_code);

/// The value called `name`. Throws UsageError with all names if there is none.
template <class Value>
Value chosen(const std::string& option_name, const std::string& name,
             const std::map<std::string, Value>& choices) {
  const auto found = choices.find(name);
  if (found != choices.end()) return found->second;
  std::string names;
  for (const auto& choice : choices)
    names += (names.empty() ? "" : ", ") + choice.first;
  throw UsageError(option_name + " is \"" + name + "\", but must be one of: " + names);
}

}  // namespace link_bounds
