// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sanitises text from outside, such as names, paths and reasons, for a log.
#pragma once

#include <string>

namespace link_bounds {

/// One line of valid UTF-8 of at most 605 bytes. Characters that could break the line, move the
/// cursor or change the writing direction become '?'. The middle of a longer text is cut, because
/// the remedy is at the end. All text from messages, parameters and files passes through this
/// before it gets into a log, /diagnostics or the answer of ~reload.
std::string logText(const std::string& text);

}  // namespace link_bounds
