// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Remedies that name a parameter or the service ~reload.
#include "node/loading/mesh_remedy.h"

namespace link_bounds {

std::string nodeRemedy(MeshFault fault) {
  switch (fault) {
    case MeshFault::kTooLarge:
      return "raise max_mesh_bytes or simplify the mesh";
    case MeshFault::kTooSlow:
      return "raise mesh_timeout or simplify the mesh";
    case MeshFault::kComputer:
      return "end some other programs and call ~reload";
    case MeshFault::kChanged:
      return "call ~reload when it is complete";
    case MeshFault::kCancelled:
      return "call ~reload";
    default:
      return plainRemedy(fault);
  }
}

}  // namespace link_bounds
