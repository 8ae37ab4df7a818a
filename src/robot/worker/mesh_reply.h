// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// What mesh_worker writes to its standard output: the triangles of a file, or why there are none.
///
///     magic      8 bytes     "LBMESH\r\n"
///     version    uint32      3
///     status     uint32      0: a mesh, 1 + MeshFault: an error
///     vertices   uint64      their number; 0 if an error
///     triangles  uint64      their number; 0 if an error
///     text       uint64      bytes of the reason; 0 if a mesh
///     files      uint64      bytes of the list of files; 0 if an error
///     then 3 float32 per vertex (metres, frame of the file), 3 uint32 per triangle, the text, the
///     list: per file that was opened or looked for its device, inode, size, st_mtim, st_ctim (each
///     two int64: s, ns), and the bytes of its path, as uint64, and its absolute path
///
/// Numbers are in the byte order of the machine, which both ends share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "link_bounds/robot/mesh/imported_mesh.h"
#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {

/// Fills `out` with the next bytes and returns how many; fewer than `wanted` only at the end.
using ByteSource = std::function<std::size_t(void* out, std::size_t wanted)>;

/// Writes all of the bytes.
using ByteSink = std::function<void(const void* bytes, std::size_t count)>;

/// The reply breaks the rules above, so nothing in it can be trusted.
class ReplyError : public MeshError {
 public:
  using MeshError::MeshError;
};

/// Throws MeshError if the mesh has so many files that their list is longer than kMaxFilesBytes.
void writeMeshReply(const ImportedMesh& mesh, const ByteSink& sink);

/// Cuts a reason of more than 4096 bytes.
void writeErrorReply(const MeshError& error, const ByteSink& sink);

constexpr std::uint64_t kMaxFilesBytes = 4 << 20;

/// Checks everything: counts before memory is allocated for them, indices, coordinates, and that
/// nothing follows. Throws MeshError with the reason and fault of an error reply, in printable
/// ASCII. Throws ReplyError if the reply is malformed or the triangles take more than `max_bytes`.
ImportedMesh readMeshReply(const ByteSource& source, std::uint64_t max_bytes);

}  // namespace link_bounds
