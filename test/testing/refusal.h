// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The text of the error by which a call refuses its arguments.
#pragma once

#include <string>

namespace link_bounds {

/// "" if the call throws nothing. Errors that are no `Error` are not caught.
template <class Error, class Call>
std::string refusalOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace link_bounds
