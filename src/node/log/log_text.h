// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Text from outside - names, paths, reasons - made fit for a log.
#pragma once

#include <string>

namespace link_bounds {

/// One line of valid UTF-8 of limited length. Bytes that could break the line, move the cursor or
/// turn the direction of writing become '?'; of a long text the middle is left out, for the remedy
/// is at its end. Whatever is logged goes through this, as do diagnostics and ~reload's answer.
std::string logText(const std::string& text);

}  // namespace link_bounds
