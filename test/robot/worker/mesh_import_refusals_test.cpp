// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Files that give no valid mesh, and files that name other files.
#include <assimp/importerdesc.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <limits>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "robot/worker/mesh_import.h"
#include "robot/worker/mesh_text.h"
#include "testing/mesh_texts.h"
#include "testing/other_user.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

namespace fs = std::filesystem;

class ImportRefusals : public testing::Test {
 protected:
  TriangleMesh import(const std::string& name, const std::string& content) const {
    return importMesh({folder_.write("meshes/" + name, content), folder_ / "meshes"});
  }

  void expectRefused(const std::string& name, const std::string& content,
                     const std::string& reason = "", MeshFault fault = MeshFault::kFile) const {
    try {
      import(name, content);
      ADD_FAILURE() << name << " was accepted: " << content.substr(0, 200);
    } catch (const MeshError& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
      EXPECT_EQ(error.fault(), fault) << error.what();
    }
  }

  void expectRefusedWhenCutOff(const std::string& name, const std::string& whole) const;

  TemporaryFolder folder_;
};

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST_F(ImportRefusals, VerticesThatAreNotFinite) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    expectRefused("a.stl", binaryStl({{0, 0, 0}, {1, 0, 0}, {0, bad, 0}}), "not a finite number");
  }
  expectRefused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n", "not a finite number");
}

const std::string kOffVertices = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
const std::string kOffWithGoodIndex = kOffVertices + "3 0 1 2\n";
const std::string kOffWithBadIndex = kOffVertices + "3 0 1 9\n";

const std::string kPlyOfAFace =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string ply(const std::string& face) {
  return kPlyOfAFace + "0 0 0\n1 0 0\n0 1 0\n" + face + "\n";
}

TEST_F(ImportRefusals, AnIndexOfNoVertex) {
  EXPECT_EQ(import("good.ply", ply("3 0 1 2")).triangles.size(), 1u);
  expectRefused("a.ply", ply("3 0 1 3"), "face 0 names vertex 3 of 3");
  expectRefused("a.ply", ply("3 0 1 1000000000"), "face 0 names");
  expectRefused("a.ply", ply("3 0 1 -1"), "\"-1\" is no index of a vertex");
  expectRefused("a.ply", ply("5 0 1 2 0 7"), "face 0 names vertex 7 of 3");
  expectRefused("a.ply", ply("3 0 1 4294967298"), "\"4294967298\" is no index of a vertex");
}

TEST_F(ImportRefusals, AnIndexOfNoVertexInOtherFormats) {
  expectRefused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  expectRefused("a.off", kOffWithBadIndex, "out of range");
}

TEST_F(ImportRefusals, OneFileIsNotBlamedForWhatWasReadBefore) {
  folder_.write("meshes/good.off", kOffWithGoodIndex);
  for (int i = 0; i < 3; ++i) {
    expectRefused("bad.off", kOffWithBadIndex, "out of range");
    EXPECT_EQ(importMesh({folder_ / "meshes/good.off", folder_ / "meshes"}).triangles.size(), 1u);
  }
}

