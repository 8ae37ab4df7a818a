// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// In quadruple precision: a box is never smaller than its shape, nor larger than shape.h admits.
#include <gtest/gtest.h>

#include <limits>

#include "link_bounds/geometry/shape/shape.h"
#include "testing/brute_force.h"
#include "testing/numbers.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

using FloatPoints = std::vector<Eigen::Vector3f>;

constexpr int kMeshes = 40;
constexpr int kPosesPerMesh = 100;

/// The table of a mesh is built once for all its poses.
struct Mesh {
  Mesh(const FloatPoints& its_points)
      : points(its_points), set(std::make_shared<const PointSet>(its_points)) {}

  FloatPoints points;
  std::shared_ptr<const PointSet> set;
};

void expectContainment(const Mesh& mesh, const Eigen::Affine3d& pose) {
  const auto box = worldBox({mesh.set, Solid::kNone, Eigen::Vector3d::Zero(), pose}, kIdentity);
  ASSERT_TRUE(box);
  ASSERT_EQ(faultOf(*box, mesh.points, pose), "") << pose.matrix();
}

TEST(Containment, RandomMeshesUnderRotation) {
  brute_force::Random random(1);
  for (int i = 0; i < kMeshes; ++i) {
    const Mesh mesh = random.points(50, random.magnitude(-6, 3));
    for (int j = 0; j < kPosesPerMesh; ++j)
      expectContainment(mesh, random.rigid(1));
  }
}

TEST(Containment, RandomMeshesUnderShearAndMirror) {
  brute_force::Random random(2);
  for (int i = 0; i < kMeshes; ++i) {
    const Mesh mesh = random.points(50, random.magnitude(-6, 3));
    for (int j = 0; j < kPosesPerMesh; ++j)
      expectContainment(mesh, random.affine(1));
  }
}

TEST(Containment, TranslationsUpToAThousandKilometres) {
  brute_force::Random random(4);
  for (int i = 0; i < kMeshes; ++i) {
    const Mesh mesh = random.points(50, 0.5);
    for (int j = 0; j < kPosesPerMesh; ++j) {
      expectContainment(mesh, random.rigid(random.magnitude(0, 6)));
    }
  }
}

TEST(Containment, FarVerticesFarAway) {
  // 1e3 m from the mesh's origin, and the mesh 1e-3 to 1e6 m from the world's.
  brute_force::Random random(11);
  for (int i = 0; i < kMeshes; ++i) {
    const Eigen::Vector3d far_away = 1e3 * random.vector(1).normalized();
    const Mesh mesh = random.points(200, random.magnitude(-3, 2), far_away);
    for (int j = 0; j < kPosesPerMesh; ++j) {
      expectContainment(mesh, random.rigid(random.magnitude(-3, 6)));
      expectContainment(mesh, random.affine(random.magnitude(-3, 6)));
    }
  }
}

TEST(Containment, PlatesWhoseFacesTie) {
  // Tilted in their own frame and levelled by the pose: where the table leaves out most points.
  brute_force::Random random(12);
  for (const double degrees : {0.0, 30.0, 45.0, std::atan2(3, 4) * 180 / M_PI}) {
    const Eigen::Matrix3d tilt = brute_force::turned(degrees, Eigen::Vector3d::UnitX());
    FloatPoints points;
    for (int i = 0; i < 400; ++i) {
      const Eigen::Vector3d point(0.1 * (i % 20), 0.1 * (i / 20), i % 2 ? 0 : 0.05);
      points.push_back((tilt * point).cast<float>());
    }
    const Mesh mesh(points);
    for (int j = 0; j < kPosesPerMesh; ++j) {
      Eigen::Affine3d pose(tilt.transpose());
      expectContainment(mesh, pose);
      pose.translation() = random.vector(random.magnitude(-3, 6));
      expectContainment(mesh, pose.prerotate(brute_force::turned(random.magnitude(-16, 2),
                                                                 Eigen::Vector3d::UnitZ())));
    }
  }
}

TEST(Containment, TranslationsThatCancelTheReach) {
  // The face lands near zero, where the errors of what cancelled stay.
  brute_force::Random random(5);
  for (int i = 0; i < kMeshes * kPosesPerMesh; ++i) {
    const FloatPoints points = random.points(1, 1e3);
    Eigen::Affine3d pose = random.rigid(0);
    pose.translation() = -(pose.linear() * points[0].cast<double>());
    expectContainment(points, pose);
  }
}

