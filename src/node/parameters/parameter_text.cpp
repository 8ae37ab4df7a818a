// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Values in the notation of YAML.
#include "node/parameters/parameter_text.h"

#include <sstream>

namespace link_bounds {

std::string valueText(const std::string& value) {
  return '"' + value + '"';
}

std::string valueText(bool value) {
  return value ? "true" : "false";
}

std::string valueText(int value) {
  return std::to_string(value);
}

std::string valueText(double value) {
  std::ostringstream stream;
  stream << value;
  const std::string text = stream.str();
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

}  // namespace link_bounds