TEST_F(ImportRefusals, NoTriangle) {
  expectRefused("a.stl", binaryStl({}));
  expectRefused("a.stl", "solid nothing\nendsolid nothing\n");
  expectRefused("a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "no triangle");
  expectRefused("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n0 0 0\n");
}

TEST_F(ImportRefusals, TriangleStripsThatWouldBeMisread) {
  expectRefused("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                "property float z\nelement tristrips 1\n"
                "property list int int vertex_indices\nend_header\n"
                "0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n",
                "triangle strips");
}

TEST_F(ImportRefusals, AnEmptyOrTruncatedFile) {
  expectRefused("a.stl", "");
  expectRefused("a.dae", "");
  expectRefused("a.dae", "<COLLADA>");
  const std::string whole = binaryStl(tetrahedronCorners());
  expectRefused("a.stl", whole.substr(0, whole.size() - 60));
}

/// Each beginning of it, but those that only lack the last number's end: they are whole in form.
void ImportRefusals::expectRefusedWhenCutOff(const std::string& name,
                                             const std::string& whole) const {
  const Aabb box = boundsOf(import(name, whole));
  ASSERT_EQ(whole.back(), '\n');
  const std::size_t last = whole.find_last_of(" \n", whole.size() - 2) + 2;
  for (std::size_t size = 0; size < std::min(last, whole.size() - 1); ++size) {
    try {
      const Aabb found = boundsOf(import(name, whole.substr(0, size)));
      EXPECT_EQ(found.min(), box.min()) << name << ", bytes: " << size;
      EXPECT_EQ(found.max(), box.max()) << name << ", bytes: " << size;
    } catch (const MeshError&) {
    }
  }
}

TEST_F(ImportRefusals, ATextThatIsCutOffAnywhere) {
  expectRefusedWhenCutOff("a.stl", asciiStl(tetrahedronCorners()));
  expectRefusedWhenCutOff("a.off",
                          "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 7\n0 6 0\n"
                          "3 0 1 2\n3 0 1 4\n3 1 4 3\n");
  expectRefusedWhenCutOff("a.off",
                          "OFF 5 2 0 # counts\n# more\n0 0 0\n1 0 0\n0 1 0\n0 0 7\n"
                          "0 6 0\n\n4 0 1 4 2 255 0 0\n3 1 4 3\n");
  const std::string vertices =
      "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 5\nproperty float x\n"
      "property float y\nproperty float z\nelement face 3\n"
      "property list uchar int vertex_indices\n";
  expectRefusedWhenCutOff("a.ply", vertices +
                                       "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 7\n0 6 0\n"
                                       "3 0 1 2\n3 0 1 4\n3 1 4 3\n");
  // Faces as Cyberware writes them, and a second list; capitals are allowed.
  const std::string properties =
      "PLY\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement face 3\nproperty uchar intensity\nproperty list uchar float uv\n"
      "property list uchar int vertex_indices\nend_header\n";
  expectRefusedWhenCutOff("a.ply", properties +
                                       "0 0 0\n1 0 0\n0 1 0\n0 0 7\n0 6 0\n"
                                       "9 0 3 0 1 2\n9 1 0.5 3 0 1 4\n9 0 3 1 4 3\n");
}

TEST_F(ImportRefusals, ATextWithFewerLinesThanItSays) {
  expectRefused("a.off", kOffVertices + "", "ends before line 0 of faces");
  expectRefused("a.off", kOffVertices + "3 0 1\n", "too few numbers in line 0 of faces");
  expectRefused("a.ply", ply("3 0 1"), "too few numbers in line 0 of face");
  expectRefused("a.ply", ply(""), "ends before line 0 of face");
  expectRefused("a.stl",
                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                "vertex 0 1 0\nendloop\nendfacet\n",
                "endsolid");
  expectRefused("a.ply", ply("3.0 0 1 2"), "is no number of corners");
  expectRefused("a.off", kOffVertices + "10 0 1 2 0 1 2 0 1 2 0\n", "more corners than the 9");
}

/// The second line is part of a number, or was a property.
TEST_F(ImportRefusals, ADamagedPlyText) {
  const std::string good = ply("3 0 1 2");
  const auto expect = [&](const std::string& old_text, const std::string& text,
                          const std::string& reason) {
    std::string bad = good;
    bad.replace(bad.find(old_text), old_text.size(), text);
    expectRefused("a.ply", bad, reason);
  };
  expect("property float z", "properperty float z", "\"properperty\" is no word of its header");
  expect("property float z", std::string(16, '\0'), "is no word of its header");
  expect("property float z\n", "", "its vertices have no property z");
  expect("property float y", "property float x", "more than one property x");
  expect("1 0 0", "1 0 0.5 5", "too many numbers in line 1 of vertex");
  expect("3 0 1 2", "3 0 1 2.5", "\"2.5\" is no index of a vertex");
}

/// Assimp leaves out the properties that follow a comment.
TEST_F(ImportRefusals, APlyWithACommentBeforeAProperty) {
  const std::string good = ply("3 0 1 2");
  const auto with = [&](const std::string& behind, const std::string& line) {
    std::string text = good;
    return text.insert(text.find(behind) + behind.size(), line + "\n");
  };
  for (const std::string line : {"Comment", "OBJ_INFO a", "ply", "PLY", "format ascii 1.0",
                                 "Format ascii 1.0", "Element edge 0", "Property float y"})
    for (const char* const behind : {"float x\n", "float y\n"})
      expectRefused("a.ply", with(behind, line), "another line stands between");
  for (const std::string line : {"comment a b", "obj_info a b", "comment"}) {
    for (const char* const behind : {"ascii 1.0\n", "float z\n", "indices\n"})
      EXPECT_EQ(import("a.ply", with(behind, line)).triangles.size(), 1u) << behind;
    for (const char* const behind : {"vertex 3\n", "float x\n", "float y\n", "face 1\n"})
      expectRefused("a.ply", with(behind, line), "a comment or another line stands between");
    expectRefused("a.ply", with("ply\n", line), "a comment stands before the format");
  }
  expectRefused("a.ply", with("float x\n", "comment\nproperty float q"), "property \"y\"");
}

/// As MeshLab writes the camera. Assimp takes its numbers for those of the next element.
TEST_F(ImportRefusals, APlyWithAnUnknownElementBeforeItsFaces) {
  const std::string camera = "element camera 1\nproperty float view_px\n";
  const auto with = [&](const std::string& before, const std::string& elements) {
    std::string text = ply("3 0 1 2");
    return text.insert(text.find(before), elements);
  };
  for (const char* const before : {"element vertex", "element face"})
    expectRefused("a.ply", with(before, camera), "because it does not know \"camera\" before it");
  EXPECT_EQ(import("a.ply", with("end_header", camera) + "7\n").triangles.size(), 1u);
  EXPECT_EQ(import("a.ply", with("element vertex", "element camera 0\n")).triangles.size(), 1u);
}

TEST_F(ImportRefusals, APlyWithAnUnknownType) {
  for (const char* const type : {"flat", "FLOAT"}) {
    std::string text = ply("3 0 1 2");
    expectRefused("a.ply", text.replace(text.find("float y"), 5, type),
                  std::string("unknown type \"") + type);
  }
}

/// A quad whose 4 became a 3 looks like a triangle with a colour.
TEST_F(ImportRefusals, APlyFaceThatLostCorners) {
  std::string two = kPlyOfAFace;
  two.replace(two.find("face 1"), 6, "face 2");
  const auto faces = [&](const std::string& text) {
    return two + "0 0 0\n1 0 0\n0 1 0\n" + text + "\n";
  };
  EXPECT_EQ(import("a.ply", faces("3 0 1 2 255 0 0\n3 0 2 1 0 0 9")).triangles.size(), 2u);
  expectRefused("a.ply", faces("4 0 1 2 0\n3 0 2 1 0"), "follow the corners in line 1 of face");
  expectRefused("a.ply", faces("3 0 2 1 0\n4 0 1 2 0"), "follow the corners in line 1 of face");
}

/// Assimp takes three of four numbers, and no more parts where something else follows one.
TEST_F(ImportRefusals, ADamagedStlText) {
  const std::string part = asciiStl(tetrahedronCorners());
  EXPECT_EQ(import("a.stl", part + "\n \n" + part).triangles.size(), 8u);
  EXPECT_EQ(import("a.stl", part + "# end\n").triangles.size(), 4u);
  for (const char* const between : {"# part 2\n", "Solid b\n", "solid", "\x1A\n"})
    expectRefused("a.stl", part + between + part, "no line \"solid\" follows an \"endsolid\"");
  std::string four = part;
  four.replace(four.find("0.000000"), 8, "0.0 0000");
  expectRefused("a.stl", four, "more than 3 numbers, in line 4");
  const std::string line = "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 9";
  expectRefused("a.stl", part + "# part 2\n" + line + " endloop endfacet\n", "no line \"solid\"");
  expectRefused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 .1 8 9\n3 0 1 2\n", "line 2 of vertices");
}

TEST_F(ImportRefusals, ADamagedObj) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 9\nf 1 2 3\n";
  const auto triangles = [&](const std::string& rest) {
    return import("a.obj", vertices + rest).triangles.size();
  };
  for (const char* const face : {"f 1 2 4", "f -4 -3 -1", "f\t1 2 4 \r"})
    EXPECT_EQ(triangles(std::string(face) + "\n"), 2u) << face;
  for (const char* const other : {"s off", "usemtl a", "g", "vp 1 2", "# any words", "\t", "o x y"})
    EXPECT_EQ(triangles(std::string("f 1 2 4\n") + other + "\n"), 2u) << other;
  for (const char* const first : {"\xEF\xBB\xBF# made by hand\n", "\xEF\xBB\xBFmtllib a.mtl\n",
                                  "\xEF\xBB\xBF\n", "// made by hand\n"})
    EXPECT_EQ(import("a.obj", first + vertices + "\x1A").triangles.size(), 1u) << first;
  expectRefused("a.obj", vertices + "F 1 2 4\n", "\"F\" is no word of OBJ, in line 6");
  expectRefused("a.obj", vertices + "x 1 2 4\n", "is no word of OBJ");
  expectRefused("a.obj", "\xEF\xBB\xBF" + vertices,
                "line 1, because it begins with a byte order mark");
  expectRefused("a.obj", vertices + "f 1 /2 4\n", "\"/2\" is no corner, in line 6");
  expectRefused("a.obj", vertices + "f +1 2 4\n", "is no corner");
  expectRefused("a.obj", vertices + "f 1 2-2 4\n", "\"2-2\" is no corner");
  expectRefused("a.obj", vertices + "f 1 2 a4\n", "is no corner");
  for (const char* const begin : {"", "f 1 2 ", "# "})
    expectRefused("a.obj", vertices + begin + std::string(512, '\0') + "\nf 1 2 4\n",
                  "a byte 0 is in line 6");
}

