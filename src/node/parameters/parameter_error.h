// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What readers of parameters throw.
#pragma once

#include <stdexcept>

namespace link_bounds {

/// A parameter that cannot be used: which, why, and what would be right.
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace link_bounds
