// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What needs no library: the paper's loop, the scan, and loose boxes.
#include "core_suite.h"

namespace link_bounds::bench {
namespace {

/// What all methods here share.
struct WithEigen : Method {
  Eigen::Isometry3d prepare(const Eigen::Affine3d& pose) const {
    return Eigen::Isometry3d(pose.matrix());
  }
  Aabb toAabb(const Aabb& box) const { return box; }
};

/// The paper's Figure 4: each vertex of each triangle.
struct PaperLoop : WithEigen {
  const TriangleMesh* mesh;

  explicit PaperLoop(const Mesh& source) : mesh(&source.mesh) {}
  Aabb box(const Eigen::Isometry3d& pose) const {
    Aabb result;
    for (const auto& triangle : mesh->triangles) {
      for (const std::uint32_t index : triangle)
        result.extend(pose * mesh->vertices[index].cast<double>());
    }
    return result;
  }
  std::size_t bytes() const {
    return mesh->vertices.size() * sizeof(Eigen::Vector3f) +
           mesh->triangles.size() * sizeof(mesh->triangles[0]);
  }
};

struct WeldedScan : WithEigen {
  const TriangleMesh* mesh;

  explicit WeldedScan(const Mesh& source) : mesh(&source.mesh) {}
  Aabb box(const Eigen::Isometry3d& pose) const {
    Aabb result;
    for (const Eigen::Vector3f& vertex : mesh->vertices)
      result.extend(pose * vertex.cast<double>());
    return result;
  }
  std::size_t bytes() const { return mesh->vertices.size() * sizeof(Eigen::Vector3f); }
};

Aabb localBox(const Mesh& mesh) {
  Aabb box;
  for (const Eigen::Vector3f& vertex : mesh.mesh.vertices)
    box.extend(vertex.cast<double>());
  return box;
}

/// Loose: the eight corners of the box of the resting mesh.
struct Corners8 : WithEigen {
  std::array<Eigen::Vector3d, 8> corner;

  explicit Corners8(const Mesh& mesh) : corner(corners(localBox(mesh))) {}
  Aabb box(const Eigen::Isometry3d& pose) const {
    Aabb result;
    for (const Eigen::Vector3d& point : corner)
      result.extend(pose * point);
    return result;
  }
  std::size_t bytes() const { return sizeof(corner); }
};

/// Loose: Eigen's own way to turn a box.
struct EigenBox : WithEigen {
  Aabb local;

  explicit EigenBox(const Mesh& mesh) : local(localBox(mesh)) {}
  Aabb box(const Eigen::Isometry3d& pose) const { return local.transformed(pose); }
  std::size_t bytes() const { return sizeof(local); }
};

/// Loose: centre and widths of the resting box, as in MoveIt's RobotState::computeAABB: the widths
/// are turned by the rotation's absolute values.
struct MoveIt : WithEigen {
  Eigen::Vector3d center;
  Eigen::Vector3d widths;

  explicit MoveIt(const Mesh& mesh)
      : center(localBox(mesh).center()), widths(localBox(mesh).sizes()) {}
  Aabb box(const Eigen::Isometry3d& pose) const {
    const Eigen::Vector3d radius = 0.5 * (pose.linear().cwiseAbs() * widths);
    const Eigen::Vector3d middle = pose * center;
    Aabb result;
    result.extend(middle - radius);
    result.extend(middle + radius);
    return result;
  }
  std::size_t bytes() const { return sizeof(*this); }
};

}  // namespace

void addScans(const Task& task) {
  addCase("paper_loop", task, PaperLoop(task.mesh));
  addCase("welded_scan", task, WeldedScan(task.mesh));
}

void addLooseRules(const Task& task) {
  addCase("corners8", task, Corners8(task.mesh));
  addCase("eigen", task, EigenBox(task.mesh));
  addCase("moveit", task, MoveIt(task.mesh));
}

}  // namespace link_bounds::bench