TEST_F(ImportRefusals, ABinaryFileThatBeginsLikeAPlyIsNone) {
  EXPECT_EQ(import("a.stl", binaryStl(tetrahedronCorners(), "ply2stl output")).triangles.size(),
            4u);
}

TEST_F(ImportRefusals, ANumberThatIsTooLarge) {
  const std::string rest = "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(import("a.obj", "v 1e20 0 0" + rest).triangles.size(), 1u);
  expectRefused("a.obj", "v 100000000000000000000 0 0" + rest, "overflow");
}

TEST_F(ImportRefusals, ButNotWhatIsOnlyLooks) {
  const std::string obj =
      "mtllib none.mtl\nusemtl none\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl none\nf 1 2 3\np 1/1\nf\n";
  EXPECT_EQ(import("a.obj", obj).triangles.size(), 1u);
}

/// What some compilers print for NaN and infinity, Fortran's exponent, and others of which a reader
/// may take the beginning.
constexpr std::array kNoNumbers{"1.#INF", "-1.#IND", "1.#QNAN", "9D5", "0x99", "9,999.5", "9_9"};
constexpr std::array kNumbers{"9",    "+9",   "-0",  "9.",     "09.5",   "9,5",
                              "1.e1", "1E+1", "9e0", "0.9e-2", "-9.0E0", "99999.123456789012345"};

