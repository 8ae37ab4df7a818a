// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The identity of an object: namespace and id of its marker, or where a neighbour's box has its
// name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

namespace link_bounds {

/// Sorted by namespace, then by id, then by name.
struct ObjectKey {
  std::string ns;
  std::int32_t id = 0;
  std::string name = {};  ///< instead of an id, which is 0 then

  bool operator<(const ObjectKey& other) const {
    return std::tie(ns, id, name) < std::tie(other.ns, other.id, other.name);
  }
  bool operator==(const ObjectKey& other) const {
    return ns == other.ns && id == other.id && name == other.name;
  }
};

/// "<ns>/<id>" or "<ns>/<name>", the name of the object's box.
std::string objectName(const ObjectKey& key);

/// The inverse; nothing if `name` is not of that form. A namespace may contain slashes. Where there
/// is a name instead of an id, the namespace is that of a neighbour, which begins with a slash.
std::optional<ObjectKey> parseObjectName(const std::string& name);

/// The name that a box of another node has here: parseObjectName() always finds a key in it.
std::string neighbourName(const std::string& node, const std::string& box);

/// True for names as neighbourName() makes them.
bool isNeighbourName(const std::string& name);

}  // namespace link_bounds
