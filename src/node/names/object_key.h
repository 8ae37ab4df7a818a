// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The identity of an object: namespace and id of its marker.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

namespace link_bounds {

/// Sorted by namespace, then by id.
struct ObjectKey {
  std::string ns;
  std::int32_t id = 0;

  bool operator<(const ObjectKey& other) const {
    return std::tie(ns, id) < std::tie(other.ns, other.id);
  }
  bool operator==(const ObjectKey& other) const { return ns == other.ns && id == other.id; }
};

/// "<ns>/<id>", the name of the object's box.
std::string objectName(const ObjectKey& key);

/// The inverse; nothing if `name` is not of that form. A namespace may contain slashes.
std::optional<ObjectKey> parseObjectName(const std::string& name);

}  // namespace link_bounds
