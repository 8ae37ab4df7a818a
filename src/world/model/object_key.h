// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The identity of an object: namespace and id of its marker, or the corresponding parts of the name
// of a neighbour's box.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

namespace link_bounds {

/// Sorted by namespace, id, name, then set. Objects with the same name differ only in the set.
struct ObjectKey {
  std::string ns;
  std::int32_t id = 0;
  std::string name = {};  ///< used instead of `id`, which is then 0
  std::uint64_t set = 0;  ///< number of a set of a neighbour's boxes; 0: a marker

  bool operator<(const ObjectKey& other) const {
    return std::tie(ns, id, name, set) < std::tie(other.ns, other.id, other.name, other.set);
  }
  bool operator==(const ObjectKey& other) const {
    return std::tie(ns, id, name, set) == std::tie(other.ns, other.id, other.name, other.set);
  }
};

/// "<ns>/<id>" or "<ns>/<name>", the name of the object's box.
std::string objectName(const ObjectKey& key);

/// Inverse of objectName(), with set 0; nothing if `name` is not of that form. A namespace may
/// contain slashes. If there is a name instead of an id, the namespace is that of a neighbour,
/// which begins with a slash.
std::optional<ObjectKey> parseObjectName(const std::string& name);

/// The name that a box of another node has here. parseObjectName() always accepts it.
std::string neighbourName(const std::string& node, const std::string& box);

/// True for names of the form that neighbourName() makes.
bool isNeighbourName(const std::string& name);

}  // namespace link_bounds