std::string stlText(const std::string& number, const std::string& name = "a b") {
  return "solid " + name +
         "\n  facet normal 0 0 1\n\touter loop\nvertex 0 0 0\r\nvertex\t1  0 0\n" + " vertex 0 1 " +
         number + " \nendloop\nendfacet\nendsolid vertex\n";
}

std::string plyText(const std::string& number) {
  return kPlyOfAFace + "0 0 0\r\n1 0 0\r\n0 1 " + number + "\r\n3 0 1 2\r\n";
}

/// Each with one number to choose.
std::vector<std::pair<std::string, std::string>> textsWith(const std::string& number) {
  return {{"a.stl", stlText(number)},
          {"stl", stlText(number)},
          {"obj", "# by hand\nv 0 0 0\nv 1 0 0\nv 0 1 " + number + "\nf 1 2 3\n"},
          {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 " + number + "\nf 1 2 3\n"},
          {"a.ply", plyText(number)},
          {"a.off", "OFF\n3 1 0\n0 0 0 # 9_9\n1 0 0\n0 1 " + number + "\n3 0 1 2 0.5 0 0\n"}};
}

TEST_F(ImportRefusals, WhatIsNoNumberToItsEnd) {
  for (const char* const number : kNumbers) {
    for (const auto& [name, text] : textsWith(number)) {
      SCOPED_TRACE(name + " with " + number);
      EXPECT_EQ(import(name, text).triangles.size(), 1u);
    }
  }
  for (const char* const number : kNoNumbers) {
    for (const auto& [name, text] : textsWith(number))
      expectRefused(name, text, number);
  }
  expectRefused("a.stl", stlText("1.#INF"), "\"1.#INF\" is no real number, in line 6");
  expectRefused("a.obj", "v 0 0 0\nv 1.#IND 0 0\nv 0 1 0\nf 1 2 3\n", "in line 2");
}

TEST_F(ImportRefusals, ButNotWhatExportersWrite) {
  EXPECT_EQ(import("a.stl", stlText("1", "vertex model") + stlText("1", "")).triangles.size(), 2u);
  const std::string obj =
      "# Blender 3.6 \\ C:\\\n\n\tg none\nmtllib a.mtl\no 1.#INF\nv 0 -.5 0 0.1 0.2 0.3\r\n"
      "v\t1\t0\t0\nv  0 1 0 1.0 # \nv 0 0 \\\n1\nvn 0 0 1\nvt 0.5 0.5\ng a b\ns off\nf 1 2 \\\n 3\n"
      "f -1 -2 -3\nl 1 2\n# end\\\n\n";
  EXPECT_EQ(import("a.obj", obj).triangles.size(), 2u);
}

TEST_F(ImportRefusals, LinesOfObjThatAreLeftOut) {
  const auto expectLost = [&](const std::string& line, const std::string& reason) {
    expectRefused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + line + "\nf 1 3 2\n", reason);
  };
  expectLost("v 0 .5 9", "number that begins with \".\", in line 5; write 0 before it");
  expectLost("v 0 0 9 1 1 0 0", "a vertex of 7 numbers, in line 5; write 3, 4 or 6");
  expectLost("v 0 9", "a vertex of 2 numbers");
  expectLost("v 0 0 0 \\\n9 9", "a vertex of 5 numbers, in line 6");
  expectLost(" v 0 0 9", "leaves out line 5, because it begins with a blank");
  expectLost("\tf 1 3 2", "leaves out line 5, because it begins with a blank");
  for (const char* const line : {"# C:\\meshes\\", "g a\\", "usemtl a\\"})
    expectLost(line, "leaves out line 6, because the one before it ends in a backslash");
  for (const std::string word : {"surf", "bsp", "bzp", "cdp", "call"})
    expectLost(word + " 0 1 0 1 1 2 3", "the faces of \"" + word + "\", in line 5");
}

