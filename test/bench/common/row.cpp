// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Of what JSON escapes, texts may hold quotes and backslashes.
#include "bench/common/row.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace link_bounds::bench {
namespace {

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string threeDigits(double value) {
  const double size = std::abs(value);
  return fixed(value, size < 0.9995 ? 3 : size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}

/// With a point, so that a program reads it as a number that need not be whole.
std::string jsonNumber(double value) {
  std::ostringstream text;
  text << std::setprecision(9) << value;
  const bool is_whole = text.str().find_first_of(".e") == std::string::npos;
  return text.str() + (is_whole ? ".0" : "");
}

std::string quoted(const std::string& text) {
  std::ostringstream result;
  result << std::quoted(text);
  return result.str();
}

}  // namespace

Value::Value(double number) {
  if (std::isfinite(number)) value_ = number;
}

Value::Value(std::optional<bool> truth) {
  if (truth) value_ = *truth;
}

std::string Value::json() const {
  if (const auto* text = std::get_if<std::string>(&value_)) return quoted(*text);
  if (const auto* truth = std::get_if<bool>(&value_)) return *truth ? "true" : "false";
  if (const auto* count = std::get_if<std::int64_t>(&value_)) return std::to_string(*count);
  if (const auto* number = std::get_if<double>(&value_)) return jsonNumber(*number);
  return "null";
}

std::string Value::text() const {
  if (const auto* text = std::get_if<std::string>(&value_)) return *text;
  if (const auto* truth = std::get_if<bool>(&value_)) return *truth ? "yes" : "no";
  if (const auto* number = std::get_if<double>(&value_)) return threeDigits(*number);
  return std::holds_alternative<std::monostate>(value_) ? "-" : json();
}

double Value::number() const {
  if (const auto* truth = std::get_if<bool>(&value_)) return *truth;
  if (const auto* count = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*count);
  const auto* number = std::get_if<double>(&value_);
  return number ? *number : std::nan("");
}

Value valueOf(const Row& row, const std::string& name) {
  const auto found =
      std::find_if(row.begin(), row.end(), [&](const auto& entry) { return entry.first == name; });
  return found == row.end() ? Value() : found->second;
}

std::vector<double> numbersOf(const Rows& rows, const Row& values, const std::string& name) {
  std::vector<double> result;
  for (const Row& row : rows) {
    const bool is_meant = std::all_of(values.begin(), values.end(), [&row](const auto& value) {
      return valueOf(row, value.first) == value.second;
    });
    const double number = is_meant ? valueOf(row, name).number() : std::nan("");
    if (!std::isnan(number)) result.push_back(number);
  }
  return result;
}

Rows pivot(const Rows& rows, const std::vector<std::string>& keys, const std::string& name,
           const std::string& value) {
  Rows result;
  for (const Row& row : rows) {
    const auto found = std::find_if(result.begin(), result.end(), [&](const Row& other) {
      return std::all_of(keys.begin(), keys.end(), [&](const std::string& key) {
        return valueOf(row, key) == valueOf(other, key);
      });
    });
    Row& whole = found == result.end() ? result.emplace_back() : *found;
    for (std::size_t i = whole.size(); i < keys.size(); ++i)
      whole.emplace_back(keys[i], valueOf(row, keys[i]));
    whole.emplace_back(valueOf(row, name).text(), valueOf(row, value));
  }
  return result;
}

void writeJson(const Rows& rows, std::ostream& out) {
  const char* row_separator = "[\n{";
  for (const Row& row : rows) {
    const char* separator = row_separator;
    for (const auto& [name, value] : row) {
      out << separator << quoted(name) << ": " << value.json();
      separator = ", ";
    }
    row_separator = "},\n{";
  }
  out << (rows.empty() ? "[]\n" : "}\n]\n");
}

}  // namespace link_bounds::bench