TEST(Containment, EqualPointsUnderTranslation) {
  brute_force::Random random(10);
  const Mesh mesh(FloatPoints(20, Eigen::Vector3f(0.1f, -0.2f, 0.3f)));
  for (int i = 0; i < kPosesPerMesh; ++i) {
    Eigen::Affine3d pose = kIdentity;
    pose.translation() = random.vector(random.magnitude(-3, 6));
    expectContainment(mesh, pose);
  }
}

TEST(Containment, AxisAlignedPosesOfFlatMeshes) {
  brute_force::Random random(6);
  FloatPoints points = random.points(50, 1);
  for (Eigen::Vector3f& point : points)
    point.z() = 0.1f;
  for (const double degrees : {0.0, 30.0, 45.0, 90.0, 180.0}) {
    Eigen::Affine3d pose(brute_force::turned(degrees, Eigen::Vector3d::UnitX()));
    pose.translation() = random.vector(10);
    expectContainment(points, pose);
  }
}

TEST(Containment, ScalesThatUnderflow) {
  brute_force::Random random(7);
  const double smallest = std::numeric_limits<double>::denorm_min();
  for (int i = 0; i < 1000; ++i) {
    const FloatPoints points = random.points(5, 1);
    const Eigen::Affine3d pose(Eigen::Matrix3d(random.rotation() * random.magnitude(-323, -300)));
    const Shape shape{std::make_shared<const PointSet>(points), Solid::kNone,
                      Eigen::Vector3d::Zero(), pose};
    const QuadBox exact = exactBox(points, pose);
    const Aabb box = worldBox(shape, kIdentity).value();
    ASSERT_TRUE(contains(box, exact)) << pose.matrix();
    ASSERT_LE((box.max() - box.min()).maxCoeff(), 1e-299 + 100 * smallest);
  }
}

/// True if `reach` is at least half of the sum over the columns that `solid` prescribes, without a
/// square root, which quadruple precision lacks here.
bool reachesHalf(Quad reach, Solid solid, const Eigen::Vector3d& row, const Eigen::Vector3d& size) {
  std::array<Quad, 3> part;
  for (int j = 0; j < 3; ++j) {
    const Quad product = static_cast<Quad>(row[j]) * static_cast<Quad>(size[j]) / 2;
    part[static_cast<std::size_t>(j)] = product < 0 ? -product : product;
  }
  const auto [x, y, z] = part;
  if (solid == Solid::kBox) return reach >= x + y + z;
  if (solid == Solid::kCylinder) return reach >= z && (reach - z) * (reach - z) >= x * x + y * y;
  return reach >= 0 && reach * reach >= x * x + y * y + z * z;
}

void expectSolidContained(Solid solid, const Eigen::Vector3d& size, const Eigen::Affine3d& pose) {
  const Aabb box = worldBox({nullptr, solid, size, pose}, kIdentity).value();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d row = pose.linear().row(k);
    const Quad center = pose.translation()[k];
    const Quad up = static_cast<Quad>(box.max()[k]) - center;
    const Quad down = center - static_cast<Quad>(box.min()[k]);
    ASSERT_TRUE(reachesHalf(up, solid, row, size)) << pose.matrix();
    ASSERT_TRUE(reachesHalf(down, solid, row, size)) << pose.matrix();
    const Quad slack = allowedExcess(pose, k, size.maxCoeff() / 2);
    ASSERT_FALSE(reachesHalf(std::max(up, down) - slack, solid, row, size)) << pose.matrix();
  }
}

class SolidContainment : public testing::TestWithParam<Solid> {};

TEST_P(SolidContainment, RandomPoses) {
  brute_force::Random random(8);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d size = random.vector(1).cwiseAbs() * random.magnitude(-3, 3);
    expectSolidContained(GetParam(), size, random.rigid(random.magnitude(-3, 6)));
    expectSolidContained(GetParam(), size, random.affine(0));
  }
}

TEST_P(SolidContainment, NearlyAlignedPoses) {
  // Where |r|_1, by which the pad is measured, is hardly more than |r|.
  brute_force::Random random(9);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d size = random.vector(1).cwiseAbs();
    const double degrees = random.magnitude(-16, -5);
    Eigen::Affine3d pose(brute_force::turned(degrees, random.vector(1)));
    pose.linear() *= random.uniform(0.5, 2);
    expectSolidContained(GetParam(), size, pose);
  }
}

INSTANTIATE_TEST_SUITE_P(Containment, SolidContainment,
                         testing::Values(Solid::kBox, Solid::kEllipsoid, Solid::kCylinder));

}  // namespace
}  // namespace link_bounds
