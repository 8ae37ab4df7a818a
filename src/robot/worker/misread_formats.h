// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A check for each format that assimp misreads without a message. All throw MeshError.
#pragma once

#include "robot/worker/mesh_text.h"

namespace link_bounds {

/// Max bytes of a line of a header in text; lines of real files take less than 1 KiB.
constexpr std::size_t kMaxHeaderLine = 1 << 16;

// Checked line by line: numbers that are read only in part, lines that are left out.
void checkStl(Lines& lines);
void checkObj(Lines& lines);

// Checked by the counts in the header.
void checkPly(Lines& lines);
void checkOff(Lines& lines);

// Checked as a tree of elements.
void checkCollada(Lines& lines);
void checkGltf(Lines& lines);

}  // namespace link_bounds
