// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The exception for parameters.
#pragma once

#include <stdexcept>

namespace link_bounds {

/// A parameter cannot be used. The message names it and says what it must be.
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace link_bounds
