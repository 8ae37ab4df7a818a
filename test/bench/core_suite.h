// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A method is a type with
//   Pose prepare(const Eigen::Affine3d& world_from_mesh)   outside of what is timed
//   Box box(const Pose&)                                    what is timed
//   Aabb toAabb(const Box&)                                 outside again
//   void start()                                            before each repetition
//   std::size_t bytes()                                     kept per mesh, 0 if not known
// and addCase() has one measured on one mesh.
#pragma once

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core_meshes.h"
#include "link_bounds/aabb.h"

namespace link_bounds::bench {

/// For methods that have nothing to start.
struct Method {
  void start() const {}
};

/// One row of the results.
struct Case {
  std::string mesh;
  std::string kind;
  std::size_t vertices;
  std::size_t hull;
  std::string method;
  bool exact;
  double volume_ratio;
  std::size_t bytes;
  std::vector<double> ns;  ///< per repetition
};

/// Poses and the exact boxes for some of them.
struct Task {
  const Mesh& mesh;
  std::vector<Eigen::Affine3d> poses;
  std::vector<Aabb> exact;  ///< of the first poses
};

/// Half of the poses at random, half of them a slow motion.
Task makeTask(const Mesh& mesh, bool turns = true);

struct Quality {
  bool exact;
  double volume_ratio;
};

/// Compares boxes with the exact ones.
Quality judge(const std::vector<Aabb>& boxes, const std::vector<Aabb>& exact);

/// Keeps the row and has Google Benchmark run `body`, whose iterations take `items` boxes each.
void registerCase(Case row, std::function<void(benchmark::State&)> body, int items = 1);

template <class AMethod>
void addCase(const std::string& name, const Task& task, AMethod method) {
  auto prepared = std::make_shared<std::vector<decltype(method.prepare(task.poses[0]))>>();
  for (const Eigen::Affine3d& pose : task.poses)
    prepared->push_back(method.prepare(pose));
  method.start();
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < task.exact.size(); ++i)
    boxes.push_back(method.toAabb(method.box((*prepared)[i])));
  const Quality quality = judge(boxes, task.exact);
  const Mesh& mesh = task.mesh;
  registerCase({mesh.name,
                mesh.kind,
                mesh.mesh.vertices.size(),
                mesh.points->size(),
                name,
                quality.exact,
                quality.volume_ratio,
                method.bytes(),
                {}},
               [method, prepared](benchmark::State& state) mutable {
                 const std::size_t count = prepared->size();
                 std::size_t i = 0;
                 method.start();
                 for (auto _ : state) {
                   auto box = method.box((*prepared)[i]);
                   benchmark::DoNotOptimize(box);
                   if (++i == count) i = 0;
                 }
               });
}

/// All rows, in the order of registration; their times are there after runCases().
std::vector<Case>& cases();

/// Each case several times, interleaved at random where Google Benchmark can (1.6 and later).
void runCases(int repetitions, double seconds_per_repetition);

void addOurs(const Task& turning, const Task& moving);
void addScans(const Task& task);
void addLooseRules(const Task& task);
void addBullet(const Task& task);
void addFcl(const Task& task);
void addGeometricShapes(const Task& task);
void addLinkCounts(const std::vector<Mesh>& meshes);

}  // namespace link_bounds::bench
