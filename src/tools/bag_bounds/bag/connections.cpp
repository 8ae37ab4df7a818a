// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/connections.h"

#include <utility>

#include "tools/bag_bounds/bag/records/chunk.h"

namespace link_bounds {
namespace {

constexpr std::size_t kMaxSize = 16 << 20;  // bytes of all; a file may announce any number

}  // namespace

const Connection* Connections::find(std::uint32_t number) const {
  const auto found = connections_.find(number);
  return found == connections_.end() ? nullptr : &found->second;
}

bool Connections::add(Bytes& bytes, const Record& record) {
  if (connections_.count(record.connection)) return true;
  Connection connection;
  // As rosbag play: a name without a slash is one of the root namespace.
  connection.topic = (record.topic.front() == '/' ? "" : "/") + std::string(record.topic);
  connection.is_wanted = topics_.empty() || topics_.count(connection.topic);
  if (record.data_size > kMaxChunkSize) return false;
  const std::uint8_t* const data = bytes.at(record.data, record.data_size);
  ConnectionHeader header;
  if (!data || !readConnectionHeader(data, record.data_size, header)) return false;
  connection.type = header.type;
  connection.publisher = header.publisher;
  size_ += sizeof connection + connection.topic.size() + connection.type.size() +
           connection.publisher.size();
  if (size_ > kMaxSize) return false;
  connections_.emplace(record.connection, std::move(connection));
  return true;
}

}  // namespace link_bounds
