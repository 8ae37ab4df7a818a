// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The connections of a bag: a topic and a publisher each.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>

#include "tools/bag_bounds/bag/records/bytes.h"
#include "tools/bag_bounds/bag/records/record.h"

namespace link_bounds {

struct Connection {
  std::string topic;
  std::string type;
  std::string publisher;
  bool is_wanted;
};

class Connections {
 public:
  /// `topics` are the wanted ones; all topics are wanted if it is empty. It must outlive this.
  explicit Connections(const std::set<std::string>& topics) : topics_(topics) {}

  /// Null if it has not been announced.
  const Connection* find(std::uint32_t number) const;

  /// Adds the connection of a record. A number that is announced again is the same connection.
  /// False if the record is damaged, or if all connections together would be too large.
  bool add(Bytes& bytes, const Record& record);

 private:
  const std::set<std::string>& topics_;
  std::unordered_map<std::uint32_t, Connection> connections_;
  std::size_t size_ = 0;  ///< bytes
};

}  // namespace link_bounds
