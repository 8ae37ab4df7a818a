// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is written comes back; what lies is refused before memory is taken for it.
#include "robot/worker/mesh_reply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "testing/mesh_texts.h"
#include "testing/refusal.h"

namespace link_bounds {
namespace {

constexpr std::uint64_t kMaxBytes = 1000;

/// A status that no reply has.
constexpr std::uint32_t kPastLast = 2 + static_cast<std::uint32_t>(kLastMeshFault);

const TriangleMesh kMesh{{{0, 0, 0}, {1, 2, 3}, {-4, 5e-40f, 3e38f}}, {{0, 1, 2}, {2, 1, 0}}};

const FileVersions kFiles{{"/a", {1, 2, 3, {4, 5}, {6, 7}}}, {"/b c", {}}};

ByteSink appendTo(std::string& out) {
  return [&out](const void* bytes, std::size_t count) {
    out.append(static_cast<const char*>(bytes), count);
  };
}

std::string replyOf(const ImportedMesh& mesh) {
  std::string bytes;
  writeMeshReply(mesh, appendTo(bytes));
  return bytes;
}

std::string errorReply(const std::string& reason, MeshFault fault = MeshFault::kFile) {
  std::string bytes;
  writeErrorReply(MeshError(reason, fault), appendTo(bytes));
  return bytes;
}

/// Bytes of the reply's head.
enum Offset { kMagic = 0, kVersion = 8, kStatus = 12, kVertices = 16, kTriangles = 24, kText = 32 };

constexpr std::size_t kFilesBytes = 40;  ///< of the reply's head, too
constexpr std::size_t kPathBytes = 56;   ///< of an entry in the list of files

template <class Value>
std::string with(std::string reply, std::size_t offset, Value value) {
  std::memcpy(&reply[offset], &value, sizeof(value));
  return reply;
}

ImportedMesh read(const std::string& reply, std::uint64_t max_bytes = kMaxBytes) {
  std::size_t next = 0;
  const auto source = [&](void* out, std::size_t wanted) {
    const std::size_t count = std::min(wanted, reply.size() - next);
    std::memcpy(out, reply.data() + next, count);
    next += count;
    return count;
  };
  return readMeshReply(source, max_bytes);
}

void expectBroken(const std::string& reply, const std::string& words,
                  std::uint64_t max_bytes = kMaxBytes) {
  const std::string reason = refusalOf<ReplyError>([&] { read(reply, max_bytes); });
  EXPECT_NE(reason.find(words), std::string::npos) << "\"" << reason << "\", not " << words;
}

std::string reasonIn(const std::string& reply) {
  try {
    read(reply);
  } catch (const ReplyError& error) {
    return std::string("broken: ") + error.what();
  } catch (const MeshError& error) {
    return error.what();
  }
  return "no error";
}

TEST(MeshReply, AMeshComesBackWithItsFiles) {
  for (const FileVersions& files : {kFiles, FileVersions()}) {
    const ImportedMesh mesh = read(replyOf({kMesh, files}));
    EXPECT_EQ(mesh.vertices, kMesh.vertices);
    EXPECT_EQ(mesh.triangles, kMesh.triangles);
    EXPECT_EQ(mesh.files, files);
  }
}

TEST(MeshReply, AListOfFilesThatContradictsItself) {
  const std::string reply = replyOf({kMesh, kFiles});
  const std::size_t first = reply.size() - 2 * 64 - 2 - 4;
  expectBroken(with(reply, first + kPathBytes, std::uint64_t(1) << 40), "contradicts");
  expectBroken(with(reply, first + kPathBytes, ~std::uint64_t(0)), "contradicts");
  expectBroken(with(reply, first + kPathBytes, std::uint64_t(0)), "contradicts");
  expectBroken(with(reply, first + 64, 'a'), "contradicts");         // no absolute path
  expectBroken(with(reply, reply.size() - 1, '\0'), "contradicts");  // ends too early for open()
  expectBroken(with(reply, first + 65, 'c'), "contradicts");         // not in order
  const std::uint64_t much = kMaxFilesBytes + 1;
  expectBroken(with(reply, kFilesBytes, much), "contradicts");
  expectBroken(with(errorReply("reason"), kFilesBytes, std::uint64_t(1)), "contradicts");
}

TEST(MeshReply, AMeshOfVeryManyFilesIsRefused) {
  FileVersions files;
  for (int i = 0; i < 70000; ++i)
    files["/" + std::to_string(i)];
  EXPECT_NE(refusalOf<MeshError>([&] {
              replyOf({kMesh, files});
            }).find("so many files"),
            std::string::npos);
}

TEST(MeshReply, AReasonComesBackAsAnOrdinaryError) {
  EXPECT_EQ(reasonIn(errorReply("it has no triangle")), "it has no triangle");
  EXPECT_EQ(reasonIn(errorReply("")), "");
}

TEST(MeshReply, AFaultComesBack) {
  for (int fault = 0; fault <= static_cast<int>(kLastMeshFault); ++fault) {
    try {
      read(errorReply("reason", static_cast<MeshFault>(fault)));
      ADD_FAILURE() << "no error";
    } catch (const MeshError& error) {
      EXPECT_EQ(static_cast<int>(error.fault()), fault);
    }
  }
}

TEST(MeshReply, OfAReasonOnlyPrintableTextIsKept) {
  EXPECT_EQ(reasonIn(errorReply("a\x1b[31m\xff\nb")), "a?[31m??b");
}

TEST(MeshReply, OfALongReasonTheBeginning) {
  EXPECT_EQ(reasonIn(errorReply(std::string(1000000, 'x'))).find_first_not_of('x'),
            std::string::npos);
  EXPECT_LT(errorReply(std::string(1000000, 'x')).size(), 10000u);
}

TEST(MeshReply, EveryTruncationIsSeen) {
  for (const std::string& reply :
       {replyOf(kMesh), replyOf({kMesh, kFiles}), errorReply("reason")}) {
    for (std::size_t size = 0; size < reply.size(); ++size)
      expectBroken(reply.substr(0, size), "ends early");
  }
}

TEST(MeshReply, NothingMayFollow) {
  expectBroken(replyOf(kMesh) + '\0', "does not end");
  expectBroken(replyOf({kMesh, kFiles}) + '/', "does not end");
  expectBroken(errorReply("reason") + 'x', "does not end");
}

TEST(MeshReply, AnotherMagicVersionOrStatus) {
  expectBroken(with(replyOf(kMesh), kMagic, 'X'), "of this version");
  expectBroken(with(replyOf(kMesh), kVersion, std::uint32_t(2)), "of this version");
  expectBroken(with(replyOf(kMesh), kStatus, kPastLast), "of this version");
  expectBroken(with(errorReply("reason"), kStatus, kPastLast), "of this version");
}

TEST(MeshReply, CountsThatContradictEachOther) {
  for (const Offset count : {kVertices, kTriangles})
    expectBroken(with(replyOf(kMesh), count, std::uint64_t(0)), "contradicts");
  expectBroken(with(replyOf(kMesh), kText, std::uint64_t(1)), "contradicts");
  for (const Offset count : {kVertices, kTriangles, kText})
    expectBroken(with(errorReply("reason"), count, std::uint64_t(1) << 40), "contradicts");
}

TEST(MeshReply, CountsAboveTheLimitTakeNoMemory) {
  for (const std::uint64_t lie : {std::uint64_t(1) << 31, std::uint64_t(1) << 32,
                                  std::uint64_t(1) << 62, ~std::uint64_t(0)}) {
    for (const Offset count : {kVertices, kTriangles})
      EXPECT_THROW(read(with(replyOf(kMesh), count, lie)), ReplyError);
    EXPECT_THROW(read(with(with(replyOf(kMesh), kVertices, lie), kTriangles, lie)), ReplyError);
  }
}

TEST(MeshReply, TheLimitIsThatOfVerticesAndTrianglesTogether) {
  constexpr std::uint64_t kBytes = 5 * 12;
  EXPECT_EQ(read(replyOf(kMesh), kBytes).vertices.size(), 3u);
  expectBroken(replyOf(kMesh), "more than 59 bytes", kBytes - 1);
}

TEST(MeshReply, AVertexThatIsNotFinite) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    TriangleMesh mesh = kMesh;
    mesh.vertices[2].y() = bad;
    expectBroken(replyOf(mesh), "not finite");
  }
}

TEST(MeshReply, ATriangleWithoutItsVertex) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    TriangleMesh mesh = kMesh;
    mesh.triangles[1][corner] = 3;
    expectBroken(replyOf(mesh), "without its vertex");
  }
}

}  // namespace
}  // namespace link_bounds
