// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The messages of urdf_bounds on standard error.
#pragma once

#include <string>

#include "link_bounds/robot/mesh/mesh_store.h"

namespace link_bounds {

/// One line, even if the text contains line breaks.
void say(const std::string& text);

void warn(const std::string& text);

/// A bar that erases itself at the end; null if standard error is no terminal.
LoadProgress progressBar();

}  // namespace link_bounds
