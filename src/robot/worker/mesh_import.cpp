// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Collects the triangles of assimp's node tree.
#include "robot/worker/mesh_import.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <assimp/DefaultLogger.hpp>
#include <assimp/IOStream.hpp>
#include <assimp/Importer.hpp>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/geometry/box/length.h"
#include "robot/mesh/weld.h"
#include "robot/worker/confined_files.h"
#include "robot/worker/mesh_formats.h"
#include "robot/worker/mesh_text.h"
#include "robot/worker/polygon.h"

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
  CornerIndices corners;
  for (unsigned i = 0; i < source.mNumFaces; ++i) {
    const aiFace& face = source.mFaces[i];
    corners.assign(face.mIndices, face.mIndices + face.mNumIndices);
    for (std::uint32_t& corner : corners)
      corner += first;
    // Points and lines are left out.
    if (corners.size() == 3) {
      mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    } else if (corners.size() > 3) {
      const auto triangles = trianglesOf(corners, mesh.vertices);
      mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    }
  }
}

/// Parts of messages of assimp, in small letters, that tell of geometry that is left out or
/// misread.
constexpr std::array kLosses = {
    // In warnings.
    "'endsolid' keyword was expected", "not yet complete", "resulted in overflow",
    "unable to find geometry", "dropped", "unable to parse", "vertex index", "invalid index",
    "meter parameter",
    // In errors that may have one of the words below, as in a name.
    "to instanced node", "unresolved reference format", "unexpected eof"};

/// An error with one of these leaves out no geometry; all other errors may.
constexpr std::array kNoLosses = {
    // About looks and motion.
    "material", "mtl", "texture", "uv", "normal", "tangent", "color", "shader", "effect", "diffuse",
    "specular", "light", "camera", "ambient", "emissive", "illumination", "bone", "skeleton",
    "animation", "skin", "mapping",
    // A face without corners, a material before the first vertex, a point with a texture.
    "empty face", "attach a new mesh", "point statement"};

template <class Parts>
bool hasAny(const Parts& parts, const std::string& text) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const char* part) { return text.find(part) != std::string::npos; });
}

/// Some readers only log what they leave out: an index that is out of range, a number that is too
/// large, the end of a text, a part of a Collada file that is elsewhere.
class LossLog : public Assimp::Logger {
 public:
  /// The first message about lost geometry; "" if there is none.
  const std::string& firstLoss() const { return first_loss_; }

  // The names of pure functions differ between versions of assimp (OnVerboseDebug, detachStream
  // and detatchStream), so none is marked as overriding.
  void OnDebug(const char*) {}
  void OnVerboseDebug(const char*) {}
  void OnInfo(const char*) {}
  void OnWarn(const char* message) {
    if (hasAny(kLosses, inSmallLetters(message))) note(message);
  }
  void OnError(const char* message) {
    const std::string text = inSmallLetters(message);
    if (hasAny(kLosses, text) || !hasAny(kNoLosses, text)) note(message);
  }
  bool attachStream(Assimp::LogStream*, unsigned int) { return false; }
  bool detachStream(Assimp::LogStream*, unsigned int) { return false; }
  bool detatchStream(Assimp::LogStream*, unsigned int) { return false; }

 private:
  void note(const char* message) {
    if (first_loss_.empty()) first_loss_ = message;
  }

  std::string first_loss_;
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

TriangleMesh read(const std::string& path, Assimp::Importer& importer, ConfinedFiles& files) {
  auto* const log = new LossLog;
  Assimp::DefaultLogger::set(log);  // which owns it
  checkFormat(importer, files, path);
  // Otherwise assimp adds a mesh that shows the nodes of a file without geometry.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(path, 0);
  if (!scene || !scene->mRootNode) {
    const std::string reason = importer.GetErrorString();
    if (reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    const std::string what = "assimp cannot read it (" + reason + ")";
    const std::optional<MeshError>& refusal = files.refusal();
    if (!refusal) throw MeshError(what);
    throw MeshError(what + "; " + refusal->what(), refusal->fault());
  }
  checkIndices(*scene);
  if (!log->firstLoss().empty())
    throw MeshError("assimp found a fault in it (" + log->firstLoss() + ")");
  return welded(collectTriangles(*scene));
}

}  // namespace

ImportedMesh importMesh(const MeshFile& file, std::uint64_t max_bytes,
                        const BytesHandler& on_bytes) {
  Assimp::Importer importer;
  auto* const files = new ConfinedFiles(file, max_bytes, on_bytes);
  importer.SetIOHandler(files);  // which owns it
  const auto refuseChanged = [files] {
    if (!areUnchanged(files->files())) throw MeshError(kChangedReason, MeshFault::kChanged);
  };
  try {
    TriangleMesh mesh = read(file.path, importer, *files);
    refuseChanged();
    return {std::move(mesh), files->files()};
  } catch (const MeshError& error) {
    if (isOfContent(error.fault())) refuseChanged();
    throw;
  }
}

}  // namespace link_bounds
