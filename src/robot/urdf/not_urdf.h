// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Tells why a text is no URDF.
#pragma once

#include <string>

namespace link_bounds {

/// Why the text cannot be a URDF, with the remedy: it is the name of a file, a xacro file, broken
/// XML, or has another root element. "" if none of these is so.
std::string whyNoUrdf(const std::string& text);

/// A warning about a second <robot>, of which nothing is read; "" if there is none.
std::string secondRobotWarning(const std::string& text);

/// A warning about elements that only xacro understands; "" if there are none.
std::string xacroWarning(const std::string& text);

}  // namespace link_bounds
