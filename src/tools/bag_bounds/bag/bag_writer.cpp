// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/bag_writer.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "tools/bag_bounds/bag/record.h"

namespace link_bounds {
namespace {

constexpr std::size_t kChunkSize = 768 << 10;   // bytes, as rosbag
constexpr std::uint32_t kBagHeaderSize = 4096;  // bytes, as rosbag
constexpr std::int64_t kNanoseconds = 1000000000;
constexpr char kVersionLine[] = "#ROSBAG V2.0\n";

template <class Number>
std::string bytesOf(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string timeBytes(std::int64_t time) {
  return bytesOf(static_cast<std::uint32_t>(time / kNanoseconds)) +
         bytesOf(static_cast<std::uint32_t>(time % kNanoseconds));
}

std::string withSize(const std::string& bytes) {
  return bytesOf(static_cast<std::uint32_t>(bytes.size())) + bytes;
}

std::string field(const std::string& name, const std::string& value) {
  return withSize(name + "=" + value);
}

// The header of a record, with its size.
std::string header(RecordOp op, const std::string& fields) {
  return withSize(field("op", bytesOf(op)) + fields);
}

std::string connectionRecord(std::uint32_t number, const BagTopic& topic) {
  std::string data = field("topic", topic.topic) + field("type", topic.type) +
                     field("md5sum", topic.md5sum) + field("message_definition", topic.definition);
  if (!topic.publisher.empty()) data += field("callerid", topic.publisher);
  if (topic.is_latched) data += field("latching", "1");
  return header(RecordOp::kConnection,
                field("conn", bytesOf(number)) + field("topic", topic.topic)) +
         withSize(data);
}

}  // namespace

BagWriter::BagWriter(const std::string& file)
    : file_name_(file), file_(std::fopen(file.c_str(), "wbe")) {
  if (!file_) throw std::runtime_error(file + ": cannot be written: " + std::strerror(errno));
  put(kVersionLine);
  writeBagHeader(0);
}

BagWriter::~BagWriter() {
  if (file_) std::fclose(file_);
}

std::uint32_t BagWriter::addTopic(const BagTopic& topic) {
  const auto number = static_cast<std::uint32_t>(connections_.size());
  connections_.push_back(connectionRecord(number, topic));
  return number;
}

void BagWriter::write(std::uint32_t topic, std::int64_t time, const std::uint8_t* data,
                      std::uint32_t size) {
  if (index_.count(topic) == 0) chunk_ += connections_.at(topic);
  index_[topic].push_back({time, static_cast<std::uint32_t>(chunk_.size())});
  chunk_ +=
      header(RecordOp::kMessage, field("conn", bytesOf(topic)) + field("time", timeBytes(time)));
  chunk_ += bytesOf(size);
  chunk_.append(reinterpret_cast<const char*>(data), size);
  if (chunk_.size() > kChunkSize) writeChunk();
}

void BagWriter::writeChunk() {
  if (index_.empty()) return;
  ChunkInfo info{position_, index_.begin()->second.front().time, 0, {}};
  put(header(RecordOp::kChunk,
             field("compression", "none") +
                 field("size", bytesOf(static_cast<std::uint32_t>(chunk_.size())))));
  put(withSize(chunk_));
  for (const auto& [topic, entries] : index_) {
    const auto count = static_cast<std::uint32_t>(entries.size());
    std::string data;
    for (const IndexEntry& entry : entries) {
      data += timeBytes(entry.time) + bytesOf(entry.offset);
      info.begin = std::min(info.begin, entry.time);
      info.end = std::max(info.end, entry.time);
    }
    info.counts[topic] = count;
    put(header(RecordOp::kIndex, field("ver", bytesOf(std::uint32_t{1})) +
                                     field("conn", bytesOf(topic)) +
                                     field("count", bytesOf(count))));
    put(withSize(data));
  }
  chunks_.push_back(info);
  chunk_.clear();
  index_.clear();
}

void BagWriter::writeChunkInfo(const ChunkInfo& info) {
  std::string data;
  for (const auto& [topic, count] : info.counts)
    data += bytesOf(topic) + bytesOf(count);
  put(header(RecordOp::kChunkInfo,
             field("ver", bytesOf(std::uint32_t{1})) + field("chunk_pos", bytesOf(info.position)) +
                 field("start_time", timeBytes(info.begin)) +
                 field("end_time", timeBytes(info.end)) +
                 field("count", bytesOf(static_cast<std::uint32_t>(info.counts.size())))));
  put(withSize(data));
}

// Filled up to its fixed size, without the two lengths, so that it can be written again at the end.
void BagWriter::writeBagHeader(std::uint64_t index_position) {
  const std::string bytes =
      header(RecordOp::kBagHeader,
             field("index_pos", bytesOf(index_position)) +
                 field("conn_count", bytesOf(static_cast<std::uint32_t>(connections_.size()))) +
                 field("chunk_count", bytesOf(static_cast<std::uint32_t>(chunks_.size()))));
  put(bytes + withSize(std::string(kBagHeaderSize + 4 - bytes.size(), ' ')));
}

void BagWriter::close() {
  writeChunk();
  const std::uint64_t index_position = position_;
  for (const std::string& connection : connections_)
    put(connection);
  for (const ChunkInfo& info : chunks_)
    writeChunkInfo(info);
  const bool is_at_header = std::fseek(file_, sizeof kVersionLine - 1, SEEK_SET) == 0;
  if (is_at_header) writeBagHeader(index_position);
  const bool is_closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (!is_at_header || !is_closed)
    throw std::runtime_error(file_name_ + ": cannot be written: " + std::strerror(errno));
}

void BagWriter::put(const std::string& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
    throw std::runtime_error(file_name_ + ": cannot be written: " + std::strerror(errno));
  position_ += bytes.size();
}

}  // namespace link_bounds
