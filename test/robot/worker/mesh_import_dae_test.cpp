// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Collada as rviz draws it: units and node transforms count, the up axis does not.
#include <gtest/gtest.h>

#include "robot/worker/mesh_import.h"
#include "testing/brute_force.h"
#include "testing/mesh_texts.h"
#include "testing/numbers.h"
#include "testing/refusal.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

using brute_force::turned;

constexpr double kTolerance = 1e-6;  // metres; node matrices are float32 in assimp

/// Four vertices of a tetrahedron with legs of 1, 2 and 3, and one far away.
const std::string kDaeVertices = "0 0 0  1 0 0  0 2 0  0 0 3  99 99 99";
const std::string kDaeTriangles =
    "<triangles count='4'><input semantic='VERTEX' source='#v' offset='0'/>"
    "<p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>";
const std::string kInstance = "<instance_geometry url='#g'/>";
const std::string kMetres = "<unit meter='1'/>";

std::string dae(const std::string& asset, const std::string& scene,
                const std::string& primitives = kDaeTriangles) {
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
         "version='1.4.1'><asset>" +
         asset +
         "</asset><library_geometries><geometry id='g'><mesh>"
         "<source id='p'><float_array id='f' count='15'>" +
         kDaeVertices +
         "</float_array>"
         "<technique_common><accessor source='#f' count='5' stride='3'><param name='X' "
         "type='float'/><param name='Y' type='float'/><param name='Z' type='float'/></accessor>"
         "</technique_common></source><vertices id='v'><input semantic='POSITION' source='#p'/>"
         "</vertices>" +
         primitives +
         "</mesh></geometry></library_geometries>"
         "<library_visual_scenes><visual_scene id='s'>" +
         scene +
         "</visual_scene>"
         "</library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

std::string node(const std::string& content) {
  return "<node>" + content + "</node>";
}

TriangleMesh importDae(const std::string& content, const std::string& name = "a.dae") {
  const TemporaryFolder folder;
  return importMesh({folder.write(name, content), folder.path().string()});
}

void expectBounds(const TriangleMesh& mesh, const Aabb& expected) {
  EXPECT_LE((boundsOf(mesh).min() - expected.min()).cwiseAbs().maxCoeff(), kTolerance)
      << boundsOf(mesh).min().transpose();
  EXPECT_LE((boundsOf(mesh).max() - expected.max()).cwiseAbs().maxCoeff(), kTolerance)
      << boundsOf(mesh).max().transpose();
}

/// The box of the tetrahedron under a pose.
Aabb posed(const Eigen::Affine3d& pose) {
  return brute_force::box(tetrahedronCorners(), pose);
}

TEST(ImportDae, PlainNode) {
  const TriangleMesh mesh = importDae(dae(kMetres, node(kInstance)));
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  expectBounds(mesh, posed(kIdentity));
}

TEST(ImportDae, ExtensionInUpperCase) {
  expectBounds(importDae(dae(kMetres, node(kInstance)), "A.DAE"), posed(kIdentity));
}

TEST(ImportDae, UpAxisDoesNotTurnTheMesh) {
  for (const char* axis : {"X_UP", "Y_UP", "Z_UP"}) {
    SCOPED_TRACE(axis);
    const std::string asset = kMetres + "<up_axis>" + axis + "</up_axis>";
    expectBounds(importDae(dae(asset, node(kInstance))), posed(kIdentity));
  }
}

TEST(ImportDae, UnitScalesTheMeshOnce) {
  expectBounds(importDae(dae("<unit meter='0.01'/>", node(kInstance))),
               posed(Eigen::Affine3d(Eigen::Scaling(0.01))));
}

TEST(ImportDae, UnitCountsWhateverIsUp) {
  for (const char* axis : {"X_UP", "Y_UP", "Z_UP"}) {
    SCOPED_TRACE(axis);
    const std::string asset = std::string("<unit meter='0.0254'/><up_axis>") + axis + "</up_axis>";
    expectBounds(importDae(dae(asset, node(kInstance))),
                 posed(Eigen::Affine3d(Eigen::Scaling(0.0254))));
  }
}

TEST(ImportDae, NodeTransformsCount) {
  Eigen::Affine3d pose(turned(30, Eigen::Vector3d::UnitZ()));
  pose.pretranslate(Eigen::Vector3d(1, 2, 3)).scale(Eigen::Vector3d(1, 2, 0.5));
  expectBounds(importDae(dae(kMetres, node("<translate>1 2 3</translate><rotate>0 0 1 30</rotate>"
                                           "<scale>1 2 0.5</scale>" +
                                           kInstance))),
               posed(pose));
}

TEST(ImportDae, NestedNodesAreComposed) {
  Eigen::Affine3d outer(turned(45, Eigen::Vector3d::UnitX()));
  outer.pretranslate(Eigen::Vector3d(1, 0, 0));
  Eigen::Affine3d inner(turned(30, Eigen::Vector3d::UnitY()));
  inner.pretranslate(Eigen::Vector3d(0, 0, 5));
  const std::string content =
      node("<translate>1 0 0</translate><rotate>1 0 0 45</rotate>" +
           node("<translate>0 0 5</translate><rotate>0 1 0 30</rotate>" + kInstance));
  expectBounds(importDae(dae(kMetres, content)), posed(outer * inner));
}

TEST(ImportDae, NodeTransformsAreInTheUnitOfTheFile) {
  const std::string asset = "<unit meter='0.01'/><up_axis>Y_UP</up_axis>";
  Eigen::Affine3d pose(0.01 * turned(30, Eigen::Vector3d::UnitZ()));
  pose.pretranslate(Eigen::Vector3d(1, 0, 0));
  expectBounds(importDae(dae(asset, node("<translate>100 0 0</translate><rotate>0 0 1 30</rotate>" +
                                         kInstance))),
               posed(pose));
}

TEST(ImportDae, AMirroredNodeMirrors) {
  expectBounds(importDae(dae(kMetres, node("<scale>-1 1 1</scale>" + kInstance))),
               posed(Eigen::Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0))));
}

