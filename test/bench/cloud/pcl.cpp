// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// PCL's CropHull. It computes no hulls and no padding: its hulls are those of geometric_shapes, and
// it gets the points in their bounding spheres.
#include <pcl/filters/crop_hull.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "bench/cloud/cloud_methods.h"
#include "bench/cloud/posed_hulls.h"

namespace link_bounds::bench {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Crop {
  pcl::CropHull<pcl::PointXYZ> filter;
  bodies::BoundingSphere sphere;
};

Cloud::Ptr verticesOf(const bodies::ConvexMesh& hull) {
  Cloud::Ptr cloud(new Cloud);
  for (const Eigen::Vector3d& vertex : hull.getScaledVertices()) {
    const Eigen::Vector3f place = (hull.getPose() * vertex).cast<float>();
    cloud->push_back({place.x(), place.y(), place.z()});
  }
  return cloud;
}

std::vector<pcl::Vertices> trianglesOf(const bodies::ConvexMesh& hull) {
  std::vector<pcl::Vertices> triangles;
  const std::vector<unsigned int>& corners = hull.getTriangles();
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      triangles.back().vertices.push_back(static_cast<pcl::index_t>(corners[i + k]));
  }
  return triangles;
}

Cloud::Ptr pointsOf(const CloudScene& scene) {
  Cloud::Ptr cloud(new Cloud);
  const CloudPoints points = layoutOf(scene.cloud).points;
  points.forEach([&](std::size_t, const std::uint8_t* bytes) {
    const Eigen::Vector3f place = points.position(bytes).cast<float>();
    cloud->push_back({place.x(), place.y(), place.z()});
  });
  return cloud;
}

}  // namespace

LabelAll cropHull(const CloudScene& scene) {
  std::vector<Crop> crops;
  for (const PosedHull& hull : posedHulls(scene)) {
    Crop& crop = crops.emplace_back();
    crop.filter.setHullCloud(verticesOf(*hull.body));
    crop.filter.setHullIndices(trianglesOf(*hull.body));
    crop.sphere = hull.sphere;
  }
  return [crops, cloud = pointsOf(scene)]() mutable {
    std::vector<bool> is_robot(cloud->size(), false);
    for (Crop& crop : crops) {
      const pcl::IndicesPtr near(new pcl::Indices);
      for (std::size_t i = 0; i < cloud->size(); ++i) {
        const Eigen::Vector3d place = (*cloud)[i].getVector3fMap().cast<double>();
        if (!is_robot[i] &&
            (place - crop.sphere.center).squaredNorm() <= crop.sphere.radius * crop.sphere.radius)
          near->push_back(static_cast<pcl::index_t>(i));
      }
      crop.filter.setInputCloud(cloud);
      crop.filter.setIndices(near);
      pcl::Indices inside;
      crop.filter.filter(inside);
      for (const pcl::index_t i : inside)
        is_robot[static_cast<std::size_t>(i)] = true;
    }
    return static_cast<std::size_t>(std::count(is_robot.begin(), is_robot.end(), true));
  };
}

}  // namespace link_bounds::bench
