// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bags made of a list of messages, as files and as bytes.
#pragma once

#include <bzlib.h>
#include <lz4frame.h>
#include <ros/serialization.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "testing/message_bytes.h"
#include "tools/bag_bounds/bag/bag_reader.h"
#include "tools/bag_bounds/bag/bag_writer.h"
#include "tools/bag_bounds/bag/records/record_bytes.h"

namespace link_bounds {

struct RecordedMessage {
  std::string topic;
  std::int64_t time;  ///< [ns]
  std::string data;   ///< serialised
  std::string type = "std_msgs/String";
  std::string publisher = "/recorded";
};

inline bool operator==(const RecordedMessage& a, const RecordedMessage& b) {
  return a.topic == b.topic && a.time == b.time && a.data == b.data && a.type == b.type &&
         a.publisher == b.publisher;
}

/// A message of ROS, recorded at `time` [ns].
template <class Message>
RecordedMessage recorded(const std::string& topic, std::int64_t time, const Message& message) {
  const std::vector<std::uint8_t> bytes = messageBytes(message);
  return {topic, time, {bytes.begin(), bytes.end()}, ros::message_traits::datatype(message)};
}

/// The number of a message's connection: one for each topic with its publisher.
class ConnectionNumbers {
 public:
  using Key = std::pair<std::string, std::string>;

  /// Calls on_new(number, topic) for the first message of a connection.
  std::uint32_t numberOf(const RecordedMessage& message,
                         const std::function<void(std::uint32_t, const BagTopic&)>& on_new) {
    const auto next = static_cast<std::uint32_t>(numbers_.size());
    const auto [entry, is_new] = numbers_.emplace(Key(message.topic, message.publisher), next);
    if (is_new) on_new(next, {message.topic, message.type, "*", "", message.publisher});
    return entry->second;
  }

 private:
  std::map<Key, std::uint32_t> numbers_;
};

inline void writeBag(const std::string& file, const std::vector<RecordedMessage>& messages) {
  BagWriter writer(file);
  ConnectionNumbers connections;
  for (const RecordedMessage& message : messages) {
    const std::uint32_t number = connections.numberOf(
        message, [&writer](std::uint32_t, const BagTopic& topic) { writer.addTopic(topic); });
    writer.write(number, message.time, reinterpret_cast<const std::uint8_t*>(message.data.data()),
                 static_cast<std::uint32_t>(message.data.size()));
  }
  writer.close();
}

inline std::string compressed(const std::string& compression, std::string data) {
  if (compression == "none") return data;
  std::string result(data.size() * 2 + 1000, '\0');
  if (compression == "bz2") {
    auto size = static_cast<unsigned>(result.size());
    BZ2_bzBuffToBuffCompress(&result[0], &size, &data[0], static_cast<unsigned>(data.size()), 9, 0,
                             30);
    return result.substr(0, size);
  }
  LZ4F_preferences_t preferences{};  // as roslz4
  preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
  preferences.frameInfo.blockMode = LZ4F_blockIndependent;
  return result.substr(
      0, LZ4F_compressFrame(&result[0], result.size(), data.data(), data.size(), &preferences));
}

/// A chunk whose data are these records.
inline std::string chunkRecord(const std::string& compression, const std::string& records) {
  return chunkHeader(compression, static_cast<std::uint32_t>(records.size())) +
         withSize(compressed(compression, records));
}

/// Where things are in the bytes of a bag.
struct BagBytes {
  std::string bytes;
  std::vector<std::uint64_t> chunks;        ///< where they begin
  std::vector<std::uint64_t> message_ends;  ///< only if not compressed
  std::uint64_t index = 0;                  ///< where it begins
};

/// A complete bag, with `per_chunk` messages in a chunk. Its header is not filled up, so that it is
/// small. Index records of the chunks have no data.
inline BagBytes bagOf(const std::vector<RecordedMessage>& messages,
                      const std::string& compression = "none", std::size_t per_chunk = 3) {
  const std::string version = kBagVersionLine;
  BagBytes bag;
  ConnectionNumbers connections;
  std::string index;
  std::string chunk_info;
  bag.bytes = version + bagHeader(0, 0, 0) + withSize("");
  for (std::size_t begin = 0; begin < messages.size(); begin += per_chunk) {
    std::string records;
    std::vector<std::uint64_t> ends;
    for (std::size_t i = begin; i < std::min(begin + per_chunk, messages.size()); ++i) {
      const std::uint32_t number =
          connections.numberOf(messages[i], [&](std::uint32_t next, const BagTopic& topic) {
            records += connectionRecord(next, topic);
            index += connectionRecord(next, topic);
          });
      records += messageHeader(number, messages[i].time) + withSize(messages[i].data);
      ends.push_back(records.size());
    }
    bag.chunks.push_back(bag.bytes.size());
    const std::string chunk = chunkRecord(compression, records);
    if (compression == "none")
      for (const std::uint64_t end : ends)
        bag.message_ends.push_back(bag.bytes.size() + chunk.size() - records.size() + end);
    const std::string numbers = fieldBytes("ver", bytesOf(std::uint32_t{1})) +
                                fieldBytes("count", bytesOf(std::uint32_t{0}));
    bag.bytes += chunk + headerBytes(RecordOp::kIndex, numbers + fieldBytes("conn", bytesOf(0U))) +
                 withSize("");
    chunk_info += headerBytes(RecordOp::kChunkInfo, numbers) + withSize("");
  }
  bag.index = bag.bytes.size();
  bag.bytes += index + chunk_info;
  const std::string header =
      version + bagHeader(bag.index, 1, static_cast<std::uint32_t>(bag.chunks.size()));
  bag.bytes.replace(0, header.size(), header);
  return bag;
}

/// All that the reader gives.
inline std::vector<RecordedMessage> readAll(BagReader& reader) {
  std::vector<RecordedMessage> messages;
  for (BagMessage next; reader.next(next);)
    messages.push_back({*next.topic, next.time,
                        std::string(reinterpret_cast<const char*>(next.data), next.size),
                        *next.type, *next.publisher});
  return messages;
}

}  // namespace link_bounds