TEST_F(ImportRefusals, AFacetInCapitals) {
  std::string text = asciiStl(tetrahedronCorners());
  const std::string facet =
      text.substr(text.find("facet"), text.find("endfacet") - text.find("facet"));
  for (const std::string word : {"facet", "vertex"}) {
    std::string changed = facet;
    for (std::size_t at = changed.find(word); at != changed.npos; at = changed.find(word, at + 1))
      changed[at] = static_cast<char>(std::toupper(changed[at]));
    std::string mixed = text;
    mixed.replace(mixed.rfind("facet normal"), 0, changed + "endfacet\n");
    expectRefused("a.stl", mixed, "; write it in small letters");
  }
  EXPECT_EQ(
      import("a.stl", "solid of a Vertex\n" + text.substr(text.find('\n') + 1)).triangles.size(),
      4u);
}

TEST_F(ImportRefusals, AWrongIndexThatIsNotInTheMesh) {
  expectRefused("a.off", kOffVertices + "3 0 1 -1\n", "\"-1\" is no index of a vertex, in line 0");
}

TEST_F(ImportRefusals, AFileWithMoreThanItSays) {
  const std::string reason = "more data than its header says";
  expectRefused("a.ply", ply("3 0 1 2\n3 0 2 1"), reason);
  expectRefused("a.off", kOffWithGoodIndex + "3 0 2 1\n", reason);
}

/// Vertices, then faces with a colour, which are four and two.
std::string binaryPly(bool is_big_endian, int vertices, int faces) {
  const auto bytes = [&](auto value) {
    std::string result = bytesOf(value);
    if (is_big_endian) std::reverse(result.begin(), result.end());
    return result;
  };
  std::string text = std::string("ply\r\nformat binary_") + (is_big_endian ? "big" : "little") +
                     "_endian 1.0\r\nelement vertex " + std::to_string(vertices) +
                     "\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n" +
                     "element face " + std::to_string(faces) +
                     "\r\nproperty list uint8 int32 vertex_indices\r\nproperty uchar red\r\n" +
                     "end_header\r\n";
  for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 7.f})
    text += bytes(number);
  for (const std::int32_t last : {2, 3})
    text += '\3' + bytes(std::int32_t{0}) + bytes(std::int32_t{1}) + bytes(last) + '\n';
  return text;
}

