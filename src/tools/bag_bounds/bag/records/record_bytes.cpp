// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/records/record_bytes.h"

namespace link_bounds {

std::string timeBytes(std::int64_t time) {
  constexpr std::int64_t kPerSecond = 1000000000;
  return bytesOf(static_cast<std::uint32_t>(time / kPerSecond)) +
         bytesOf(static_cast<std::uint32_t>(time % kPerSecond));
}

std::string withSize(const std::string& bytes) {
  return bytesOf(static_cast<std::uint32_t>(bytes.size())) + bytes;
}

std::string fieldBytes(const std::string& name, const std::string& value) {
  return withSize(name + "=" + value);
}

std::string headerBytes(RecordOp op, const std::string& fields) {
  return withSize(fieldBytes("op", bytesOf(op)) + fields);
}

std::string connectionRecord(std::uint32_t number, const BagTopic& topic) {
  std::string data = fieldBytes("topic", topic.topic) + fieldBytes("type", topic.type) +
                     fieldBytes("md5sum", topic.md5sum) +
                     fieldBytes("message_definition", topic.definition);
  if (!topic.publisher.empty()) data += fieldBytes("callerid", topic.publisher);
  if (topic.is_latched) data += fieldBytes("latching", "1");
  return headerBytes(RecordOp::kConnection,
                     fieldBytes("conn", bytesOf(number)) + fieldBytes("topic", topic.topic)) +
         withSize(data);
}

std::string messageHeader(std::uint32_t connection, std::int64_t time) {
  return headerBytes(RecordOp::kMessage,
                     fieldBytes("conn", bytesOf(connection)) + fieldBytes("time", timeBytes(time)));
}

std::string chunkHeader(const std::string& compression, std::uint32_t size) {
  return headerBytes(RecordOp::kChunk,
                     fieldBytes("compression", compression) + fieldBytes("size", bytesOf(size)));
}

std::string bagHeader(std::uint64_t index_position, std::uint32_t connections,
                      std::uint32_t chunks) {
  return headerBytes(RecordOp::kBagHeader, fieldBytes("index_pos", bytesOf(index_position)) +
                                               fieldBytes("conn_count", bytesOf(connections)) +
                                               fieldBytes("chunk_count", bytesOf(chunks)));
}

}  // namespace link_bounds
