// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Damage as by transmission, editors or attackers; equal random numbers give equal damage.
#pragma once

#include <string>

#include "mesh_seeds.h"
#include "testing/brute_force.h"

namespace link_bounds {

/// One change of a text: bytes, swapped words, swapped or odd numbers, a cut, a lost or repeated
/// block.
std::string mutatedText(const std::string& text, brute_force::Random& random);

/// One change of a binary file: bytes, swapped or odd words of four bytes, a cut, a lost or
/// repeated block.
std::string mutatedBytes(const std::string& bytes, brute_force::Random& random);

/// One or two changes.
std::string mutated(const MeshSeed& seed, brute_force::Random& random);

}  // namespace link_bounds
