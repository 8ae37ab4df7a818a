// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The length of a vector, the same to the bit on every machine.
#pragma once

namespace link_bounds {

/// sqrt(x^2 + y^2 + z^2) to within 3 unit roundoffs of itself, for numbers of any magnitude.
/// std::hypot and Eigen's stableNorm() would differ by an ulp between machines; this consists of
/// operations alone that IEEE 754 defines to the last bit.
double length(double x, double y, double z = 0);

}  // namespace link_bounds
