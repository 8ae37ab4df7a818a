// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Text files that the command line names.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/command_line/options.h"

namespace link_bounds {

/// The text of a file or of standard input ("-"), without a byte order mark. `what` it must be,
/// such as "a URDF". Throws UsageError with the reason.
std::string readText(const std::string& file, const std::string& what);

/// An error about what the file says.
UsageError faultIn(const std::string& file, const std::exception& fault);

/// Refuses to overwrite what is read: throws UsageError if `output` is one of these files. Empty
/// names stand for none, "-" for standard input. One file may have several names: links, and paths
/// that begin elsewhere.
void checkOutput(const std::string& option_name, const std::string& output,
                 const std::vector<std::string>& inputs);

/// Whether two outputs are one file, which need not exist yet.
bool isSameFile(const std::string& a, const std::string& b);

/// Each input is a word for it, and its file. Throws UsageError if more than one file is standard
/// input, which can be read only once.
void checkStandardInput(const std::vector<std::pair<std::string, std::string>>& inputs);

/// Where relative names in that file start.
std::string folderOf(const std::string& file);

}  // namespace link_bounds
