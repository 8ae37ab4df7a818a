// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Convex bodies that nearly touch. Each is put where its support points along a chosen direction
// are a chosen gap apart, so the distance is known without any search.
#include <gtest/gtest.h>

#include "link_bounds/geometry/distance/body_distances.h"
#include "testing/distance_bodies.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;
using distance_oracle::Long;
using distance_oracle::Vector;

/// A body of one convex shape, with the vertices that its solid sweeps.
struct ConvexBody {
  BodyShape shape;
  std::vector<Vector> points{Vector::Zero()};

  Body body() const { return {{shape}}; }
};

/// A ball, an ellipsoid, a cylinder, a box, a cone, a capsule and a box of triangles.
constexpr int kKinds = 7;

ConvexBody swept(const std::vector<Eigen::Vector3f>& vertices, const TriangleMesh& mesh,
                 Solid solid, const Eigen::Vector3d& size) {
  ConvexBody result;
  std::vector<Eigen::Vector3d> points;
  result.points.clear();
  for (const Eigen::Vector3f& vertex : vertices) {
    points.push_back(vertex.cast<double>());
    result.points.push_back(vertex.cast<Long>());
  }
  result.shape.shape = {std::make_shared<const PointSet>(vertices), solid, size};
  result.shape.triangles = triangleTree(points, mesh.triangles, solid, size);
  return result;
}

ConvexBody anyConvex(Random& random, int kind) {
  const Eigen::Vector3d size = {random.magnitude(-2, 0), random.magnitude(-2, 0),
                                random.magnitude(-2, 0)};
  const Eigen::Vector3d ball = Eigen::Vector3d::Constant(size.x());
  ConvexBody result;
  Shape& shape = result.shape.shape;
  shape.size = size;
  if (kind == 0) shape.size = ball;
  if (kind == 0 || kind == 1) shape.solid = Solid::kEllipsoid;
  if (kind == 2 || kind == 4) {
    shape.solid = Solid::kCylinder;
    if (random.sign() > 0) shape.size.y() = shape.size.x();
  }
  if (kind == 3) shape.solid = Solid::kBox;
  if (kind == 4) {
    shape.size.z() = 0;
    result.shape.tip = Eigen::Vector3d(0, 0, size.z());
  }
  if (kind == 5) {
    const auto half = static_cast<float>(random.magnitude(-2, 0));
    const std::vector<Eigen::Vector3f> ends{{0, 0, -half}, {0, 0, half}};
    result = swept(ends, {ends, {{0, 1, 1}}}, Solid::kEllipsoid, ball);
  }
  if (kind == 6) {
    const TriangleMesh mesh = boxMesh(size);
    result = swept(mesh.vertices, mesh, Solid::kNone, Eigen::Vector3d::Zero());
  }
  result.shape.shape.link_from_shape = random.rigid(random.sign() > 0 ? 0.3 : 0);
  return result;
}

Vector solidPoint(const Shape& shape, const Vector& direction) {
  const Vector half = shape.size.cast<Long>() / 2;
  const auto signedHalf = [&](int k) { return direction[k] < 0 ? -half[k] : half[k]; };
  if (shape.solid == Solid::kNone) return Vector::Zero();
  if (shape.solid == Solid::kBox) return {signedHalf(0), signedHalf(1), signedHalf(2)};
  Vector scaled = half.cwiseProduct(direction);
  if (shape.solid == Solid::kCylinder) scaled.z() = 0;
  const Long norm = scaled.norm();
  if (norm > 0) scaled = half.cwiseProduct(scaled) / norm;
  if (shape.solid == Solid::kCylinder) scaled.z() = signedHalf(2);
  return scaled;
}

/// A point of the body that is farthest along `n`, in the world.
Vector supportPoint(const ConvexBody& body, const Eigen::Affine3d& pose, const Vector& n) {
  using Transform = Eigen::Transform<Long, 3, Eigen::Affine>;
  const Transform inner(body.shape.shape.link_from_shape.cast<Long>());
  const Transform world = Transform(pose.cast<Long>()) * inner;
  const Vector direction = world.linear().transpose() * n;
  const auto isFarther = [&](const Vector& a, const Vector& b) {
    return a.dot(direction) > b.dot(direction);
  };
  Vector best = body.points[0];
  for (const Vector& point : body.points)
    best = isFarther(point, best) ? point : best;
  best += solidPoint(body.shape.shape, direction);
  if (body.shape.tip && isFarther(body.shape.tip->cast<Long>(), best))
    best = body.shape.tip->cast<Long>();
  return world * best;
}

Long support(const ConvexBody& body, const Eigen::Affine3d& pose, const Vector& n) {
  return supportPoint(body, pose, n).dot(n);
}

