// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Text files that the command line names.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/command_line/options.h"

namespace link_bounds {

/// The text of a file or of standard input ("-"), without a byte order mark. `what` names the
/// expected content in messages, such as "a URDF". Throws UsageError with the reason.
std::string readText(const std::string& file, const std::string& what);

/// An error in the content of a file; the message begins with the name of the file.
UsageError faultIn(const std::string& file, const std::exception& fault);

/// Throws UsageError if `output` is one of `inputs`, also by a link or another path, so that no
/// input is overwritten. An empty name stands for no file, "-" for standard input.
void checkOutput(const std::string& option_name, const std::string& output,
                 const std::vector<std::string>& inputs);

/// Whether two outputs are one file, which need not exist yet.
bool isSameFile(const std::string& a, const std::string& b);

/// Each input is a pair of a name for messages and a file. Throws UsageError if more than one file
/// is standard input ("-"), which can be read only once.
void checkStandardInput(const std::vector<std::pair<std::string, std::string>>& inputs);

/// The folder of `file`, where relative names in it start.
std::string folderOf(const std::string& file);

}  // namespace link_bounds
