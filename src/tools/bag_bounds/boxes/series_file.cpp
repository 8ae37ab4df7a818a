// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes that did not change are not repeated.
#include "tools/bag_bounds/boxes/series_file.h"

#include <stdexcept>
#include <utility>

#include "tools/bag_bounds/boxes/box_records.h"
#include "tools/bag_bounds/scene/record_time.h"
#include "tools/formats/safe_text.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

constexpr std::size_t kMaxNames = 50'000;  // of objects; beyond it, all names count as new

}  // namespace

SeriesFile::SeriesFile(const std::string& file) : file_(file), out_(file) {
  out_ << "time,stamp,name,other,min_x,min_y,min_z,max_x,max_y,max_z,distance,speed\n"
       << std::flush;
  if (!out_) throw std::runtime_error("--series " + file_ + ": cannot be written");
}

void SeriesFile::add(const Scene& scene, const std::vector<Distance>& distances, std::int64_t now,
                     std::int64_t begin) {
  const std::string time = exactSeconds(now - begin);
  const double timeout = scene.model()->parameters.timeout;
  if (last_.size() > kMaxNames) {
    last_.clear();
    present_.clear();
  }
  ++pass_;
  const std::vector<Names::value_type*> before = std::exchange(present_, {});
  scene.forEach([&](const SceneBody& body) {
    Names::value_type& last = *last_.try_emplace(body.name).first;
    addBox(last, body.state, time, timeout);
    if (!body.object) return;
    last.second.pass = pass_;
    present_.push_back(&last);
  });
  for (Names::value_type* object : before)
    if (object->second.pass != pass_) addBox(*object, BoxState(), time, timeout);
  for (const Distance& distance : distances) {
    out_ << time << ',' << stampSeconds(nanosecondsOf(distance.stamp)) << ','
         << csvField(distance.first) << ',' << csvField(distance.second) << ",,,,,,,"
         << exactNumber(distance.distance) << ",\n";
  }
}

/// A box that was lost leaves a row without numbers, and so does an object that is gone.
void SeriesFile::addBox(Names::value_type& name_and_last, const BoxState& state,
                        const std::string& time, double timeout) {
  auto& [name, last] = name_and_last;
  const bool has_box = state.box.has_value();
  const bool is_same =
      last.has_box == has_box &&
      (!has_box || (last.stamp == state.stamp && last.box.min() == state.box->min() &&
                    last.box.max() == state.box->max()));
  if (is_same) return;
  const auto speed = last.has_box && has_box
                         ? centreSpeed(last.box, last.stamp, *state.box, state.stamp, timeout)
                         : std::nullopt;
  last.has_box = has_box;
  last.stamp = state.stamp;
  if (has_box) last.box = *state.box;
  out_ << time << ',' << (has_box ? stampSeconds(state.stamp) : "") << ',' << csvField(name) << ',';
  for (int k = 0; k < 6; ++k) {
    out_ << ',';
    if (has_box) out_ << exactNumber(k < 3 ? state.box->min()[k] : state.box->max()[k - 3]);
  }
  out_ << ",," << (speed ? exactNumber(*speed) : "") << '\n';
}

void SeriesFile::close() {
  out_.close();
  if (!out_)
    throw std::runtime_error("--series " + file_ + ": cannot be written; is the disk full?");
}

}  // namespace link_bounds
