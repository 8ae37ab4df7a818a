// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The fields of visualization_msgs/Marker, in their order.
#include "tools/bag_bounds/marker_bytes.h"

#include <ros/serialization.h>

namespace link_bounds {
namespace {

using ros::serialization::IStream;

std::uint32_t readCount(IStream& stream) {
  std::uint32_t count = 0;
  stream.next(count);
  return count;
}

void skip(IStream& stream, std::uint64_t size) {
  if (size > stream.getLength()) ros::serialization::throwStreamOverrun();
  stream.advance(static_cast<std::uint32_t>(size));
}

void skipList(IStream& stream, std::uint64_t element_size) {
  skip(stream, readCount(stream) * element_size);
}

void skipMarker(IStream& stream) {
  constexpr std::uint64_t kSeqAndStamp = 12;
  constexpr std::uint64_t kIdTypeAction = 12;
  constexpr std::uint64_t kPoseScaleColor = 56 + 24 + 16;
  constexpr std::uint64_t kLifetimeAndLocked = 9;
  skip(stream, kSeqAndStamp);
  skipList(stream, 1);  // frame_id
  skipList(stream, 1);  // ns
  skip(stream, kIdTypeAction + kPoseScaleColor + kLifetimeAndLocked);
  skipList(stream, 24);  // points
  skipList(stream, 16);  // colors
  skipList(stream, 1);   // text
  skipList(stream, 1);   // mesh_resource
  skip(stream, 1);       // mesh_use_embedded_materials
}

}  // namespace

void checkMarkerBytes(const std::uint8_t* data, std::uint32_t size, bool is_array) {
  IStream stream(const_cast<std::uint8_t*>(data), size);  // the stream only reads
  for (std::uint32_t count = is_array ? readCount(stream) : 1; count > 0; --count)
    skipMarker(stream);
}

}  // namespace link_bounds