/// The length of the longest diagonal of a box around both, which rounding is proportional to.
double sizeOf(const ConvexBody& a, const ConvexBody& b) {
  Long squared = 0;
  for (int k = 0; k < 3; ++k) {
    Long width = 0;
    for (const ConvexBody* body : {&a, &b}) {
      const Eigen::Affine3d still = Eigen::Affine3d::Identity();
      width += support(*body, still, Vector::Unit(k)) + support(*body, still, -Vector::Unit(k));
    }
    squared += width * width;
  }
  return static_cast<double>(std::sqrt(squared));
}

/// Turned so that an axis of the second shape is along one of the first, up to a slight tilt.
Eigen::Matrix3d alignedRotation(const ConvexBody& a, const Eigen::Matrix3d& of_a,
                                const ConvexBody& b, double tilt, Random& random) {
  Eigen::Matrix3d permuted;
  const int shift = static_cast<int>(random.uniform(0, 3));
  for (int k = 0; k < 3; ++k)
    permuted.col(k) = Eigen::Vector3d::Unit((k + shift) % 3);
  const Eigen::Matrix3d turn(
      Eigen::AngleAxisd(tilt, random.vector(1).normalized()).toRotationMatrix());
  const Eigen::Matrix3d spin(
      Eigen::AngleAxisd(random.sign() > 0 ? random.uniform(0, 6) : 0, Eigen::Vector3d::UnitZ()));
  return turn * of_a * a.shape.shape.link_from_shape.linear() * spin * permuted *
         b.shape.shape.link_from_shape.linear().transpose();
}

/// Two bodies, and their distance up to `error`.
struct NearPair {
  ConvexBody a, b;
  Eigen::Affine3d of_a, of_b;
  Vector normal;
  Long gap;
  Long error;
  double size;
};

/// Moves the second body to where it nearly touches the first one, in which `normal` is their
/// normal.
void touch(NearPair& pair, Random& random) {
  pair.gap = pair.size * random.magnitude(-9, -2);
  const Vector on_a = supportPoint(pair.a, pair.of_a, pair.normal);
  pair.of_b.translation().setZero();
  const Vector on_b = supportPoint(pair.b, pair.of_b, -pair.normal);
  pair.of_b.translation() = (on_a + pair.gap * pair.normal - on_b).cast<double>();
  pair.error = 4e-16L * (static_cast<Long>(pair.of_a.translation().norm()) + pair.size);
}

/// How the two are turned: at random, an axis of one shape towards the other, or axes of both
/// along each other, up to a slight tilt.
NearPair anyNearPair(Random& random, int first_kind, int second_kind, double far_away) {
  NearPair pair;
  pair.a = anyConvex(random, first_kind);
  pair.b = anyConvex(random, second_kind);
  pair.size = sizeOf(pair.a, pair.b);
  pair.of_a = random.rigid(1);
  pair.of_b = random.rigid(0);
  pair.of_a.translation() += far_away * random.vector(1);
  Eigen::Vector3d normal = random.vector(1).normalized();
  const int kind = static_cast<int>(random.uniform(0, 4));
  if (kind > 0) {
    const auto axis = static_cast<int>(random.uniform(0, 3));
    normal = random.sign() *
             (pair.of_a.linear() * pair.a.shape.shape.link_from_shape.linear()).col(axis);
  }
  if (kind > 1) {
    const double tilt = kind == 2 ? 0 : random.magnitude(-12, -1);
    pair.of_b.linear() = alignedRotation(pair.a, pair.of_a.linear(), pair.b, tilt, random);
  }
  pair.normal = normal.cast<Long>().normalized();
  touch(pair, random);
  return pair;
}

constexpr double kAccuracy = 1e-8;  ///< of the size

void expectSame(const BodyDistance& found, const BodyDistance& swapped) {
  ASSERT_EQ(found.lower, swapped.lower);
  ASSERT_EQ(found.upper, swapped.upper);
  ASSERT_EQ(found.on_first, swapped.on_second);
  ASSERT_EQ(found.on_second, swapped.on_first);
  ASSERT_EQ(found.normal, -swapped.normal);
  ASSERT_EQ(found.level, swapped.level);
}

void expectAccurate(const NearPair& pair, const BodyDistance& found) {
  const double rounding = 1e-12 * pair.size + 4 * static_cast<double>(pair.error);
  ASSERT_LE(found.lower, pair.gap + pair.error);
  ASSERT_GE(found.upper, pair.gap - pair.error);
  ASSERT_LE(found.upper - found.lower, kAccuracy * pair.size + rounding)
      << "at a gap of " << pair.gap << ", size " << pair.size;
  ASSERT_NEAR((found.on_second - found.on_first).norm(), found.upper, rounding);
  // A point lies in its body if its support along no direction is exceeded.
  const Vector between = pair.normal;
  const Vector on_first = found.on_first.cast<Long>(), on_second = found.on_second.cast<Long>();
  ASSERT_LE(between.dot(on_first), support(pair.a, pair.of_a, between) + rounding);
  ASSERT_LE(-between.dot(on_second), support(pair.b, pair.of_b, -between) + rounding);
  if (found.lower == 0 || found.level == DistanceLevel::kMesh) return;
  const Vector n = found.normal.cast<Long>();
  const Long apart = -support(pair.b, pair.of_b, -n) - support(pair.a, pair.of_a, n);
  ASSERT_GE(apart, found.lower * n.norm());
}

