// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A check for each format that assimp misreads without a word. All throw MeshError.
#pragma once

#include "robot/worker/mesh_text.h"

namespace link_bounds {

/// Of a text; those of real files take less than 1 KiB.
constexpr std::size_t kMaxHeaderLine = 1 << 16;

// Line by line: numbers that are read to a part, lines that are left out.
void checkStl(Lines& lines);
void checkObj(Lines& lines);
void checkAc3d(Lines& lines);
void checkAse(Lines& lines);
void checkDxf(Lines& lines);
void checkRaw(Lines& lines);

// By the counts of the header.
void checkPly(Lines& lines);
void checkOff(Lines& lines);

// As a tree.
void checkCollada(Lines& lines);
void checkGltf(Lines& lines);

}  // namespace link_bounds