TEST(ImportDae, AMatrixIsWrittenRowByRow) {
  Eigen::Affine3d pose = kIdentity;
  pose.matrix() << 1, 0.5, 0, 4, 0, 1, 0.25, 5, 0, 0, 1, 6, 0, 0, 0, 1;  // sheared
  expectBounds(importDae(dae(kMetres, node("<matrix>1 0.5 0 4 0 1 0.25 5 0 0 1 6 0 0 0 1</matrix>" +
                                           kInstance))),
               posed(pose));
}

TEST(ImportDae, SeveralRootNodesAndInstances) {
  Aabb expected = posed(kIdentity);
  expected.extend(posed(Eigen::Affine3d(Eigen::Translation3d(-7, 0, 0))));
  const TriangleMesh mesh =
      importDae(dae(kMetres, node(kInstance) + node("<translate>-7 0 0</translate>" + kInstance)));
  EXPECT_EQ(mesh.triangles.size(), 8u);
  expectBounds(mesh, expected);
}

TEST(ImportDae, LinesAreIgnored) {
  const std::string lines =
      "<lines count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 4</p></lines>";
  expectBounds(importDae(dae(kMetres, node(kInstance), kDaeTriangles + lines)), posed(kIdentity));
  EXPECT_THROW(importDae(dae(kMetres, node(kInstance), lines)), MeshError) << "nothing but lines";
}

TEST(ImportDae, AUnitOfZeroIsRefused) {
  EXPECT_THROW(importDae(dae("<unit meter='0'/>", node(kInstance))), MeshError);
}

TEST(ImportDae, NodesWithoutGeometryAreRefused) {
  EXPECT_THROW(importDae(dae(kMetres, node(node("<translate>1 0 0</translate>")))), MeshError);
}

