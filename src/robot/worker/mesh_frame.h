// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The bytes in which mesh_worker answers: the triangles of a file, or why there are none.
///
///     magic      8 bytes     "LBMESH\r\n"
///     version    uint32      2
///     status     uint32      0: a mesh, 1 + MeshFault: an error
///     vertices   uint64      0 of an error
///     triangles  uint64      0 of an error
///     text       uint64      bytes of the reason, 0 of a mesh
///     then 3 float32 per vertex (metres, frame of the file), 3 uint32 per triangle, the text
///
/// Both ends are processes of one machine: numbers are in its byte order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "link_bounds/geometry/parts/triangle_mesh.h"
#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {

/// Fills `out` with the next bytes and returns how many; fewer than `wanted` only at the end.
using ByteSource = std::function<std::size_t(void* out, std::size_t wanted)>;

/// Takes all of the bytes.
using ByteSink = std::function<void(const void* bytes, std::size_t count)>;

/// The answer breaks the rules above; whoever wrote it cannot be believed.
class FrameError : public MeshError {
 public:
  using MeshError::MeshError;
};

void writeMeshFrame(const TriangleMesh& mesh, const ByteSink& sink);

/// Of a longer reason the beginning.
void writeErrorFrame(const MeshError& error, const ByteSink& sink);

/// Believes nothing: neither counts, before memory is taken for them, nor indices, nor numbers, and
/// nothing may follow. Throws FrameError, also if the mesh takes more than `max_bytes` here, and
/// MeshError with reason and fault if the frame holds them; only printable ASCII is kept.
TriangleMesh readMeshFrame(const ByteSource& source, std::uint64_t max_bytes);

}  // namespace link_bounds
