// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sanitises text from outside, such as names, paths and reasons, for a log.
#pragma once

#include <string>

namespace link_bounds {

/// One line of valid UTF-8 of at most 605 bytes. Characters that could break the line, move the
/// cursor or change the writing direction become '?'. A longer text loses its middle, because the
/// remedy is at its end. What is logged of messages, parameters and files goes through this, and so
/// do /diagnostics and the answer of ~reload.
std::string logText(const std::string& text);

}  // namespace link_bounds
