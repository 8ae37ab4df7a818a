// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Text between C++ and Python, warnings, and the exceptions of the module.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace link_bounds {

/// Bytes that are no UTF-8 become surrogates, as in the names of files.
pybind11::str toPython(const std::string& text);

/// The text of a file. `what` names the expected content in messages, such as "a URDF". Throws
/// UsageError with the reason.
std::string textOfFile(const std::string& file, const std::string& what);

/// Emits a RuntimeWarning at the line of the caller. Throws where Python makes it an exception.
void warnInPython(const std::string& text);

/// Sets the exception in Python for `error`. Rethrows exceptions of other types.
void translate(std::exception_ptr error, const pybind11::handle& robot_error);

}  // namespace link_bounds
