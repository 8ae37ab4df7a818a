// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a bag says about its connections: a topic and a publisher each.
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
  /// Messages of these topics are wanted; of all if there are none. They must outlive this.
  explicit Connections(const std::set<std::string>& topics) : topics_(topics) {}

  /// Null if it has not been announced.
  const Connection* find(std::uint32_t number) const;

  /// Takes the record of a connection. Where a number is announced again, it is the same one. False
  /// if the record is damaged.
  bool add(Bytes& bytes, const Record& record);

 private:
  const std::set<std::string>& topics_;
  std::unordered_map<std::uint32_t, Connection> connections_;
  std::size_t size_ = 0;  ///< bytes
};

}  // namespace link_bounds
