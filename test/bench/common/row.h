// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a benchmark has measured: rows of named values, for tables and for programs.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace link_bounds::bench {

/// A text, a number, a truth, or nothing.
class Value {
 public:
  Value() = default;
  Value(const char* text) : value_(std::string(text)) {}
  Value(std::string text) : value_(std::move(text)) {}
  Value(int number) : value_(std::int64_t{number}) {}
  Value(std::size_t number) : value_(static_cast<std::int64_t>(number)) {}
  Value(double number);  ///< what is not finite is nothing
  Value(std::optional<bool> truth);

  std::string json() const;

  /// For people, with three digits or more.
  std::string text() const;

  /// A truth is 0 or 1; what is no number is not a number.
  double number() const;

  bool operator==(const Value& other) const { return value_ == other.value_; }

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string> value_;
};

using Row = std::vector<std::pair<std::string, Value>>;
using Rows = std::vector<Row>;

/// Nothing if the row lacks it.
Value valueOf(const Row& row, const std::string& name);

/// The numbers of that name in the rows that have all these values.
std::vector<double> numbersOf(const Rows& rows, const Row& values, const std::string& name);

/// Rows that differ only in `name` and `value` become one, in which each `name` has its `value`;
/// other values than those of `keys` are left out.
Rows pivot(const Rows& rows, const std::vector<std::string>& keys, const std::string& name,
           const std::string& value);

/// An array with one object per row; nothing is null.
void writeJson(const Rows& rows, std::ostream& out);

}  // namespace link_bounds::bench
