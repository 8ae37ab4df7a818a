// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names are those of files and methods; of what JSON escapes they may hold quotes and backslashes.
#include "bench/common/json.h"

#include <cmath>
#include <iomanip>
#include <ostream>

namespace link_bounds::bench {
namespace {

std::string number(double value) {
  return std::isfinite(value) ? std::to_string(value) : "null";
}

std::string truth(std::optional<bool> value) {
  return !value ? "null" : *value ? "true" : "false";
}

void write(const Result& result, std::ostream& out) {
  out << "{\"mesh\": " << std::quoted(result.mesh) << ", \"kind\": " << std::quoted(result.kind)
      << ", \"vertices\": " << result.vertices << ", \"hull\": " << result.hull
      << ", \"method\": " << std::quoted(result.method) << ", \"exact\": " << truth(result.exact)
      << ", \"ns\": " << number(result.ns) << ", \"volume_ratio\": " << number(result.volume_ratio)
      << ", \"bytes\": " << (result.bytes ? std::to_string(result.bytes) : "null") << "}";
}

}  // namespace

void writeJson(const Results& results, std::ostream& out) {
  const char* separator = "[\n";
  for (const Result& result : results) {
    out << separator;
    write(result, out);
    separator = ",\n";
  }
  out << "\n]\n";
}

}  // namespace link_bounds::bench
