// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the reply of a worker must give a valid mesh within the limit, or MeshError.
#include <cstring>

#include "fuzzing.h"
#include "robot/worker/mesh_reply.h"

namespace link_bounds {
namespace {

/// scripts/fuzz limits the memory of the fuzzer to little more.
constexpr std::uint64_t kMaxBytes = 1 << 24;

class Reader {
 public:
  Reader(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::size_t operator()(void* out, std::size_t wanted) {
    const std::size_t count = std::min(wanted, left_);
    if (count > 0) std::memcpy(out, data_, count);
    data_ += count;
    left_ -= count;
    return count;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

std::string replyOf(const ImportedMesh& mesh) {
  std::string bytes;
  writeMeshReply(mesh, [&](const void* next, std::size_t count) {
    bytes.append(static_cast<const char*>(next), count);
  });
  return bytes;
}

std::string replyOf(const MeshError& error) {
  std::string bytes;
  writeErrorReply(error, [&](const void* next, std::size_t count) {
    bytes.append(static_cast<const char*>(next), count);
  });
  return bytes;
}

void checkMesh(const ImportedMesh& mesh, const std::uint8_t* data, std::size_t size) {
  require(!mesh.triangles.empty(), "a mesh has a triangle");
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle)
      require(index < mesh.vertices.size(), "an index names a vertex");
  }
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    require(vertex.allFinite(), "a vertex is finite");
  const std::string bytes = replyOf(mesh);
  require(bytes.size() == size && std::memcmp(bytes.data(), data, size) == 0,
          "a mesh says all that the reply says");
}

}  // namespace
}  // namespace link_bounds

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace link_bounds;
  try {
    checkMesh(readMeshReply(Reader(data, size), kMaxBytes), data, size);
  } catch (const ReplyError&) {
  } catch (const MeshError& error) {
    const std::string reason = error.what();
    const auto is_odd = [](char c) { return c < ' ' || c > '~'; };
    require(std::none_of(reason.begin(), reason.end(), is_odd), "a reason can be printed");
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned random) {
  using namespace link_bounds;
  static const std::vector<std::string> kSeeds{
      replyOf(TriangleMesh{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}}),
      replyOf(TriangleMesh{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}, {{0, 1, 2}, {1, 2, 3}}}),
      replyOf({TriangleMesh{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}},
               {{"/a", {1, 2, 3, {4, 5}, {6, 7}}}, {"/b", {}}}}),
      replyOf(MeshError("it has no triangle"))};
  const std::size_t seed_size = seeded(kSeeds, random, data, size, max_size);
  return seed_size > 0 ? seed_size : LLVMFuzzerMutate(data, size, max_size);
}
