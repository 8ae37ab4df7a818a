// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/loading/reloaded_text.h"

#include <algorithm>

#include "world/log/log_text.h"

namespace link_bounds {
namespace {

constexpr std::size_t kMaxAnsweredWarnings = 4;  // the answer of ~reload is one line

}  // namespace

std::string reloadedText(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return "reloaded";
  std::string text = "reloaded, with " + std::to_string(warnings.size()) + " warning" +
                     (warnings.size() > 1 ? "s" : "");
  for (std::size_t i = 0; i < std::min(warnings.size(), kMaxAnsweredWarnings); ++i)
    text += (i == 0 ? ": " : "; ") + warnings[i];
  return logText(text + (warnings.size() > kMaxAnsweredWarnings ? "; see the log for all" : ""));
}

}  // namespace link_bounds
