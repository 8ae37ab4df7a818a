// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A TFMessage is a count, then per transform: seq, stamp, frame_id, child_frame_id, translation,
// rotation.
#include "tf_message.h"

namespace link_bounds {
namespace {

using ros::serialization::IStream;

std::string_view stripped(std::string_view name) {
  if (!name.empty() && name.front() == '/') name.remove_prefix(1);
  return name;
}

std::string_view readName(IStream& stream) {
  std::uint32_t size = 0;
  stream.next(size);
  return stripped({reinterpret_cast<const char*>(stream.advance(size)), size});
}

Tf2Pose readPose(IStream& stream) {
  double t[3], q[4];
  for (double& entry : t)
    stream.next(entry);
  for (double& entry : q)
    stream.next(entry);
  return {{q[0], q[1], q[2], q[3]}, {t[0], t[1], t[2]}};
}

}  // namespace

TransformView::TransformView(const geometry_msgs::TransformStamped& transform)
    : parent(stripped(transform.header.frame_id)),
      child(stripped(transform.child_frame_id)),
      stamp(transform.header.stamp) {
  const auto& q = transform.transform.rotation;
  const auto& t = transform.transform.translation;
  parent_from_child = {{q.x, q.y, q.z, q.w}, {t.x, t.y, t.z}};
}

void TfMessage::read(const std::uint8_t* data, std::uint32_t size) {
  bytes.assign(data, data + size);
  transforms.clear();
  IStream stream(bytes.data(), size);
  std::uint32_t count = 0;
  for (stream.next(count); count > 0; --count) {
    std::uint32_t seq = 0;
    TransformView transform;
    stream.next(seq);
    stream.next(transform.stamp);
    transform.parent = readName(stream);
    transform.child = readName(stream);
    transform.parent_from_child = readPose(stream);
    transforms.push_back(transform);
  }
}

}  // namespace link_bounds