TEST_F(ImportRefusals, ABinaryPlyOfAnotherSizeThanItSays) {
  for (const bool is_big_endian : {false, true}) {
    const std::string whole = binaryPly(is_big_endian, 4, 2);
    EXPECT_EQ(import("a.ply", whole).triangles.size(), 2u);
    EXPECT_EQ(import("a.ply", whole + "\r\n").triangles.size(), 2u);
    expectRefused("a.ply", binaryPly(is_big_endian, 4, 1), "more data than its header says");
    for (const auto& [vertices, faces] : {std::pair(4, 3), {3, 2}, {5, 2}, {6, 2}, {1000000000, 2}})
      expectRefused("a.ply", binaryPly(is_big_endian, vertices, faces));
    expectRefused("a.ply", whole.substr(0, whole.size() - 1), "too few bytes");
  }
}

/// Assimp skips it as the end of a line, and reads the rest one byte too early.
TEST_F(ImportRefusals, ABinaryPlyWhoseFirstByteIsALineFeed) {
  for (const char byte : {'\n', '\r', ' ', '\0'}) {
    for (const bool has_cr : {false, true}) {
      std::string file = binaryPly(false, 4, 2);
      const std::string end = "end_header\r\n";
      file[file.find(end) + end.size()] = byte;
      std::string header = file.substr(0, file.find(end) + end.size());
      const std::string data = file.substr(header.size());
      if (!has_cr) header.erase(std::remove(header.begin(), header.end(), '\r'), header.end());
      if (byte == '\n' && !has_cr)
        expectRefused("a.ply", header + data, "the first byte of its data, 0x0A");
      else
        EXPECT_EQ(import("a.ply", header + data).triangles.size(), 2u) << int{byte} << has_cr;
    }
  }
}

TEST_F(ImportRefusals, AFileWhoseNameHidesItsFormat) {
  expectRefused("3f2a77", binaryStl(tetrahedronCorners()), "its content does not tell its format",
                MeshFault::kFormat);
  expectRefused("a.txt", "what is this", "its content does not tell its format",
                MeshFault::kFormat);
  EXPECT_EQ(import("3f2a78", asciiStl(tetrahedronCorners())).triangles.size(), 4u);
  EXPECT_EQ(import("a.unknown", kOffWithGoodIndex).triangles.size(), 1u);
}

TEST_F(ImportRefusals, FormatsOfWhichNobodyKnowsWhatAssimpLeavesOut) {
  const Assimp::Importer importer;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    std::istringstream extensions(importer.GetImporterInfo(i)->mFileExtensions);
    for (std::string extension; extensions >> extension;) {
      const std::set<std::string> known{"stl", "obj", "ply", "off", "dae", "gltf", "glb", "vrm"};
      if (known.count(extension) > 0) continue;
      expectRefused("a." + extension, "x", "only STL, OBJ, PLY, OFF, Collada and glTF are read",
                    MeshFault::kFormat);
      ++refused;
    }
  }
  EXPECT_GT(refused, 30u);
  expectRefused("A.FBX", "x", "leaves out of .fbx files", MeshFault::kFormat);
}

/// Without a name that tells it, assimp asks all its readers, and that of OBJ takes this one.
TEST_F(ImportRefusals, OnlyReadersOfTheFormatThatWasCheckedAreAsked) {
  EXPECT_EQ(import("3f2a79", stlText("1", "part v 2")).triangles.size(), 1u);
}

TEST_F(ImportRefusals, AMissingFile) {
  EXPECT_THROW(importMesh({folder_ / "missing.stl", folder_.path().string()}), MeshError);
}

TEST_F(ImportRefusals, AFileOutsideItsOwnRoot) {
  const std::string path = folder_.write("elsewhere/a.stl", binaryStl(tetrahedronCorners()));
  fs::create_directories(folder_ / "meshes");
  EXPECT_THROW(importMesh({path, folder_ / "meshes"}), MeshError);
}

