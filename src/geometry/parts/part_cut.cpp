// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The best cut of a tree for each number of parts, from the leaves up. Splitting one part after the
// other, always the one that gains most, would stop where only the second split gains anything:
// half a hollow ball needs as much room as half the ball.
#include "geometry/parts/part_cut.h"

#include <algorithm>

namespace link_bounds {
namespace {

/// Gains below this are rounding.
constexpr double kLeastGain = 1e-9;

/// What a node can be cut into, by number of parts.
struct Cuts {
  struct Choice {
    double volume;               ///< sum of mean volumes
    std::size_t left_parts = 0;  ///< the left child's share of the parts; 0: the node is a part
  };
  std::vector<Choice> choices;  ///< for 1, 2, ... parts at most

  const Choice& of(std::size_t parts) const { return choices[parts - 1]; }
  std::size_t most() const { return choices.size(); }
};

Cuts cutsOf(double volume, const Cuts& left, const Cuts& right, std::size_t most) {
  Cuts cuts;
  cuts.choices.resize(std::min(most, left.most() + right.most()), {volume});
  for (std::size_t i = 1; i <= left.most(); ++i) {
    for (std::size_t j = 1; j <= right.most() && i + j <= cuts.most(); ++j) {
      Cuts::Choice& choice = cuts.choices[i + j - 1];
      const double sum = left.of(i).volume + right.of(j).volume;
      if (sum < choice.volume * (1 - kLeastGain)) choice = {sum, i};
    }
  }
  return cuts;
}

std::vector<Cuts> allCuts(const std::vector<PartNode>& nodes, const std::vector<PartReach>& reaches,
                          std::size_t most) {
  std::vector<Cuts> cuts(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const double volume = reaches[i].meanVolume();
    if (nodes[i].isLeaf()) {
      cuts[i].choices = {{volume}};
    } else {
      cuts[i] = cutsOf(volume, cuts[nodes[i].left], cuts[nodes[i].right], most);
    }
  }
  return cuts;
}

std::vector<std::size_t> nodesOf(const std::vector<PartNode>& nodes, const std::vector<Cuts>& cuts,
                                 std::size_t parts) {
  std::vector<std::size_t> chosen;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, parts}};
  while (!open.empty()) {
    const auto [index, share] = open.back();
    open.pop_back();
    const std::size_t left_parts = cuts[index].of(share).left_parts;
    if (left_parts == 0) {
      chosen.push_back(index);
    } else {
      open.emplace_back(nodes[index].right, share - left_parts);
      open.emplace_back(nodes[index].left, left_parts);
    }
  }
  return chosen;
}

double volumeOf(const std::vector<std::size_t>& chosen, const std::vector<PartReach>& reaches) {
  double sum = 0;
  for (const std::size_t index : chosen)
    sum += reaches[index].volume();
  return sum;
}

}  // namespace

std::vector<std::size_t> cutTree(const std::vector<PartNode>& nodes,
                                 const std::vector<PartReach>& reaches, std::size_t most) {
  const std::vector<Cuts> cuts = allCuts(nodes, reaches, most);
  std::vector<std::size_t> chosen{0};
  for (std::size_t parts = 2; parts <= cuts[0].most(); ++parts) {
    if (!(cuts[0].of(parts).volume < cuts[0].of(parts - 1).volume)) continue;
    std::vector<std::size_t> candidate = nodesOf(nodes, cuts, parts);
    if (volumeOf(candidate, reaches) <= volumeOf(chosen, reaches)) chosen = std::move(candidate);
  }
  return chosen;
}

}  // namespace link_bounds
