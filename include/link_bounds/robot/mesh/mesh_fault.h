// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Why a mesh cannot be used. Each program words the remedy for its own users.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace link_bounds {

/// mesh_worker sends it as a number: append only, and update kLastMeshFault.
enum class MeshFault {
  kFile,        ///< the content of the file is wrong
  kUnreadable,  ///< the file cannot be opened
  kTooLarge,    ///< file or triangles have more bytes than MeshLimits::max_bytes allows
  kTooSlow,     ///< reading takes longer than MeshLimits::timeout
  kMemory,      ///< reading takes more memory than a file of its size may take
  kComputer,    ///< the computer lacks memory, processes or open files
  kChanged,     ///< the file changed while it was read
  kCancelled,   ///< the caller cancelled
  kReader,      ///< mesh_worker is missing, or belongs to another version of this library
  kForbidden,   ///< the kernel refuses the limits that mesh_worker sets itself
  kFileSystem,  ///< mesh_worker cannot be killed while it waits for the file system
  kFormat,      ///< the file is of a format that is not read, or nothing tells its format
};
constexpr MeshFault kLastMeshFault = MeshFault::kFormat;

/// Whether a file that was only half written could be the cause.
constexpr bool isOfContent(MeshFault fault) {
  return fault == MeshFault::kFile || fault == MeshFault::kFormat;
}

/// what() is the reason, in words for the user, without the name of the file.
class MeshError : public std::runtime_error {
 public:
  explicit MeshError(const std::string& reason, MeshFault fault = MeshFault::kFile)
      : std::runtime_error(reason), fault_(fault) {}
  MeshFault fault() const { return fault_; }

 private:
  MeshFault fault_;
};

/// Says what a user can do about a fault.
using MeshRemedy = std::function<std::string(MeshFault)>;

/// For programs that run once and have no options for the limits, such as urdf_bounds.
std::string plainRemedy(MeshFault fault);

}  // namespace link_bounds
