// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {

std::string plainRemedy(MeshFault fault) {
  switch (fault) {
    case MeshFault::kFile:
      return "repair or replace the file";
    case MeshFault::kUnreadable:
      return "see that the file is there and may be read";
    case MeshFault::kTooLarge:
    case MeshFault::kTooSlow:
    case MeshFault::kMemory:
      return "simplify the mesh";
    case MeshFault::kComputer:
      return "end some other programs and try again";
    case MeshFault::kChanged:
      return "try again when it is complete";
    case MeshFault::kCancelled:
      return "try again";
    case MeshFault::kReader:
      return "install link_bounds as a whole";
    case MeshFault::kForbidden:
      return "allow it setrlimit and prctl, which a container may forbid";
    case MeshFault::kFileSystem:
      return "see that its file system answers";
    case MeshFault::kFormat:
      return "store it as STL and name it .stl";
  }
  return "";
}

}  // namespace link_bounds