std::string threeVertices() {
  std::string result;
  for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) {
    result += bytesOf(number);
  }
  return result;
}

TEST_F(ImportRefusals, ABufferBesideTheMeshIsRead) {
  folder_.write("meshes/data.bin", threeVertices());
  EXPECT_EQ(import("a.gltf", gltf("data.bin")).vertices.size(), 3u);
}

TEST_F(ImportRefusals, ABufferThatMayNotBeRead) {
  const std::string mesh = folder_.write("meshes/a.gltf", gltf("a.bin"));
  const std::string buffer = folder_.write("meshes/a.bin", std::string(36, '\0'));
  fs::permissions(buffer, fs::perms::none);
  for (const std::string& folder : {folder_.path().string(), folder_ / "meshes"})
    fs::permissions(folder, fs::perms(0755));
  const OtherUser nobody;
  try {
    importMesh({mesh, folder_ / "meshes"});
    ADD_FAILURE() << "it was accepted";
  } catch (const MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("this user may not read " + buffer), std::string::npos)
        << error.what();
    EXPECT_EQ(error.fault(), MeshFault::kUnreadable);
  }
}

TEST_F(ImportRefusals, AnExtensionThatMovesVertices) {
  folder_.write("meshes/data.bin", threeVertices());
  const std::string used = R"({"extensionsUsed":["KHR_materials_unlit","KHR_mesh_quantization"],)";
  expectRefused("a.gltf", used + gltf("data.bin").substr(1), "KHR_mesh_quantization");
  const std::string harmless = R"({"extensionsUsed":["KHR_materials_unlit"],)";
  EXPECT_EQ(import("a.gltf", harmless + gltf("data.bin").substr(1)).triangles.size(), 1u);
}

TEST_F(ImportRefusals, AnExtensionThatIsRequiredAndUnknown) {
  folder_.write("meshes/data.bin", threeVertices());
  const auto required = [](const std::string& name) {
    return R"({"extensionsRequired":[")" + name + R"("],)" + gltf("data.bin").substr(1);
  };
  EXPECT_EQ(import("a.gltf", required("KHR_materials_unlit")).triangles.size(), 1u);
  expectRefused("a.gltf", required("FOO_bar"), "the extension FOO_bar, which assimp does not know");
  expectRefused("a.gltf", required("KHR\\u005fmesh_quantization"), "KHR_mesh_quantization");
}

/// In the name of a folder of Windows; taken for one, it would hide what follows.
TEST_F(ImportRefusals, ABackslashBeforeAnUIsNoReference) {
  folder_.write("meshes/data.bin", threeVertices());
  const std::string folder = R"({"extras":"C:\\u",)";
  EXPECT_EQ(import("a.gltf", folder + gltf("data.bin").substr(1)).triangles.size(), 1u);
  expectRefused("a.gltf",
                folder + R"("extensionsRequired":["FOO_bar"],)" + gltf("data.bin").substr(1),
                "the extension FOO_bar");
}

TEST_F(ImportRefusals, PositionsThatAreNoFloats) {
  folder_.write("meshes/data.bin", threeVertices());
  std::string text = gltf("data.bin");
  text.replace(text.find("5126"), 4, "5122");
  expectRefused("a.gltf", text, "positions of mesh 0 are no floats");
}

/// As Blender writes it.
TEST_F(ImportRefusals, ABufferIsNamedByAUri) {
  folder_.write("meshes/my data.bin", threeVertices());
  EXPECT_EQ(import("a.gltf", gltf("my%20data.bin")).vertices.size(), 3u);
  folder_.write("meshes/50%20.bin", threeVertices());
  EXPECT_EQ(import("a.gltf", gltf("50%20.bin")).vertices.size(), 3u) << "that is its name";
  expectRefused("a.gltf", gltf("%2e%2e/secret.bin"));
  folder_.write("meshes/v 1/other data.bin", threeVertices());
  expectRefused("v%201/a.gltf", gltf("other%20data.bin"), "could not open");
}

