// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is written comes back; what lies is refused before memory is taken for it.
#include "robot/worker/mesh_frame.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "testing/mesh_texts.h"

namespace link_bounds {
namespace {

constexpr std::uint64_t kMaxBytes = 1000;

/// A status that no frame has.
constexpr std::uint32_t kPastLast = 2 + static_cast<std::uint32_t>(kLastMeshFault);

const TriangleMesh kMesh{{{0, 0, 0}, {1, 2, 3}, {-4, 5e-40f, 3e38f}}, {{0, 1, 2}, {2, 1, 0}}};

ByteSink appendTo(std::string& out) {
  return [&out](const void* bytes, std::size_t count) {
    out.append(static_cast<const char*>(bytes), count);
  };
}

std::string frameOf(const TriangleMesh& mesh) {
  std::string bytes;
  writeMeshFrame(mesh, appendTo(bytes));
  return bytes;
}

std::string errorFrame(const std::string& reason, MeshFault fault = MeshFault::kFile) {
  std::string bytes;
  writeErrorFrame(MeshError(reason, fault), appendTo(bytes));
  return bytes;
}

/// Bytes of the frame's head.
enum Offset { kMagic = 0, kVersion = 8, kStatus = 12, kVertices = 16, kTriangles = 24, kText = 32 };

template <class Value>
std::string with(std::string frame, std::size_t offset, Value value) {
  std::memcpy(&frame[offset], &value, sizeof(value));
  return frame;
}

TriangleMesh read(const std::string& frame, std::uint64_t max_bytes = kMaxBytes) {
  std::size_t next = 0;
  const auto source = [&](void* out, std::size_t wanted) {
    const std::size_t count = std::min(wanted, frame.size() - next);
    std::memcpy(out, frame.data() + next, count);
    next += count;
    return count;
  };
  return readMeshFrame(source, max_bytes);
}

void expectBroken(const std::string& frame, const std::string& words,
                  std::uint64_t max_bytes = kMaxBytes) {
  try {
    read(frame, max_bytes);
    ADD_FAILURE() << "not refused: " << words;
  } catch (const FrameError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

std::string reasonIn(const std::string& frame) {
  try {
    read(frame);
  } catch (const FrameError& error) {
    return std::string("broken: ") + error.what();
  } catch (const MeshError& error) {
    return error.what();
  }
  return "no error";
}

TEST(MeshFrame, AMeshComesBack) {
  const TriangleMesh mesh = read(frameOf(kMesh));
  EXPECT_EQ(mesh.vertices, kMesh.vertices);
  EXPECT_EQ(mesh.triangles, kMesh.triangles);
}

TEST(MeshFrame, AReasonComesBackAsAnOrdinaryError) {
  EXPECT_EQ(reasonIn(errorFrame("it has no triangle")), "it has no triangle");
  EXPECT_EQ(reasonIn(errorFrame("")), "");
}

TEST(MeshFrame, AFaultComesBack) {
  for (int fault = 0; fault <= static_cast<int>(kLastMeshFault); ++fault) {
    try {
      read(errorFrame("reason", static_cast<MeshFault>(fault)));
      ADD_FAILURE() << "no error";
    } catch (const MeshError& error) {
      EXPECT_EQ(static_cast<int>(error.fault()), fault);
    }
  }
}

TEST(MeshFrame, OfAReasonOnlyPrintableTextIsKept) {
  EXPECT_EQ(reasonIn(errorFrame("a\x1b[31m\xff\nb")), "a?[31m??b");
}

TEST(MeshFrame, OfALongReasonTheBeginning) {
  EXPECT_EQ(reasonIn(errorFrame(std::string(1000000, 'x'))).find_first_not_of('x'),
            std::string::npos);
  EXPECT_LT(errorFrame(std::string(1000000, 'x')).size(), 10000u);
}

TEST(MeshFrame, EveryTruncationIsSeen) {
  for (const std::string& frame : {frameOf(kMesh), errorFrame("reason")}) {
    for (std::size_t size = 0; size < frame.size(); ++size)
      expectBroken(frame.substr(0, size), "ends early");
  }
}

TEST(MeshFrame, NothingMayFollow) {
  expectBroken(frameOf(kMesh) + '\0', "does not end");
  expectBroken(errorFrame("reason") + 'x', "does not end");
}

TEST(MeshFrame, AnotherMagicVersionOrStatus) {
  expectBroken(with(frameOf(kMesh), kMagic, 'X'), "of this version");
  expectBroken(with(frameOf(kMesh), kVersion, std::uint32_t(1)), "of this version");
  expectBroken(with(frameOf(kMesh), kStatus, kPastLast), "of this version");
  expectBroken(with(errorFrame("reason"), kStatus, kPastLast), "of this version");
}

TEST(MeshFrame, CountsThatContradictEachOther) {
  for (const Offset count : {kVertices, kTriangles})
    expectBroken(with(frameOf(kMesh), count, std::uint64_t(0)), "contradicts");
  expectBroken(with(frameOf(kMesh), kText, std::uint64_t(1)), "contradicts");
  for (const Offset count : {kVertices, kTriangles, kText})
    expectBroken(with(errorFrame("reason"), count, std::uint64_t(1) << 40), "contradicts");
}

TEST(MeshFrame, CountsAboveTheLimitTakeNoMemory) {
  for (const std::uint64_t lie : {std::uint64_t(1) << 31, std::uint64_t(1) << 32,
                                  std::uint64_t(1) << 62, ~std::uint64_t(0)}) {
    for (const Offset count : {kVertices, kTriangles})
      EXPECT_THROW(read(with(frameOf(kMesh), count, lie)), FrameError);
    EXPECT_THROW(read(with(with(frameOf(kMesh), kVertices, lie), kTriangles, lie)), FrameError);
  }
}

TEST(MeshFrame, TheLimitIsThatOfVerticesAndTrianglesTogether) {
  constexpr std::uint64_t kBytes = 5 * 12;
  EXPECT_EQ(read(frameOf(kMesh), kBytes).vertices.size(), 3u);
  expectBroken(frameOf(kMesh), "more than 59 bytes", kBytes - 1);
}

TEST(MeshFrame, AVertexThatIsNotFinite) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    TriangleMesh mesh = kMesh;
    mesh.vertices[2].y() = bad;
    expectBroken(frameOf(mesh), "not finite");
  }
}

TEST(MeshFrame, ATriangleWithoutItsVertex) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    TriangleMesh mesh = kMesh;
    mesh.triangles[1][corner] = 3;
    expectBroken(frameOf(mesh), "without its vertex");
  }
}

}  // namespace
}  // namespace link_bounds
