// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Command lines, by getopt_long.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "text/joined.h"

namespace link_bounds {

/// The command line cannot be used; what() is the reason, in words for the user.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The text. Throws UsageError if it is empty.
std::string nonEmpty(const std::string& option_name, const std::string& text);

/// Nothing if the text is no finite number to its last character.
std::optional<double> toNumber(const std::string& text);

/// A number >= 0 of `unit`. Throws UsageError.
double limitOption(const std::string& option_name, const std::string& text,
                   const std::string& unit = "metres");

/// Threads beyond any machine.
constexpr unsigned kMaxJobs = 1024;

/// A number of threads or processes, 1 to kMaxJobs. Throws UsageError.
unsigned jobsOption(const std::string& option_name, const std::string& text);

/// The value called `name`. Throws UsageError with all names if there is none.
template <class Value>
Value chosen(const std::string& option_name, const std::string& name,
             const std::map<std::string, Value>& choices) {
  const auto found = choices.find(name);
  if (found != choices.end()) return found->second;
  throw UsageError(option_name + " is \"" + name + "\", but must be one of: " +
                   joined(choices, ", ", [](const auto& choice) { return choice.first; }));
}

/// visual, collision or both. Throws UsageError.
std::string geometryOption(const std::string& option_name, const std::string& text);

struct Option {
  /// Gets the name with its dashes, and the value.
  using Take = std::function<void(const std::string& name, const std::string& value)>;

  const char* name;  ///< without dashes
  Take take;
  bool has_value = true;
  bool is_repeatable = false;  ///< with a value each time; without a value, any option is
};

/// Sets the target to true.
Option flag(const char* name, bool& target);

/// May be given several times.
Option repeatable(const char* name, Option::Take take);

/// Sets the target to read(name, value).
template <class Target, class Read>
Option::Take into(Target& target, Read read) {
  return [&target, read](const std::string& name, const std::string& value) {
    target = read(name, value);
  };
}

/// In the order of the command line; -h is --help. False if --help or --version ended it. Throws
/// UsageError. Call it once: getopt keeps state.
bool parseCommandLine(int argc, char** argv, const std::vector<Option>& options,
                      const std::function<void(const std::string&)>& take_argument);

}  // namespace link_bounds
