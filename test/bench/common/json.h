// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The results for programs.
#pragma once

#include <iosfwd>

#include "bench/common/result.h"

namespace link_bounds::bench {

/// An array with one object per result; what is not known or was not compared is null.
void writeJson(const Results& results, std::ostream& out);

}  // namespace link_bounds::bench
