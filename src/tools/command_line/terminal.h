// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages and progress bars on standard error; the end of standard output.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "link_bounds/robot/mesh/mesh_store.h"

namespace link_bounds {

/// Writes the name of the program and the text as one line, even if the text has line breaks.
void say(const std::string& text);

void warn(const std::string& text);

/// Draws a progress bar over the current line. `done` <= `total`, and `total` > 0. `unit` follows
/// the numbers.
void drawBar(std::size_t done, std::size_t total, const std::string& unit);

void eraseBar();

bool hasTerminal();

/// A progress bar of meshes that erases itself at the end; null if standard error is no terminal.
LoadProgress progressBar();

/// Runs a program and returns its exit code; kUnusable with the reason on standard error if it
/// throws.
int runProgram(const std::function<int()>& program);

/// Flushes standard output. False, with a message, on a full disk or a closed pipe.
bool finishOutput();

}  // namespace link_bounds