TEST(NearContact, OfConvexBodiesIsKnownToAHundredMillionthOfTheirSize) {
  Random random(1);
  for (int i = 0; i < repetitions(500 * kKinds * kKinds); ++i) {
    const double far_away = i % 4 == 0 ? random.magnitude(0, 3) : 0;
    const NearPair pair = anyNearPair(random, i % kKinds, i / kKinds % kKinds, far_away);
    const DistanceGoal goal{kAccuracy * pair.size};
    const Body a = pair.a.body(), b = pair.b.body();
    const BodyDistance found = *bodyDistance(a, pair.of_a, b, pair.of_b, goal);
    expectAccurate(pair, found);
    expectSame(found, *bodyDistance(b, pair.of_b, a, pair.of_a, goal));
    ASSERT_FALSE(HasFatalFailure()) << "kinds " << i % kKinds << " and " << i / kKinds % kKinds;
  }
}

TEST(NearContact, StaysKnownWhileBodiesMove) {
  // Each search begins where the last one ended; each second one where the bodies met.
  Random random(2);
  int searches = 0, meetings = 0;
  for (int i = 0; i < repetitions(20 * kKinds * kKinds); ++i) {
    NearPair pair = anyNearPair(random, i % kKinds, i / kKinds % kKinds, 0);
    BodyDistances distances({kAccuracy * pair.size});
    distances.set(0, std::make_shared<const Body>(pair.a.body()));
    distances.set(1, std::make_shared<const Body>(pair.b.body()));
    for (int step = 0; step < 10; ++step) {
      const double turn = random.magnitude(-9, -1);
      pair.of_b.rotate(Eigen::AngleAxisd(turn, random.vector(1).normalized()));
      touch(pair, random);
      distances.move(0, pair.of_a);
      if (step % 2 == 1) {
        ++searches;
        const double depth = static_cast<double>(pair.gap) + random.magnitude(-9, -1) * pair.size;
        const Eigen::Vector3d deeper = -depth * pair.normal.cast<double>();
        distances.move(1, Eigen::Translation3d(deeper) * pair.of_b);
        meetings += distances.find(0, 1)->lower == 0 ? 1 : 0;
      }
      distances.move(1, pair.of_b);
      expectAccurate(pair, *distances.find(0, 1));
    }
    ASSERT_FALSE(HasFatalFailure()) << "kinds " << i % kKinds << " and " << i / kKinds % kKinds;
  }
  EXPECT_GT(meetings, searches / 2);
}

// Of two slivers that lie nearly along each other, the way between the nearest points has few
// digits, and so have the planes.
TEST(NearContact, OfSliversIsKnownToAHundredMillionthOfTheirSize) {
  Random random(4);
  for (int i = 0; i < repetitions(20000); ++i) {
    TriangleMesh mesh;
    for (std::uint32_t k = 0; k < 9; k += 3) {
      const Eigen::Vector3f corner = random.vector(1).cast<float>();
      const Eigen::Vector3f along = random.vector(1).cast<float>();
      const Eigen::Vector3f aside = random.vector(1e-6).cast<float>();
      mesh.vertices.insert(mesh.vertices.end(),
                           {corner, corner + along, corner + along / 2 + aside});
      mesh.triangles.push_back({k, k + 1, k + 2});
    }
    MeshBody body;
    body.add(mesh);
    const Eigen::Affine3d first = random.rigid(1);
    const double step = random.magnitude(-8, -1);
    const Eigen::Affine3d moved = Eigen::Translation3d(random.vector(step)) * first *
                                  Eigen::AngleAxisd(step, random.vector(1).normalized());
    constexpr double kWidth = 3 * kAccuracy;  // bodies of about 3 m
    const BodyDistance found = *bodyDistance(body.body, first, body.body, moved, {kWidth});
    ASSERT_LE(found.upper - found.lower, kWidth + 1e-11) << "step " << step << ", round " << i;
  }
}

TEST(NearContact, OfMeshesDoesNotDependOnTheOrder) {
  Random random(3);
  for (int i = 0; i < repetitions(2000); ++i) {
    MeshBody a, b;
    a.add(anyMesh(random, 0.3));
    b.add(anyMesh(random, 0.3));
    const Eigen::Affine3d of_a = random.rigid(0.3), of_b = random.rigid(0.3);
    expectSame(*bodyDistance(a.body, of_a, b.body, of_b),
               *bodyDistance(b.body, of_b, a.body, of_a));
    BodyDistances distances;
    distances.set(0, std::make_shared<const Body>(a.body));
    distances.set(1, std::make_shared<const Body>(b.body));
    distances.move(0, of_a);
    distances.move(1, of_b);
    expectSame(*distances.findOnce(0, 1, 1), *distances.findOnce(1, 0, 1));
  }
}

}  // namespace
}  // namespace link_bounds