TEST(ImportDae, PolylistsAreTriangulated) {
  const std::string polylist =
      "<polylist count='2'><input semantic='VERTEX' source='#v' offset='0'/>"
      "<vcount>4 3</vcount><p>0 1 2 3 0 1 3</p></polylist>";
  const TriangleMesh mesh = importDae(dae(kMetres, node(kInstance), polylist));
  EXPECT_EQ(mesh.triangles.size(), 3u);
  expectBounds(mesh, posed(kIdentity));
}

TEST(ImportDae, APartThatIsNotInTheFileIsMissed) {
  EXPECT_EQ(importDae(dae(kMetres, node(kInstance))).triangles.size(), 4u);
  for (const char* const part : {"<instance_geometry url='#none'/>", "<instance_node url='#none'/>",
                                 "<instance_node url='other.dae#part'/>"})
    EXPECT_THROW(importDae(dae(kMetres, node(kInstance + part))), MeshError) << part;
  EXPECT_NE(refusalOf<MeshError>([] {
              importDae(dae(kMetres, node("<instance_geometry url='#none'/>")));
            }).find("Unable to find geometry"),
            std::string::npos)
      << "where nothing else is in the file";
}

TEST(ImportDae, AnAccessorThatReachesBeyondItsArrayIsRefused) {
  const std::string good = dae(kMetres, node(kInstance));
  const auto expectRefused = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    EXPECT_THROW(importDae(bad), MeshError) << to;
  };
  expectRefused("id='f' count='15'", "id='f' count='14'");
  expectRefused("count='5' stride='3'", "count='6' stride='3'");
  expectRefused("count='5' stride='3'", "count='5' stride='4'");
  expectRefused("count='5' stride='3'", "count='5' stride='3' offset='1'");
  expectRefused("count='5' stride='3'", "count='5' stride='4000000000'");
  expectRefused("count='5' stride='3'", "count='&#54;' stride='3'");
  expectRefused("source='#f' count='5'", "source='#&#102;' count='6'");
  const std::string names =
      "<extra><Name_array id='a&amp;b' count='1'>c</Name_array><accessor source='#a&amp;b' "
      "count='1'/></extra>";
  std::string other = good;
  other.insert(other.find("</COLLADA>"), names);
  EXPECT_EQ(importDae(other).triangles.size(), 4u);
  expectRefused("id='f' count='15'", "count = \"14\"\nid=\"f\"");
}

/// The plain file with other text in one place.
std::string daeWith(const std::string& from, const std::string& to) {
  std::string text = dae(kMetres, node(kInstance));
  text.replace(text.find(from), from.size(), to);
  return text;
}

void expectRefusedDae(const std::string& text, const std::string& reason,
                      const std::string& name = "a.dae") {
  const std::string actual = refusalOf<MeshError>([&] { importDae(text, name); });
  EXPECT_NE(actual.find(reason), std::string::npos)
      << name << ": \"" << actual << "\", not " << reason;
}

TEST(ImportDae, WhatIsNoNumberToItsEndIsRefused) {
  for (const char* const number : {"1.#INF", "-1.#IND", "9D5", "0x9", "9,999.5"})
    expectRefusedDae(
        daeWith("99 99 99", std::string("99 99 ") + number),
        std::string("\"") + number + "\" is no real number, in the <float_array> of line 1");
  expectRefusedDae(dae(kMetres, node("<translate>0 0 9D5</translate>" + kInstance)),
                   "in the <translate> of line 1");
  for (const char* const number : {"nan", "-INF", "1.e-3", "-.5", "+1", "1E+05", "0,5"})
    EXPECT_EQ(
        importDae(daeWith("99 99 99", std::string("99 \n") + number + "\t9 ")).triangles.size(), 4u)
        << number;
}

