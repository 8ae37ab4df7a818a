// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes and distances over time, as a csv file.
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "link_bounds/Distance.h"
#include "world/bodies/scene.h"

namespace link_bounds {

/// Writes a row for each box that changed, with the speed of its centre since the row before, and a
/// row for each pair within the limit.
class SeriesFile {
 public:
  /// Throws std::runtime_error if the file cannot be written, as close() does.
  explicit SeriesFile(const std::string& file);

  /// `now` is the time of the scene, `begin` that of the first message, both as record time [ns].
  void add(const Scene& scene, const std::vector<Distance>& distances, std::int64_t now,
           std::int64_t begin);

  void close();

 private:
  struct Last {
    bool has_box = false;
    std::int64_t stamp = 0;
    Aabb box;
    std::uint64_t pass = 0;  ///< the last pass with the object
  };
  using Names = std::map<std::string, Last>;

  void addBox(Names::value_type& name_and_last, const BoxState& state, const std::string& time,
              double timeout);

  std::string file_;
  std::ofstream out_;
  Names last_;
  std::vector<Names::value_type*> present_;  ///< objects of the last pass
  std::uint64_t pass_ = 0;
};

}  // namespace link_bounds
