// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions that fill a status of /diagnostics.
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <string>

#include "world/log/log_text.h"

namespace link_bounds {

/// Text after the number of errors.
constexpr char kUnexpectedErrors[] =
    " unexpected errors: messages may be missing; the log has their text, please report it";

/// Raises the level if `level` is worse, and appends the sentence.
inline void raise(diagnostic_msgs::DiagnosticStatus& status, std::int8_t level,
                  const std::string& text) {
  status.level = std::max<std::int8_t>(status.level, level);
  status.message += (status.message.empty() ? "" : "; ") + text;
}

inline void add(diagnostic_msgs::DiagnosticStatus& status, const std::string& key,
                const std::string& value) {
  diagnostic_msgs::KeyValue& pair = status.values.emplace_back();
  pair.key = logText(key);
  pair.value = logText(value);
}

}  // namespace link_bounds
