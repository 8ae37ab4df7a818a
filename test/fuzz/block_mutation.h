// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Damage that does not depend on the format of a file.
#pragma once

#include <string>

#include "testing/brute_force.h"

namespace link_bounds {

/// In [0, count); 0 if count is 0.
std::size_t below(std::size_t count, brute_force::Random& random);

/// Changes one byte or a few.
std::string hitBytes(std::string text, brute_force::Random& random);

std::string cutShort(std::string text, brute_force::Random& random);

/// Inserts a copy of a block after it or anywhere.
std::string duplicateBlock(std::string text, brute_force::Random& random);

std::string deleteBlock(std::string text, brute_force::Random& random);

}  // namespace link_bounds