/// Assimp leaves them out, or reads other numbers.
TEST_F(ImportRefusals, ADamagedGltf) {
  folder_.write("meshes/data.bin", threeVertices());
  const auto expect = [&](const std::string& old_text, const std::string& text,
                          const std::string& reason) {
    std::string bad = gltf("data.bin");
    expectRefused("a.gltf", bad.replace(bad.find(old_text), old_text.size(), text), reason);
  };
  const std::string node = R"({"mesh":0})";
  expect(node, R"({"mesh":0,"childrem":[1]})", "node 0 has the member \"childrem\"");
  expect(node, R"({"mesh":0,"translation":[0,50]})", "the translation of node 0 is not of 3");
  expect(node, R"({"mesh":0,"translation":["0","0","5"]})",
         "the translation of node 0 is not of 3");
  expect(node, R"({"mesh":0,"rotation":7})", "the rotation of node 0 is not of 4 numbers");
  expect(node, R"({"mesh":0,"mesh":0})", "node 0 has two members \"mesh\"");
  for (const char* const type : {"VEC2", "vec3", ""})
    expect("VEC3", type, "not VEC3");
  expect("\"count\"", "\"cound\"", "accessor 0 has the member \"cound\"");
  expect("\"byteLength\":36}]", "\"byteLength\":36,\"byteStride\":4}]", "byteStride below 12");
  expect(R"("POSITION":0})", R"("POSITION":0},"indices":0)", "indices of mesh 0 are no unsigned");
  expect(R"("POSITION":0})", R"("POSITION":0},"modes":4)", "a primitive of mesh 0 has the member");
  std::string good = gltf("data.bin");
  good.replace(good.find(node), node.size(),
               R"({"mesh":0,"name":"a","translation":[0,0,1],"extras":{"mesh":1}})");
  EXPECT_EQ(import("a.gltf", good).triangles.size(), 1u);
}

TEST_F(ImportRefusals, ABufferAboveTheLimitIsNot) {
  const std::string buffer(10000, '\0');
  folder_.write("meshes/data.bin", threeVertices() + buffer);
  const MeshFile mesh{folder_.write("meshes/a.gltf", gltf("data.bin")), folder_ / "meshes"};
  const std::uint64_t size = threeVertices().size() + buffer.size();
  EXPECT_EQ(importMesh(mesh, size).vertices.size(), 3u);
  try {
    importMesh(mesh, size - 1);
    ADD_FAILURE() << "not refused";
  } catch (const MeshError& error) {
    EXPECT_EQ(error.fault(), MeshFault::kTooLarge) << error.what();
    EXPECT_NE(std::string(error.what()).find("data.bin has 10036 bytes"), std::string::npos);
  }
}

TEST_F(ImportRefusals, TheBytesOfAllFilesAreAddedUpEachOnce) {
  folder_.write("meshes/data.bin", threeVertices());
  const MeshFile mesh{folder_.write("meshes/a.gltf", gltf("data.bin")), folder_ / "meshes"};
  std::set<std::uint64_t> sums;
  importMesh(mesh, 10000, [&sums](std::uint64_t bytes) { sums.insert(bytes); });
  const std::uint64_t alone = gltf("data.bin").size();
  EXPECT_EQ(sums, (std::set<std::uint64_t>{alone, alone + threeVertices().size()}));
}

TEST_F(ImportRefusals, ABufferOutsideTheRootIsNot) {
  const std::string secret = folder_.write("secret.bin", threeVertices());
  expectRefused("a.gltf", gltf("../secret.bin"));
  expectRefused("a.gltf", gltf(secret));
  expectRefused("a.gltf", gltf("x/../../secret.bin"));
}

TEST_F(ImportRefusals, NorOneBehindASymlink) {
  const std::string secret = folder_.write("secret.bin", threeVertices());
  fs::create_directories(folder_ / "meshes");
  fs::create_symlink(secret, folder_ / "meshes/data.bin");
  expectRefused("a.gltf", gltf("data.bin"));
}

TEST_F(ImportRefusals, AFifoBesideTheMeshIsNotOpened) {
  fs::create_directories(folder_ / "meshes");
  ASSERT_EQ(mkfifo((folder_ / "meshes/pipe").c_str(), 0600), 0);
  expectRefused("a.gltf", gltf("pipe"));
  const std::string obj = "mtllib pipe\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(import("a.obj", obj).triangles.size(), 1u);
}

}  // namespace
}  // namespace link_bounds
