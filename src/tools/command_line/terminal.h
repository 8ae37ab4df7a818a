// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the programs say on standard error, and the end of standard output.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "link_bounds/robot/mesh/mesh_store.h"

namespace link_bounds {

/// One line, even if the text contains line breaks. It begins with the name of the program.
void say(const std::string& text);

void warn(const std::string& text);

/// Draws a bar over the line; `done` <= `total`, which is not 0. `unit` comes after the numbers.
void drawBar(std::size_t done, std::size_t total, const std::string& unit);

void eraseBar();

bool hasTerminal();

/// A bar that erases itself at the end; null if standard error is no terminal.
LoadProgress progressBar();

/// Runs a program and returns its exit code; kUnusable with the reason on standard error if it
/// throws.
int runProgram(const std::function<int()>& program);

/// Flushes standard output. False, with a message, on a full disk or a closed pipe.
bool finishOutput();

}  // namespace link_bounds
