// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Collects the triangles of assimp's node tree.
#include "robot/worker/mesh_import.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/IOStream.hpp>
#include <assimp/Importer.hpp>
#include <cstring>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

#include "link_bounds/geometry/box/length.h"
#include "robot/mesh/weld.h"
#include "robot/worker/confined_files.h"

namespace link_bounds {
namespace {

Eigen::Affine3d toAffine(const aiMatrix4x4& m) {
  Eigen::Affine3d result;
  result.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0,
      0, 1;
  return result;
}

/// The root node's transform without its rotation, as rviz splits it: the scale is the length of
/// each column, all negative if the node mirrors.
Eigen::Affine3d withoutRotation(const Eigen::Affine3d& root) {
  const double sign = root.linear().determinant() < 0 ? -1 : 1;
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = root.linear().col(k);
    result.linear()(k, k) = sign * length(axis.x(), axis.y(), axis.z());
  }
  if (result.linear().isZero(0)) throw MeshError("its unit of length is zero");
  result.translation() = root.translation();
  return result;
}

/// Some readers of assimp do not check the indices of the file.
void checkIndices(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        if (face.mIndices[i] >= mesh.mNumVertices) {
          throw MeshError("face " + std::to_string(f) + " names vertex " +
                          std::to_string(face.mIndices[i]) + " of " +
                          std::to_string(mesh.mNumVertices));
        }
      }
    }
  }
}

void append(const aiMesh& source, const Eigen::Affine3d& file_from_node, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    const aiVector3D& v = source.mVertices[i];
    const Eigen::Vector3d vertex(v.x, v.y, v.z);
    mesh.vertices.push_back((file_from_node * vertex).cast<float>());
  }
  for (unsigned i = 0; i < source.mNumFaces; ++i) {
    const aiFace& face = source.mFaces[i];
    // A polygon becomes a fan, points and lines nothing. The box is that of any triangulation.
    for (unsigned corner = 2; corner < face.mNumIndices; ++corner) {
      mesh.triangles.push_back({first + face.mIndices[0], first + face.mIndices[corner - 1],
                                first + face.mIndices[corner]});
    }
  }
}

/// The PLY reader of assimp makes one triangle of all strips of a mesh.
void refuseTriangleStrips(ConfinedFiles& files, const std::string& path) {
  constexpr std::size_t kMaxHeaderBytes = 1 << 16;  // headers of real files take less than 1 KiB
  Assimp::IOStream* file = files.Open(path.c_str(), "rb");
  if (!file) throw MeshError("it cannot be opened", MeshFault::kUnreadable);
  std::string header(kMaxHeaderBytes, ' ');
  header.resize(file->Read(header.data(), 1, kMaxHeaderBytes));
  files.Close(file);
  if (header.compare(0, 3, "ply") != 0) return;
  std::replace(header.begin(), header.end(), '\r', '\n');
  std::istringstream lines(header);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    std::string name;
    words >> keyword >> name;
    if (keyword == "end_header") return;
    if (keyword == "element" && name == "tristrips") {
      throw MeshError("it is made of triangle strips, which assimp misreads; store triangles");
    }
  }
}

/// The reader of OFF replaces an index that is out of range by a valid one, and only logs it.
class IndexErrorLog : public Assimp::Logger {
 public:
  /// "" if there is none.
  const std::string& firstError() const { return first_error_; }

  // The names of pure functions differ between versions of assimp (OnVerboseDebug, detachStream
  // and detatchStream), so none is marked as overriding.
  void OnDebug(const char*) {}
  void OnVerboseDebug(const char*) {}
  void OnInfo(const char*) {}
  void OnWarn(const char*) {}
  void OnError(const char* message) {
    const bool is_index_error = std::strstr(message, "out of range") != nullptr;
    if (is_index_error && first_error_.empty()) first_error_ = message;
  }
  bool attachStream(Assimp::LogStream*, unsigned int) { return false; }
  bool detachStream(Assimp::LogStream*, unsigned int) { return false; }
  bool detatchStream(Assimp::LogStream*, unsigned int) { return false; }

 private:
  std::string first_error_;
};

/// A loop, because nodes may be nested more deeply than the stack allows.
TriangleMesh collectTriangles(const aiScene& scene) {
  TriangleMesh mesh;
  std::vector<std::pair<const aiNode*, Eigen::Affine3d>> open;
  open.emplace_back(scene.mRootNode, withoutRotation(toAffine(scene.mRootNode->mTransformation)));
  while (!open.empty()) {
    const auto [node, file_from_node] = open.back();
    open.pop_back();
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      append(*scene.mMeshes[node->mMeshes[i]], file_from_node, mesh);
    }
    for (unsigned i = node->mNumChildren; i-- > 0;) {
      const aiNode* child = node->mChildren[i];
      open.emplace_back(child, file_from_node * toAffine(child->mTransformation));
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh importMesh(const MeshFile& file, std::uint64_t max_bytes,
                        const BytesHandler& on_bytes) {
  auto* const log = new IndexErrorLog;
  Assimp::DefaultLogger::set(log);  // which owns it
  Assimp::Importer importer;
  auto* files = new ConfinedFiles(file.root, max_bytes, on_bytes);
  importer.SetIOHandler(files);
  refuseTriangleStrips(*files, file.path);
  // Otherwise assimp adds a mesh that shows the nodes of a file without geometry.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(file.path, 0);
  if (!scene || !scene->mRootNode) {
    const std::string reason = importer.GetErrorString();
    if (reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    const std::string& too_large = files->tooLarge();
    if (too_large.empty()) throw MeshError("assimp cannot read it (" + reason + ")");
    throw MeshError("assimp cannot read it (" + reason + "); " + too_large, MeshFault::kTooLarge);
  }
  checkIndices(*scene);
  if (!log->firstError().empty()) {
    throw MeshError("assimp found a fault in it (" + log->firstError() + ")");
  }
  return welded(collectTriangles(*scene));
}

}  // namespace link_bounds