/// Assimp leaves out what follows, as where a blank has come into a number.
TEST(ImportDae, MoreNumbersThanThereAreIsRefused) {
  expectRefusedDae(daeWith("99 99 99", "99 99 9 9"), "too many numbers in the <float_array>");
  for (const auto& [name, numbers] : {std::pair("translate", "0 0 1 0"),
                                      {"scale", "1 1 0 1"},
                                      {"rotate", "0 0 1 9 0"},
                                      {"matrix", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0"},
                                      {"lookat", "0 0 0 0 0 1 0 1 0 0"}}) {
    const std::string begin = std::string("<") + name + ">", end = std::string("</") + name + ">";
    expectRefusedDae(dae(kMetres, node(begin + numbers + end + kInstance)),
                     std::string("too many numbers in the <") + name + ">");
  }
  const std::string extra =
      "<extra><technique profile='X'><scale>1 2 3 4</scale></technique></extra>";
  EXPECT_EQ(importDae(dae(kMetres, node(kInstance + extra))).triangles.size(), 4u);
}

/// Assimp takes x for it.
TEST(ImportDae, APositionWithoutACoordinateIsRefused) {
  for (const char* const param : {"", "<param type='float'/>", "<param name='z' type='float'/>"})
    expectRefusedDae(daeWith("<param name='Z' type='float'/>", param),
                     "accessor of its positions has no param \"Z\"");
}

/// Assimp would read numbers of the next position.
TEST(ImportDae, AStrideBelowThreeIsRefused) {
  for (const char* const stride : {"", "stride='1'", "stride='2'", "stride='0'"})
    expectRefusedDae(daeWith("stride='3'", stride), "a stride below 3");
}

/// Assimp takes them for x, y and z, too.
TEST(ImportDae, APositionWithAColourIsRefused) {
  const std::string z = "<param name='Z' type='float'/>", x = "<param name='X'";
  const std::string before = "<param name='S'/><param name='T'/>" + x;
  std::string good = daeWith("count='5' stride='3'", "count='3' stride='5'");
  good.replace(good.find(x), x.size(), before);
  good.replace(good.find("0 2 1 0 1 3 0 3 2 1 2 3"), 23, "0 2 1 0 1 2 0 1 2 1 2 0");
  EXPECT_EQ(importDae(good).triangles.size(), 4u) << "assimp takes the last one";
  for (const char* const name : {"R", "G", "B", "S", "T", "P", "U", "V"})
    expectRefusedDae(daeWith(z, z + "<param name='" + name + "' type='float'/>"),
                     std::string("assimp takes the param \"") + name + "\" of its positions");
}

TEST(ImportDae, AnAxisThatIsNotOfLengthOneIsRefused) {
  for (const char* const rotation :
       {"0 0 2 90", "0.577 0.577 0.577 120", "0.5 0.5 0 180", "0 0 0 1", "nan 0 0 1"})
    expectRefusedDae(
        dae(kMetres, node("<rotate>" + std::string(rotation) + "</rotate>" + kInstance)),
        "the axis has not the length 1 in the <rotate> of line 1");
  for (const char* const rotation : {"0 0 0 0", "0.707107 0.707107 0 180"})
    EXPECT_EQ(
        importDae(dae(kMetres, node("<rotate>" + std::string(rotation) + "</rotate>" + kInstance)))
            .triangles.size(),
        4u);
}

/// As in rviz.
TEST(ImportDae, ASkinDoesNotMoveVertices) {
  const std::string skin =
      "<library_controllers><controller id='c'><skin source='#g'><bind_shape_matrix>2 0 0 0 0 2 0 "
      "0 "
      "0 0 2 0 0 0 0 1</bind_shape_matrix><source id='j'><Name_array id='ja' count='1'>bone"
      "</Name_array><technique_common><accessor source='#ja' count='1' stride='1'><param "
      "name='JOINT' type='Name'/></accessor></technique_common></source><source "
      "id='b'><float_array "
      "id='ba' count='16'>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</float_array><technique_common><accessor "
      "source='#ba' count='1' stride='16'><param name='TRANSFORM' type='float4x4'/></accessor>"
      "</technique_common></source><source id='w'><float_array id='wa' count='1'>1</float_array>"
      "<technique_common><accessor source='#wa' count='1' stride='1'><param name='WEIGHT' "
      "type='float'/></accessor></technique_common></source><joints><input semantic='JOINT' "
      "source='#j'/><input semantic='INV_BIND_MATRIX' source='#b'/></joints><vertex_weights "
      "count='5'><input semantic='JOINT' source='#j' offset='0'/><input semantic='WEIGHT' "
      "source='#w' offset='1'/><vcount>1 1 1 1 1</vcount><v>0 0 0 0 0 0 0 0 0 0</v>"
      "</vertex_weights></skin></controller></library_controllers>";
  std::string text = dae(kMetres,
                         "<node id='bone' sid='bone' type='JOINT'><translate>9 9 9"
                         "</translate></node>" +
                             node("<instance_controller url='#c'><skeleton>#bone</skeleton>"
                                  "</instance_controller>"));
  text.insert(text.find("<library_visual_scenes>"), skin);
  expectBounds(importDae(text), posed(Eigen::Affine3d::Identity()));
}

TEST(ImportDae, AnUpAxisThatShearsIsRefused) {
  const auto lookat = [](const std::string& numbers, const std::string& content) {
    return dae(kMetres, node("<lookat>" + numbers + "</lookat>" + content));
  };
  for (const char* const numbers :
       {"0 0 0 1 1 0 0 1 0", "0 0 0 1 0 0 0 0 2", "0 0 0 0 0 0 0 1 0"}) {
    for (const std::string& content : {kInstance, node(node(kInstance))})
      expectRefusedDae(lookat(numbers, content), "assimp shears what is below a <lookat>");
    const std::string camera = node("<lookat>" + std::string(numbers) + "</lookat>");
    EXPECT_EQ(importDae(dae(kMetres, node(camera + kInstance) + camera + node(kInstance)))
                  .triangles.size(),
              8u);
  }
  EXPECT_EQ(importDae(lookat("1 0 0 1 0 -1 0 1 0", kInstance)).triangles.size(), 4u);
}

TEST(ImportDae, AGeometryThatIsNoMeshIsRefusedWhereItIsPlaced) {
  for (const std::string kind : {"convex_mesh", "brep"}) {
    const std::string other =
        "</geometry><geometry id='h'><" + kind + " convex_hull_of='#g'/></geometry>";
    const auto with = [&](const std::string& instance) {
      std::string text = dae(kMetres, node(kInstance) + node(instance));
      return text.replace(text.find("</geometry>"), 11, other);
    };
    EXPECT_EQ(importDae(with("")).triangles.size(), 4u);
    expectRefusedDae(with("<instance_geometry url='#h'/>"),
                     "leaves out the <" + kind + "> of its geometry \"h\"");
  }
}

/// Assimp leaves it out.
TEST(ImportDae, AnElementThatColladaDoesNotHaveIsRefused) {
  const std::string extra = "<extra><technique profile='X'><nodf/><mexh/></technique></extra>";
  EXPECT_EQ(importDae(dae(kMetres + extra, node(kInstance + extra))).triangles.size(), 4u);
  expectRefusedDae(dae("<unjt meter='1'/>", node(kInstance)), "no <unjt> in <asset>");
  expectRefusedDae(dae(kMetres, node(kInstance) + "<nodf>" + kInstance + "</nodf>"),
                   "no <nodf> in <visual_scene>");
  expectRefusedDae(dae(kMetres, node(kInstance + "<instance_geometrx url='#g'/>")),
                   "no <instance_geometrx> in <node>");
  expectRefusedDae(dae(kMetres, node("<translatf>0 0 9</translatf>" + kInstance)),
                   "no <translatf> in <node>");
  const std::string other = "<trianglex count='1'><p>0 1 2</p></trianglex>";
  expectRefusedDae(dae(kMetres, node(kInstance), kDaeTriangles + other),
                   "no <trianglex> in <mesh>");
  expectRefusedDae(daeWith("</mesh>", "</mesh><mexh/>"), "no <mexh> in <geometry>");
}

/// Of two geometries, one would be without them.
TEST(ImportDae, AMeshThatLosesItsPrimitivesOrPositionsIsRefused) {
  const std::string positions = "<input semantic='POSITION' source='#p'/>";
  for (const char* const other : {"", "<input semantic='POSITIOM' source='#p'/>"})
    expectRefusedDae(daeWith(positions, other), "its <vertices> have no positions");
  for (const char* const count : {"count='0'", "cound='4'", ""})
    expectRefusedDae(daeWith("count='4'", count), "more primitives than their count says");
  expectRefusedDae(daeWith("<input semantic='VERTEX' source='#v' offset='0'/>",
                           "<input semantic='VERTEX' source='#v' offset='0'/>"
                           "<input semantic='POSITION' source='#p' offset='0'/>"),
                   "positions are named outside of <vertices>");
  expectRefusedDae(daeWith("</geometry>", "</geometry><geometry id='g'/>"),
                   "two geometries with the id \"g\"");
  const std::string empty = "<triangles count='0'><p> </p></triangles>";
  EXPECT_EQ(importDae(dae(kMetres, node(kInstance), empty + kDaeTriangles)).triangles.size(), 4u);
}

TEST(ImportDae, ANegativeIndexIsRefused) {
  EXPECT_EQ(importDae(daeWith("0 2 1 0 1 3", "<!-- -1 -->0 2 1 0 1 3")).triangles.size(), 4u);
  expectRefusedDae(daeWith("0 2 1 0 1 3", "<![CDATA[0 2 1 0 1 -1 ]]>"), "\"-1\" is no index");
  EXPECT_EQ(importDae(daeWith("0 2 1 0 1 3", "0 2 1 0 1 &#51;")).triangles.size(), 4u);
  expectRefusedDae(daeWith("0 2 1 0 1 3", "0 2 1 0 1 &#x2d;1"), "\"-1\" is no index");
  expectRefusedDae(daeWith("0 2 1 0 1 3", "0 2 1 0 1 -1"), "\"-1\" is no index of a vertex");
}

TEST(ImportDae, AUnitThatIsNoNumberIsRefused) {
  for (const char* const meter : {"", "abc", "1/1000", " 0.001"})
    EXPECT_THROW(importDae(dae(std::string("<unit meter='") + meter + "'/>", node(kInstance))),
                 MeshError)
        << meter;
  expectBounds(importDae(dae("<unit name='cm' meter='1.0e-2 '/>", node(kInstance))),
               posed(Eigen::Affine3d(Eigen::Scaling(0.01))));
}

/// Assimp knows Collada by its content.
TEST(ImportDae, AnAccessorIsCheckedWhateverTheNameOfTheFile) {
  const std::string bad = daeWith("count='5' stride='3'", "count='6' stride='3'");
  for (const char* const name : {"a.xml", "a", "a.collada", "a.DAE"}) {
    expectRefusedDae(bad, "reaches beyond its float_array", name);
    EXPECT_EQ(importDae(dae(kMetres, node(kInstance)), name).triangles.size(), 4u) << name;
  }
}

TEST(ImportDae, AnAccessorIsCheckedWhateverElseIsInTheFile) {
  const std::string bad = daeWith("count='5' stride='3'", "count='6' stride='3'");
  const auto with = [&](const std::string& extra) {
    std::string text = bad;
    return text.insert(text.find("</COLLADA>"), "<extra>" + extra + "</extra>");
  };
  expectRefusedDae(with("<float_array id='f' count='999'/>"), "reaches beyond its float_array");
  std::string deep;
  for (int i = 0; i < 600; ++i)
    deep = "<a>" + deep + "</a>";
  expectRefusedDae(with(deep), "reaches beyond its float_array");
  expectRefusedDae(with("<!DOCTYPE a [<!ENTITY b 'c'>]><![CDATA[<p>]]><!-- <p> --><a b='>'/>"),
                   "reaches beyond its float_array");
}

}  // namespace
}  // namespace link_bounds
