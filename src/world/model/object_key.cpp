// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each id has exactly one spelling, so that names and keys correspond one to one.
#include "world/model/object_key.h"

#include <charconv>

namespace link_bounds {

std::string objectName(const ObjectKey& key) {
  return key.ns + '/' + (key.name.empty() ? std::to_string(key.id) : key.name);
}

std::string neighbourName(const std::string& node, const std::string& box) {
  return (node.empty() || node.front() != '/' ? "/" : "") + node + '/' + box;
}

bool isNeighbourName(const std::string& name) {
  return !name.empty() && name.front() == '/' && name.find('/', 1) != std::string::npos;
}

std::optional<ObjectKey> parseObjectName(const std::string& name) {
  const std::size_t slash = name.rfind('/');
  if (slash == std::string::npos) return std::nullopt;
  ObjectKey key;
  key.ns = name.substr(0, slash);
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + slash + 1, end, key.id);
  // "a/01" and "a/-0" are not names.
  if (error == std::errc() && rest == end && objectName(key) == name) return key;
  if (!isNeighbourName(name)) return std::nullopt;
  const std::size_t last = name.rfind('/', name.size() - 2);  // a name may end with a slash
  return ObjectKey{name.substr(0, last), 0, name.substr(last + 1)};
}

}  // namespace link_bounds
