// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads messages of any type and checks list lengths first. roscpp's own stream allocates memory
// for as many elements as a list announces, and only then checks whether they are there: a message
// of 24 bytes can allocate gigabytes.
#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <vector>

namespace link_bounds {

/// Before memory for a list is allocated, the announced length is compared with the number of bytes
/// left. Throws ros::serialization::StreamOverrunException if they are too few.
class CheckedStream : public ros::serialization::IStream {
 public:
  using IStream::IStream;

  /// Generated code calls this for each field.
  template <class Field>
  void next(Field& field) {
    ros::serialization::deserialize(*this, field);
  }

  template <class Element>
  void next(std::vector<Element>& list) {
    checkLength<Element>();
    ros::serialization::deserialize(*this, list);
  }

 private:
  template <class Element>
  void checkLength() {
    // The min size of an element: all its lists and strings are empty.
    static const std::uint64_t min_size = ros::serialization::serializationLength(Element());
    IStream ahead = *this;
    std::uint32_t length = 0;
    ahead.next(length);
    if (length * min_size > ahead.getLength()) ros::serialization::throwStreamOverrun();
  }
};

/// False, with an empty message, if `data` ends before the announced end of the message.
template <class Message>
bool readComplete(const std::uint8_t* data, std::uint32_t size, Message& message) {
  try {
    CheckedStream stream(const_cast<std::uint8_t*>(data), size);  // the stream only reads
    ros::serialization::deserialize(stream, message);
    return true;
  } catch (const ros::serialization::StreamOverrunException&) {
    message = Message();
    return false;
  }
}

}  // namespace link_bounds
