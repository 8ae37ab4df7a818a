// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Records of a bag as bytes.
#pragma once

#include <cstdint>
#include <string>

#include "tools/bag_bounds/bag/records/record.h"

namespace link_bounds {

constexpr char kBagVersionLine[] = "#ROSBAG V2.0\n";

template <class Number>
std::string bytesOf(Number number) {  // on a little-endian machine
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// `time` [ns]
std::string timeBytes(std::int64_t time);

/// The number of bytes, followed by the bytes.
std::string withSize(const std::string& bytes);

std::string fieldBytes(const std::string& name, const std::string& value);

/// The header of a record with these fields. Its data, withSize(), comes next.
std::string headerBytes(RecordOp op, const std::string& fields);

struct BagTopic {
  std::string topic;
  std::string type;  ///< such as tf2_msgs/TFMessage
  std::string md5sum;
  std::string definition;
  std::string publisher;  ///< name of a node; "" for none
  bool is_latched = false;
};

std::string connectionRecord(std::uint32_t number, const BagTopic& topic);

/// A message without its data.
std::string messageHeader(std::uint32_t connection, std::int64_t time);

std::string chunkHeader(const std::string& compression, std::uint32_t size);

/// Without its data, with which the caller fills the record up to a fixed size.
std::string bagHeader(std::uint64_t index_position, std::uint32_t connections,
                      std::uint32_t chunks);

}  // namespace link_bounds
