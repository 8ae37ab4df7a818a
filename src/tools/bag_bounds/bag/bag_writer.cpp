// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/bag_writer.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace link_bounds {
namespace {

constexpr std::size_t kChunkSize = 768 << 10;   // bytes, as rosbag
constexpr std::uint32_t kBagHeaderSize = 4096;  // bytes, as rosbag
template <class Things>
std::uint32_t countOf(const Things& things) {
  return static_cast<std::uint32_t>(things.size());
}

}  // namespace

BagWriter::BagWriter(const std::string& file)
    : file_name_(file), file_(std::fopen(file.c_str(), "wbe"), std::fclose) {
  if (!file_) fail();
  put(kBagVersionLine);
  writeBagHeader(0);
}

std::uint32_t BagWriter::addTopic(const BagTopic& topic) {
  const std::uint32_t number = countOf(connections_);
  connections_.push_back(connectionRecord(number, topic));
  return number;
}

void BagWriter::write(std::uint32_t topic, std::int64_t time, const std::uint8_t* data,
                      std::uint32_t size) {
  if (index_.count(topic) == 0) chunk_ += connections_.at(topic);
  index_[topic].push_back({time, static_cast<std::uint32_t>(chunk_.size())});
  chunk_ += messageHeader(topic, time);
  chunk_ += bytesOf(size);
  chunk_.append(reinterpret_cast<const char*>(data), size);
  if (chunk_.size() > kChunkSize) writeChunk();
}

void BagWriter::writeChunk() {
  if (index_.empty()) return;
  ChunkInfo info{position_, index_.begin()->second.front().time, 0, {}};
  put(chunkHeader("none", countOf(chunk_)));
  put(withSize(chunk_));
  for (auto& [topic, entries] : index_) {
    const std::uint32_t count = countOf(entries);
    // Readers search the index for a time. After a backward jump, messages are not in that order.
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
    std::string data;
    for (const IndexEntry& entry : entries) {
      data += timeBytes(entry.time) + bytesOf(entry.offset);
      info.begin = std::min(info.begin, entry.time);
      info.end = std::max(info.end, entry.time);
    }
    info.counts[topic] = count;
    put(headerBytes(RecordOp::kIndex, fieldBytes("ver", bytesOf(std::uint32_t{1})) +
                                          fieldBytes("conn", bytesOf(topic)) +
                                          fieldBytes("count", bytesOf(count))));
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
  put(headerBytes(RecordOp::kChunkInfo, fieldBytes("ver", bytesOf(std::uint32_t{1})) +
                                            fieldBytes("chunk_pos", bytesOf(info.position)) +
                                            fieldBytes("start_time", timeBytes(info.begin)) +
                                            fieldBytes("end_time", timeBytes(info.end)) +
                                            fieldBytes("count", bytesOf(countOf(info.counts)))));
  put(withSize(data));
}

// Padded to a fixed size (without the two lengths), so that close() can overwrite the header.
void BagWriter::writeBagHeader(std::uint64_t index_position) {
  const std::string bytes = bagHeader(index_position, countOf(connections_), countOf(chunks_));
  put(bytes + withSize(std::string(kBagHeaderSize + 4 - bytes.size(), ' ')));
}

void BagWriter::close() {
  writeChunk();
  const std::uint64_t index_position = position_;
  for (const std::string& connection : connections_)
    put(connection);
  for (const ChunkInfo& info : chunks_)
    writeChunkInfo(info);
  if (std::fseek(file_.get(), sizeof kBagVersionLine - 1, SEEK_SET) != 0) fail();
  writeBagHeader(index_position);
  if (std::fclose(file_.release()) != 0) fail();
}

void BagWriter::put(const std::string& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail();
  position_ += bytes.size();
}

void BagWriter::fail() {
  throw std::runtime_error(file_name_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace link_bounds
