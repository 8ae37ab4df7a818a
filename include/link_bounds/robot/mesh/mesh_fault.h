// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Why a mesh cannot be used. The cause decides what helps; who knows the user words the remedy.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace link_bounds {

/// Sent by mesh_worker as a number: append only, and keep kLastMeshFault.
enum class MeshFault {
  kFile,        ///< its content
  kUnreadable,  ///< it cannot be opened
  kTooLarge,    ///< file or triangles: more bytes than MeshLimits::max_bytes allows
  kTooSlow,     ///< it takes longer than MeshLimits::timeout
  kMemory,      ///< it takes more memory than a file of its size may
  kComputer,    ///< memory, processes or open files run out
  kChanged,     ///< it changed while it was read
  kCancelled,   ///< the caller gave up
  kReader,      ///< mesh_worker is missing, or not the one of this library
  kForbidden,   ///< the kernel does not let mesh_worker limit itself
  kFileSystem,  ///< mesh_worker cannot be killed while it waits for the file
};
constexpr MeshFault kLastMeshFault = MeshFault::kFileSystem;

/// what() is the reason, in words for the user; the thrower does not repeat the file's name.
class MeshError : public std::runtime_error {
 public:
  explicit MeshError(const std::string& reason, MeshFault fault = MeshFault::kFile)
      : std::runtime_error(reason), fault_(fault) {}
  MeshFault fault() const { return fault_; }

 private:
  MeshFault fault_;
};

/// What a user can do.
using MeshRemedy = std::function<std::string(MeshFault)>;

/// That of a program that runs once and has no options for the limits, such as urdf_bounds.
std::string plainRemedy(MeshFault fault);

}  // namespace link_bounds
