// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each thread writes the results of a row to the place of that row.
#include "python/posed_calls.h"

#include <algorithm>
#include <limits>

#include "link_bounds/robot/urdf/kinematics.h"
#include "python/joint_input.h"
#include "robot/threads/row_threads.h"

namespace py = pybind11;

namespace link_bounds {
namespace {

constexpr std::size_t kBoxNumbers = 6;

/// One entry of the structured array, as the message Distance.
struct PairRow {
  std::int64_t row;
  std::int64_t first;
  std::int64_t second;
  double distance;
  double distance_max;
  double on_first[3];
  double on_second[3];
  double normal[3];
  std::uint8_t level;
};

/// Thrown if the caller wants no results any more.
class EndedEarly : public std::exception {};

/// Computes the results of a pose; `row` is its index.
using PoseWork = std::function<void(PosedRobot& posed, std::size_t row)>;

/// Begin of a message about a row; "" for a single pose.
std::string placeOf(const JointRows& rows, std::size_t row) {
  return rows.is_single ? "" : "q[" + std::to_string(row) + "]: ";
}

void workOn(const SharedRobot& shared, const JointRows& rows, std::size_t row, PosedRobot& posed,
            const PoseWork& work) {
  try {
    posed.move(spread(shared, rows, row));
    work(posed, row);
  } catch (const JointError& error) {
    throw JointError(placeOf(rows, row) + error.what());
  }
}

/// Calls `work` for each row, on `jobs` threads. An exception ends all of them; forRows() throws
/// that of one thread.
void forPoses(SharedRobot& shared, const JointRows& rows, unsigned jobs, const StopFlag& stop,
              const PoseWork& work) {
  std::vector<SharedRobot::Borrowed> workers;
  for (unsigned i = 0; i < jobs; ++i)
    workers.push_back(shared.borrow());
  StopFlag has_failed{false};
  const auto take = [&](unsigned thread, std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      if (stop) throw EndedEarly();
      if (has_failed) return;
      try {
        workOn(shared, rows, row, *workers[thread], work);
      } catch (...) {
        has_failed = true;
        throw;
      }
    }
  };
  forRows(0, rows.count, jobs, kPosesAtOnce, take);
}

/// Computes a single pose on this thread. boxesOf() keeps the GIL: to get it back may take longer
/// than the boxes.
void forOne(SharedRobot& shared, const JointRows& rows, const PoseWork& work) {
  const SharedRobot::Borrowed posed = shared.borrow();
  workOn(shared, rows, 0, *posed, work);
}

/// Computes rows on other threads, without the GIL.
void forMany(SharedRobot& shared, const JointRows& rows, unsigned jobs, const PoseWork& work) {
  const std::size_t useful = std::max<std::size_t>(1, rows.count / kPosesAtOnce);
  const auto threads =
      static_cast<unsigned>(std::min<std::size_t>(jobs == 0 ? coreCount() : jobs, useful));
  interruptible([&](const StopFlag& stop) { forPoses(shared, rows, threads, stop, work); });
}

[[noreturn]] void refuse(const SharedRobot& shared, std::size_t link, const std::string& lacks) {
  throw JointError("link \"" + shared.bounded().links[link].name +
                   "\": its size and pose give no finite " + lacks);
}

/// Throws JointError for a link without a box, unless the user allows incomplete links.
void writeBoxes(const SharedRobot& shared, const PosedRobot& posed, double* out) {
  for (std::size_t link = 0; link < shared.bounded().links.size(); ++link, out += kBoxNumbers) {
    const std::optional<Aabb>& box = posed.box(link);
    if (!box && !shared.allowsIncomplete()) refuse(shared, link, "box");
    if (box) {
      std::copy_n(box->min().data(), 3, out);
      std::copy_n(box->max().data(), 3, out + 3);
    } else {
      std::fill_n(out, kBoxNumbers, std::numeric_limits<double>::quiet_NaN());
    }
  }
}

PairRow rowOf(const LinkPairDistance& pair, std::size_t row) {
  PairRow result{};
  result.row = static_cast<std::int64_t>(row);
  result.first = static_cast<std::int64_t>(pair.first);
  result.second = static_cast<std::int64_t>(pair.second);
  result.distance = pair.distance.lower;
  result.distance_max = pair.distance.upper;
  std::copy_n(pair.distance.on_first.data(), 3, result.on_first);
  std::copy_n(pair.distance.on_second.data(), 3, result.on_second);
  std::copy_n(pair.distance.normal.data(), 3, result.normal);
  result.level = static_cast<std::uint8_t>(pair.distance.level);
  return result;
}

/// Throws JointError for a link without a box, which would silently be in no pair.
void refuseUnboxed(const SharedRobot& shared, const PosedRobot& posed) {
  for (std::size_t link = 0; link < shared.bounded().links.size(); ++link) {
    if (!posed.box(link) && !shared.allowsIncomplete()) refuse(shared, link, "distance");
  }
}

}  // namespace

py::array boxesOf(SharedRobot& shared, const py::object& q, unsigned jobs) {
  checkJobs(jobs);
  const JointRows rows = jointRows(shared, q);
  const std::size_t links = shared.bounded().links.size();
  std::vector<Py_ssize_t> shape{static_cast<Py_ssize_t>(links), 2, 3};
  if (!rows.is_single) shape.insert(shape.begin(), static_cast<Py_ssize_t>(rows.count));
  py::array_t<double> result(shape);
  double* const out = result.mutable_data();
  const auto write = [&](const PosedRobot& posed, std::size_t row) {
    writeBoxes(shared, posed, out + row * links * kBoxNumbers);
  };
  if (rows.is_single)
    forOne(shared, rows, write);
  else
    forMany(shared, rows, jobs, write);
  return py::array(std::move(result));
}

py::array distancesOf(SharedRobot& shared, const py::object& q, double limit, unsigned jobs) {
  checkLength("limit", limit);
  checkJobs(jobs);
  const JointRows rows = jointRows(shared, q);
  shared.warnOfLeftOut();
  std::vector<std::vector<PairRow>> found(rows.count);
  const auto measure = [&](PosedRobot& posed, std::size_t row) {
    refuseUnboxed(shared, posed);
    const PoseDistances distances = posed.distances(limit);
    if (!distances.unmeasured.empty()) refuse(shared, distances.unmeasured.front(), "distance");
    for (const LinkPairDistance& pair : distances.pairs)
      found[row].push_back(rowOf(pair, row));
  };
  if (rows.is_single) {
    unlocked([&] { forOne(shared, rows, measure); });
  } else {
    forMany(shared, rows, jobs, measure);
  }
  std::size_t total = 0;
  for (const std::vector<PairRow>& of_row : found)
    total += of_row.size();
  py::array_t<PairRow> result(static_cast<Py_ssize_t>(total));
  PairRow* out = result.mutable_data();
  for (const std::vector<PairRow>& of_row : found)
    out = std::copy(of_row.begin(), of_row.end(), out);
  return py::array(std::move(result));
}

void registerPairRow() {
  PYBIND11_NUMPY_DTYPE(PairRow, row, first, second, distance, distance_max, on_first, on_second,
                       normal, level);
}

}  // namespace link_bounds
