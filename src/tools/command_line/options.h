// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses command lines with getopt_long.
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

/// Returns `text`. Throws UsageError if it is empty.
std::string nonEmpty(const std::string& option_name, const std::string& text);

/// std::nullopt unless the whole text is one finite number.
std::optional<double> toNumber(const std::string& text);

/// Reads a number >= 0; `unit` is for the message of the UsageError that it throws.
double limitOption(const std::string& option_name, const std::string& text,
                   const std::string& unit = "metres");

/// Max of jobsOption(): more threads than any machine has.
constexpr unsigned kMaxJobs = 1024;

/// A number of threads or processes, 1 to kMaxJobs. Throws UsageError.
unsigned jobsOption(const std::string& option_name, const std::string& text);

/// The value called `name`. Throws UsageError with all names if there is none of that name.
template <class Value>
Value chosen(const std::string& option_name, const std::string& name,
             const std::map<std::string, Value>& choices) {
  const auto found = choices.find(name);
  if (found != choices.end()) return found->second;
  throw UsageError(option_name + " is \"" + name + "\", but must be one of: " +
                   joined(choices, ", ", [](const auto& choice) { return choice.first; }));
}

/// Reads "visual", "collision" or "both". Throws UsageError for any other text.
std::string geometryOption(const std::string& option_name, const std::string& text);

struct Option {
  /// Gets the name with its dashes, and the value.
  using Take = std::function<void(const std::string& name, const std::string& value)>;

  const char* name;  ///< without dashes
  Take take;
  bool has_value = true;
  bool is_repeatable = false;  ///< an option without a value may always be repeated
};

/// An option without a value, which sets the target to true.
Option flag(const char* name, bool& target);

/// An option with a value that may be given several times.
Option repeatable(const char* name, Option::Take take);

/// Sets the target to read(name, value).
template <class Target, class Read>
Option::Take into(Target& target, Read read) {
  return [&target, read](const std::string& name, const std::string& value) {
    target = read(name, value);
  };
}

/// Calls the options and `take_argument` in the order of the command line; -h is --help. Returns
/// false if --help or --version ended it. Throws UsageError. Call it once: getopt keeps state.
bool parseCommandLine(int argc, char** argv, const std::vector<Option>& options,
                      const std::function<void(const std::string&)>& take_argument);

}  // namespace link_bounds
