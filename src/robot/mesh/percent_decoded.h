// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Decodes names of files in URIs.
#pragma once

#include <string>

namespace link_bounds {

/// Replaces %XX by the byte that it stands for. Keeps a percent sign that is not followed by two
/// hexadecimal digits.
std::string percentDecoded(const std::string& text);

}  // namespace link_bounds
