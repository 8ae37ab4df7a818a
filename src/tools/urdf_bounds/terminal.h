// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What urdf_bounds says on standard error.
#pragma once

#include <string>

#include "link_bounds/robot/mesh/mesh_store.h"

namespace link_bounds {

/// One line, whatever the text holds.
void say(const std::string& text);

void warn(const std::string& text);

/// A bar that wipes itself out when all is done; null if standard error is no terminal.
LoadProgress progressBar();

}  // namespace link_bounds
