// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ratios of times, one per mesh.
#include <cmath>

#include "bench/common/target.h"
#include "bench/core/core_report.h"

namespace link_bounds::bench {
namespace {

Filter withVertices(std::size_t least) {
  return [least](const Result& result) {
    return result.kind != "synthetic" && result.vertices >= least;
  };
}

Filter withHull(std::size_t least) {
  return [least](const Result& result) { return isRobot(result) && result.hull >= least; };
}

/// Of two meshes, the names of which may be the ends of longer names.
std::vector<double> ratioOfMeshes(const Results& results, const std::string& method,
                                  const std::string& mesh, const std::string& other) {
  const auto time = [&](const std::string& end) {
    for (const Result& result : results) {
      const std::string& name = result.mesh;
      if (result.method == method && name.size() >= end.size() &&
          name.compare(name.size() - end.size(), end.size(), end) == 0)
        return result.ns;
    }
    return std::nan("");
  };
  const double ratio = time(mesh) / time(other);
  return std::isnan(ratio) ? std::vector<double>() : std::vector<double>{ratio};
}

std::vector<Target> targets(const Results& results, const std::string& ours) {
  const auto beside = [&results](const std::string& method, const std::string& other,
                                 const Filter& filter) {
    return ratios(results, method, other, filter);
  };
  constexpr Wanted least = Wanted::kAtLeast;
  constexpr Wanted most = Wanted::kAtMost;
  return {{"paper_loop / " + ours + ", robots and models of 10,000 vertices and more", least, 2000,
           beside("paper_loop", ours, withVertices(10000))},
          {"bullet_slow / " + ours + ", hulls of 300 and more", least, 25,
           beside("bullet_slow", ours, withHull(300))},
          {"fcl_exact / " + ours + ", hulls of 300 and more", least, 25,
           beside("fcl_exact", ours, withHull(300))},
          {ours + " / geometric_shapes", most, 0.15, beside(ours, "geometric_shapes", isRobot)},
          {"ours_sse2 / corners8", most, 3, beside("ours_sse2", "corners8", isRobot)},
          {"ours_avx2 / corners8", most, 2.5, beside("ours_avx2", "corners8", isRobot)},
          {"ours_unchanged / eigen", most, 2, beside("ours_unchanged", "eigen", isRobot)},
          {ours + ", dragon of 100,000 vertices / base of ur5e", most, 1.3,
           ratioOfMeshes(results, ours, "dragon_vrip_res2.ply", "ur5e/visual/base.dae")},
          {ours + ", per link, 1000 links / 50 links, 16 meshes", most, 1.6,
           ratioOfMeshes(results, ours, "links:1000:shared16", "links:50:shared16")},
          {ours + ", per link, 1000 links / 50 links, distinct meshes", most, 1.6,
           ratioOfMeshes(results, ours, "links:1000:distinct", "links:50:distinct")}};
}

}  // namespace

void printCoreTargets(const Results& results, const std::string& ours) {
  printTargets(", by medians over the robot meshes unless said", targets(results, ours));
}

}  // namespace link_bounds::bench
