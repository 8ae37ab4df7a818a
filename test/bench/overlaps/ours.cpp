// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// SweepAndPrune.
#include "bench/overlaps/overlap_methods.h"

namespace link_bounds::bench {
namespace {

class OurOverlaps : public OverlapMethod {
 public:
  void step(const SceneBoxes& boxes) override { pairs = search_.find(boxes, kOverlapMargin); }

 private:
  SweepAndPrune search_;
};

}  // namespace

void addOurOverlaps(std::vector<OverlapSetting>& settings) {
  settings.push_back(
      {"ours", "", [](const SceneBoxes&) { return std::make_unique<OurOverlaps>(); }});
}

}  // namespace link_bounds::bench
