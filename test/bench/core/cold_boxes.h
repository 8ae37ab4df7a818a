// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of single meshes when other programs have used the caches.
#pragma once

#include <string>

#include "bench/common/suite.h"

namespace link_bounds::bench {

/// What a method of a cold run is called when the same method has just made the box of another
/// mesh: its code is in the caches again, the mesh's memory is not.
std::string withWarmCode(const std::string& method);

/// Measures each case `rounds` times in random order, and that twice: on empty caches, and as
/// withWarmCode() describes.
Results runCold(const Suite& suite, int rounds);

/// Medians over the robot meshes by method, and the target.
void printCold(const Results& results, const std::string& ours);

}  // namespace link_bounds::bench
