// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads YAML files of one document. Several documents are refused, because only one would be used.
#pragma once

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tools/command_line/options.h"

namespace link_bounds {

/// Throws UsageError if there are several documents, YAML::Exception if it is no YAML.
inline YAML::Node onlyDocument(const std::string& text, const std::string& file) {
  std::vector<YAML::Node> documents = YAML::LoadAll(text);
  const auto is_empty = [](const YAML::Node& document) { return document.IsNull(); };
  documents.erase(std::remove_if(documents.begin(), documents.end(), is_empty), documents.end());
  if (documents.size() > 1)
    throw UsageError(file + " has " + std::to_string(documents.size()) +
                     " documents of YAML; write one, without lines of ---");
  return documents.empty() ? YAML::Node() : documents.front();
}

/// The result of Reader(file).read(document). Throws UsageError if the text is no YAML.
template <class Reader>
auto readYaml(const std::string& text, const std::string& file) {
  try {
    return Reader(file).read(onlyDocument(text, file));
  } catch (const YAML::Exception& error) {
    throw UsageError(file + " is no YAML: " + error.what() + "; correct it");
  }
}

/// The text of a scalar node; "" if the node does not exist, or is a list or a map.
inline std::string scalar(const YAML::Node& node) {
  return node && node.IsScalar() ? node.Scalar() : "";
}

}  // namespace link_bounds
