// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The length of a vector, the same to the bit on every machine.
#pragma once

namespace link_bounds {

/// sqrt(x^2 + y^2 + z^2) with a relative error of at most 3 unit roundoffs, for numbers of any
/// magnitude. Uses only operations whose results IEEE 754 defines to the last bit; std::hypot and
/// Eigen's stableNorm() differ by an ulp between machines.
double length(double x, double y, double z = 0);

}  // namespace link_bounds
