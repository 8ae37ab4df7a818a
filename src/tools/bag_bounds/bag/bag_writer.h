// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes a bag of version 2.0 that rosbag and rviz play.
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tools/bag_bounds/bag/records/record_bytes.h"

namespace link_bounds {

/// Unlike rosbag's own writer, keeps an index entry per chunk in memory, not per message: ten hours
/// of 100 messages per second, 5 kB each, take 3 MB.
class BagWriter {
 public:
  /// Replaces a file of that name. All functions throw std::runtime_error where writing fails.
  explicit BagWriter(const std::string& file);
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// Returns the number of the topic for write(). Call it once for each topic and publisher.
  std::uint32_t addTopic(const BagTopic& topic);

  /// Writes a serialised message, recorded at `time` [ns], 0 <= time < 2^32 s.
  void write(std::uint32_t topic, std::int64_t time, const std::uint8_t* data, std::uint32_t size);

  /// Writes the index, without which the file counts as one that was cut.
  void close();

 private:
  struct IndexEntry {
    std::int64_t time;
    std::uint32_t offset;  ///< of the record in the chunk
  };
  struct ChunkInfo {
    std::uint64_t position;
    std::int64_t begin;
    std::int64_t end;
    std::map<std::uint32_t, std::uint32_t> counts;  ///< messages of each topic
  };

  void writeBagHeader(std::uint64_t index_position);
  void writeChunk();
  void writeChunkInfo(const ChunkInfo& info);
  void put(const std::string& bytes);
  [[noreturn]] void fail();

  std::string file_name_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t position_ = 0;
  std::vector<std::string> connections_;  ///< the record of each topic
  std::string chunk_;                     ///< records of the chunk that is being filled
  std::map<std::uint32_t, std::vector<IndexEntry>> index_;  ///< of that chunk
  std::vector<ChunkInfo> chunks_;
};

}  // namespace link_bounds
