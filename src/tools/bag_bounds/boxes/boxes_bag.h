// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes ~boxes to the bag of --out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "tools/bag_bounds/bag/bag_writer.h"
#include "world/bodies/scene.h"

namespace link_bounds {

class BoxesBag {
 public:
  /// All functions throw std::runtime_error if writing fails.
  explicit BoxesBag(const std::string& file);

  /// Writes the message that the node would publish for this scene, at the record time `now` [ns].
  void write(const Scene& scene, std::int64_t now);

  void close() { writer_.close(); }

 private:
  BagWriter writer_;
  std::uint32_t topic_;
  AxisAlignedBoxArray message_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace link_bounds
