// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A header of fixed size, then the arrays as they lie in memory.
#include "robot/worker/mesh_reply.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

namespace link_bounds {
namespace {

constexpr std::array<char, 8> kMagic{'L', 'B', 'M', 'E', 'S', 'H', '\r', '\n'};
constexpr std::uint32_t kVersion = 3;
constexpr std::uint32_t kMesh = 0;
constexpr std::uint32_t kFirstError = 1;
constexpr std::uint32_t kLastError = kFirstError + static_cast<std::uint32_t>(kLastMeshFault);
constexpr std::uint64_t kMaxTextBytes = 4096;  // of the reason of an error

struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t status = kMesh;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t text = 0;
  std::uint64_t files = 0;
};
static_assert(sizeof(Header) == 48, "no padding");

struct FileRecord {
  std::uint64_t device;
  std::uint64_t inode;
  std::uint64_t size;
  std::int64_t written_s;
  std::int64_t written_ns;
  std::int64_t changed_s;
  std::int64_t changed_ns;
  std::uint64_t path;  ///< bytes
};
static_assert(sizeof(FileRecord) == 64, "no padding");

constexpr std::uint64_t kVertexBytes = sizeof(TriangleMesh::vertices[0]);
constexpr std::uint64_t kTriangleBytes = sizeof(TriangleMesh::triangles[0]);
static_assert(kVertexBytes == 12 && kTriangleBytes == 12, "no padding");

void readAll(const ByteSource& source, void* out, std::size_t count) {
  if (source(out, count) == count) return;
  throw ReplyError("the answer of the mesh reader ends early", MeshFault::kReader);
}

void checkEnd(const ByteSource& source) {
  char next = 0;
  if (source(&next, 1) != 0) throw ReplyError("the answer of the mesh reader does not end");
}

Header readHeader(const ByteSource& source) {
  Header header;
  readAll(source, &header, sizeof(header));
  if (header.magic != kMagic || header.version != kVersion || header.status > kLastError) {
    throw ReplyError("the answer of the mesh reader is not one of this version",
                     MeshFault::kReader);
  }
  return header;
}

[[noreturn]] void throwContradiction() {
  throw ReplyError("the answer of the mesh reader contradicts itself");
}

void checkCounts(const Header& header, std::uint64_t max_bytes) {
  if (header.text != 0 || header.vertices == 0 || header.triangles == 0 ||
      header.files > kMaxFilesBytes ||
      header.vertices > std::numeric_limits<std::uint32_t>::max()) {
    throwContradiction();
  }
  // Compares each count first, so that the sum cannot overflow.
  if (header.vertices > max_bytes / kVertexBytes || header.triangles > max_bytes / kTriangleBytes ||
      header.vertices * kVertexBytes + header.triangles * kTriangleBytes > max_bytes) {
    throw ReplyError("its " + std::to_string(header.vertices) + " vertices and " +
                         std::to_string(header.triangles) + " triangles take more than " +
                         std::to_string(max_bytes) + " bytes",
                     MeshFault::kTooLarge);
  }
}

void checkContent(const TriangleMesh& mesh) {
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    if (!vertex.allFinite()) throw ReplyError("the mesh reader gave a vertex that is not finite");
  }
  for (const auto& triangle : mesh.triangles) {
    if (*std::max_element(triangle.begin(), triangle.end()) >= mesh.vertices.size()) {
      throw ReplyError("the mesh reader gave a triangle without its vertex");
    }
  }
}

std::string listOf(const FileVersions& files) {
  std::string list;
  for (const auto& [path, version] : files) {
    const FileRecord record{version.device,
                            version.inode,
                            version.size,
                            version.written.tv_sec,
                            version.written.tv_nsec,
                            version.changed.tv_sec,
                            version.changed.tv_nsec,
                            path.size()};
    list.append(reinterpret_cast<const char*>(&record), sizeof(record)).append(path);
  }
  return list;
}

/// Reads a list of files. Their paths must be in ascending order, as listOf() writes them.
FileVersions filesIn(std::string_view list) {
  FileVersions files;
  while (!list.empty()) {
    FileRecord record{};
    if (list.size() < sizeof(record)) throwContradiction();
    std::memcpy(&record, list.data(), sizeof(record));
    list.remove_prefix(sizeof(record));
    if (record.path > list.size()) throwContradiction();
    std::string path(list.substr(0, record.path));
    list.remove_prefix(record.path);
    const bool is_path = !path.empty() && path[0] == '/' && path.find('\0') == path.npos;
    if (!is_path || (!files.empty() && path <= files.rbegin()->first)) throwContradiction();
    const timespec written{record.written_s, record.written_ns};
    const timespec changed{record.changed_s, record.changed_ns};
    const FileVersion version{record.device, record.inode, record.size, written, changed};
    files.emplace_hint(files.end(), std::move(path), version);
  }
  return files;
}

[[noreturn]] void throwReason(const Header& header, const ByteSource& source) {
  if (header.vertices != 0 || header.triangles != 0 || header.files != 0 ||
      header.text > kMaxTextBytes) {
    throwContradiction();
  }
  std::string reason(static_cast<std::size_t>(header.text), ' ');
  readAll(source, reason.data(), reason.size());
  checkEnd(source);
  const auto is_odd = [](char c) { return c < ' ' || c > '~'; };
  std::replace_if(reason.begin(), reason.end(), is_odd, '?');
  throw MeshError(reason, static_cast<MeshFault>(header.status - kFirstError));
}

}  // namespace

void writeMeshReply(const ImportedMesh& mesh, const ByteSink& sink) {
  const std::string files = listOf(mesh.files);
  if (files.size() > kMaxFilesBytes) {
    throw MeshError("it names so many files that their list takes " + std::to_string(files.size()) +
                    " bytes, more than the " + std::to_string(kMaxFilesBytes) +
                    " that are allowed");
  }
  Header header;
  header.files = files.size();
  header.vertices = mesh.vertices.size();
  header.triangles = mesh.triangles.size();
  sink(&header, sizeof(header));
  sink(mesh.vertices.data(), mesh.vertices.size() * kVertexBytes);
  sink(mesh.triangles.data(), mesh.triangles.size() * kTriangleBytes);
  sink(files.data(), files.size());
}

void writeErrorReply(const MeshError& error, const ByteSink& sink) {
  const std::string reason = error.what();
  Header header;
  header.status = kFirstError + static_cast<std::uint32_t>(error.fault());
  header.text = std::min<std::uint64_t>(reason.size(), kMaxTextBytes);
  sink(&header, sizeof(header));
  sink(reason.data(), header.text);
}

ImportedMesh readMeshReply(const ByteSource& source, std::uint64_t max_bytes) {
  const Header header = readHeader(source);
  if (header.status != kMesh) throwReason(header, source);
  checkCounts(header, max_bytes);
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<std::size_t>(header.vertices));
  mesh.triangles.resize(static_cast<std::size_t>(header.triangles));
  readAll(source, mesh.vertices.data(), mesh.vertices.size() * kVertexBytes);
  readAll(source, mesh.triangles.data(), mesh.triangles.size() * kTriangleBytes);
  std::string files(static_cast<std::size_t>(header.files), ' ');
  readAll(source, files.data(), files.size());
  checkEnd(source);
  checkContent(mesh);
  return {std::move(mesh), filesIn(files)};
}

}  // namespace link_bounds
