// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Uses a hash table over the bits of vertices, which takes linear time.
#include "robot/mesh/weld.h"

#include <cstring>
#include <limits>
#include <string>

namespace link_bounds {
namespace {

void checkCount(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw MeshError("it has no triangle");
}

void checkIndex(std::uint32_t index, std::size_t vertices) {
  if (index < vertices) return;
  throw MeshError("a triangle names vertex " + std::to_string(index) + " of " +
                  std::to_string(vertices));
}

using Bits = std::array<std::uint32_t, 3>;

/// Fibonacci hashing: the constant is 2^64 / golden ratio.
std::size_t hashOf(const Bits& bits) {
  std::uint64_t hash = 0;
  for (const std::uint32_t word : bits) {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

Bits bitsOf(const Eigen::Vector3f& vertex) {
  Bits bits;
  std::memcpy(bits.data(), vertex.data(), sizeof(bits));
  return bits;
}

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// From the bits of vertices to their indices. Open addressing, because it mostly reads one slot.
class IndexOfBits {
 public:
  explicit IndexOfBits(std::size_t max_vertices) {
    std::size_t slots = 16;
    while (slots < 2 * max_vertices)
      slots *= 2;
    slots_.assign(slots, kNone);
  }

  /// The index of the vertex with these bits; vertices.size() if the caller is to append it.
  std::uint32_t indexOf(const Bits& bits, const std::vector<Eigen::Vector3f>& vertices) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hashOf(bits) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] == kNone) slots_[slot] = static_cast<std::uint32_t>(vertices.size());
      if (slots_[slot] == vertices.size() || bitsOf(vertices[slots_[slot]]) == bits) {
        return slots_[slot];
      }
    }
  }

 private:
  std::vector<std::uint32_t> slots_;
};

/// Gives equal vertices the same new index.
class Welder {
 public:
  explicit Welder(const std::vector<Eigen::Vector3f>& source)
      : source_(source), new_index_(source.size(), kNone), index_of_bits_(source.size()) {}

  std::uint32_t indexOf(std::uint32_t old_index) {
    checkIndex(old_index, source_.size());
    std::uint32_t& index = new_index_[old_index];
    if (index == kNone) index = insert(source_[old_index]);
    return index;
  }

  std::vector<Eigen::Vector3f> takeVertices() { return std::move(vertices_); }

 private:
  std::uint32_t insert(const Eigen::Vector3f& vertex) {
    if (!vertex.allFinite()) throw MeshError("a triangle has a vertex that is not a finite number");
    const Eigen::Vector3f unsigned_zero = vertex.array() + 0.0f;
    const std::uint32_t index = index_of_bits_.indexOf(bitsOf(unsigned_zero), vertices_);
    if (index == vertices_.size()) vertices_.push_back(unsigned_zero);
    return index;
  }

  const std::vector<Eigen::Vector3f>& source_;
  std::vector<std::uint32_t> new_index_;
  IndexOfBits index_of_bits_;
  std::vector<Eigen::Vector3f> vertices_;
};

}  // namespace

void checkTriangles(const TriangleMesh& mesh) {
  checkCount(mesh);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle)
      checkIndex(index, mesh.vertices.size());
  }
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    if (!vertex.allFinite()) throw MeshError("it has a vertex that is not a finite number");
  }
}

TriangleMesh welded(const TriangleMesh& mesh) {
  checkCount(mesh);
  Welder welder(mesh.vertices);
  TriangleMesh result;
  result.triangles.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    const std::uint32_t first = welder.indexOf(triangle[0]);
    const std::uint32_t second = welder.indexOf(triangle[1]);
    const std::uint32_t third = welder.indexOf(triangle[2]);
    result.triangles.push_back({first, second, third});
  }
  result.vertices = welder.takeVertices();
  return result;
}

}  // namespace link_bounds
