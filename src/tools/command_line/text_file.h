// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Text files that the command line names.
#pragma once

#include <string>

namespace link_bounds {

/// The text of a file or of standard input ("-"). `what` it must be, such as "a URDF". Throws
/// UsageError with the reason.
std::string readText(const std::string& file, const std::string& what);

/// Where relative names in that file start.
std::string folderOf(const std::string& file);

}  // namespace link_bounds
