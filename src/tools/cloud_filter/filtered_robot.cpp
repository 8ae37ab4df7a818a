// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/filtered_robot.h"

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <sstream>

#include "link_bounds/robot/robot_loader.h"
#include "packages/package_path.h"
#include "robot/bounded_robot.h"
#include "robot/threads/row_threads.h"
#include "world/cloud/scan_poses.h"
#include "world/log/log_text.h"
#include "world/model/model.h"

namespace link_bounds {
namespace {

bool isSame(const Shape& a, const Shape& b) {
  return a.points == b.points && a.solid == b.solid && a.size == b.size &&
         a.link_from_shape.matrix() == b.link_from_shape.matrix();
}

bool isSame(const Body& a, const Body& b) {
  return std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(),
                    [](const BodyShape& x, const BodyShape& y) {
                      return isSame(x.shape, y.shape) && x.triangles == y.triangles &&
                             x.tip == y.tip;
                    });
}

/// Makes the grids of all links.
class GridMaker {
 public:
  GridMaker(const BoundedRobot& robot, const std::function<bool()>& is_cancelled)
      : robot_(robot), is_cancelled_(is_cancelled) {}

  std::vector<std::shared_ptr<const BodyGrid>> grids() {
    const std::size_t count = robot_.links.size();
    grids_.resize(count);
    std::vector<std::size_t> originals;
    for (std::size_t i = 0; i < count; ++i) {
      originals.push_back(originalOf(i));
      if (originals.back() == i) places_.push_back(i);
    }
    try {
      forRows(0, places_.size(), std::min(coreCount(), kMaxThreads), 1,
              [this](unsigned, std::size_t i, std::size_t) { make(places_[i]); });
    } catch (const Cancelled&) {
    }
    for (std::size_t i = 0; i < count; ++i)
      grids_[i] = grids_[originals[i]];
    return std::move(grids_);
  }

 private:
  static constexpr unsigned kMaxThreads = 4;
  struct Cancelled {};

  /// The first link with the same body and padding; wheels or fingers often share one mesh.
  std::size_t originalOf(std::size_t link) const {
    std::size_t i = 0;
    while (i < link && !(robot_.links[i].padding == robot_.links[link].padding &&
                         isSame(robot_.bodies[i], robot_.bodies[link])))
      ++i;
    return i;
  }

  void make(std::size_t link) {
    const auto check_interrupt = [this] {
      if (is_cancelled_()) throw Cancelled();
    };
    const GridOptions options{robot_.links[link].padding, kMaxMotionError};
    grids_[link] = std::make_shared<BodyGrid>(BodySurface(robot_.bodies[link], check_interrupt),
                                              options, check_interrupt);
  }

  const BoundedRobot& robot_;
  const std::function<bool()>& is_cancelled_;
  std::vector<std::size_t> places_;  ///< links that need a grid of their own
  std::vector<std::shared_ptr<const BodyGrid>> grids_;
};

void tellUnwhole(const BoundedRobot& bounded, FilteredRobot& robot) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.grids[i]->isWhole()) continue;
    robot.problems.push_back("link " + robot.links[i] + kNotWhole);
    if (bounded.links[i].isWhole()) robot.incomplete.push_back(robot.links[i]);
  }
}

std::string summaryOf(const FilteredRobot& robot, std::chrono::duration<double> duration) {
  std::size_t bytes = 0;
  for (const auto& grid : std::set(robot.grids.begin(), robot.grids.end()))
    bytes += grid->bytes() + grid->surface().bytes();
  std::ostringstream text;
  text << "filtering the points of " << robot.links.size() << " links; they were loaded in "
       << std::fixed << std::setprecision(1) << duration.count()
       << " s, and their grids and triangles take " << bytes / 1000 << " kB";
  if (!robot.left_out.empty()) text << "; " << logText(robot.left_out);
  return text.str();
}

}  // namespace

std::shared_ptr<const FilteredRobot> filteredRobot(const std::string& description,
                                                   const FilterParameters& parameters,
                                                   const std::function<bool()>& is_cancelled) {
  const auto begin = std::chrono::steady_clock::now();
  const Robot robot = parseRobot(description);
  MeshSource source;
  source.package_path = rosPackages();
  source.is_cancelled = is_cancelled;
  Selection selection = selectionOf(parameters);
  selection.triangles = true;
  RobotLoader loader;
  const BoundedRobot bounded = loader.load(robot, selection, source);
  FilteredRobot result;
  result.parameters = parameters;
  result.problems = allProblems(bounded);
  result.left_out = leftOutNote(robot, selection);
  result.warnings = unknownLinks(parameters, linkNames(robot));
  for (const Link& link : robot.links)
    result.all_frames.insert(tfName(parameters.tf_prefix, link.name));
  for (const BoundedLink& link : bounded.links) {
    result.links.push_back(link.name);
    result.frames.push_back(tfName(parameters.tf_prefix, link.name));
    if (!link.isWhole()) result.incomplete.push_back(link.name);
  }
  result.grids = GridMaker(bounded, is_cancelled).grids();
  if (is_cancelled()) return nullptr;
  tellUnwhole(bounded, result);
  result.summary = summaryOf(result, std::chrono::steady_clock::now() - begin);
  return std::make_shared<const FilteredRobot>(std::move(result));
}

}  // namespace link_bounds
