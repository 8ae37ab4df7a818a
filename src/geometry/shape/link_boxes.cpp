// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Batches of links: first the look-ups in their tables, then their boxes.
#include "link_bounds/geometry/shape/link_boxes.h"

#include <algorithm>
#include <array>

#include "geometry/shape/shape_extents.h"

namespace link_bounds {
namespace {

/// Max links and shapes of a batch: the data that it prefetches fit into a first-level cache of 32
/// KiB.
constexpr std::ptrdiff_t kLinksPerBatch = 16;
constexpr std::size_t kShapesPerBatch = 64;
static_assert(kShapesPerBatch * 3 * sizeof(DirectionTable::List) <= 32 * 1024, "");

}  // namespace

struct LinkBoxes::PlacedShape {
  explicit PlacedShape(const Shape& copied) : shape(copied), known(copied) {}

  Shape shape;
  ShapeExtents known;
};

/// The lists that one batch prefetched for its shapes, in order. They depend only on the poses of
/// the batch and end with it. Shapes beyond kShapesPerBatch look up their lists themselves.
class LinkBoxes::PrefetchedLists {
 public:
  void prefetch(const PlacedShape& shape, const Eigen::Affine3d& world_from_link) {
    if (count_ == kShapesPerBatch) return;
    Entry& entry = entries_[count_++];
    // A shape that is not in the link's frame would have its pose computed twice.
    const bool is_found =
        shape.known.is_in_link_frame && prefetchCells(world_from_link, shape.known, entry.cells);
    entry.table = is_found ? &shape.known.table : nullptr;
  }

  /// To be called once, after the last prefetch().
  void findLists() {
    for (Entry* entry = entries_.data(); entry != entries_.data() + count_; ++entry)
      if (entry->table) link_bounds::findLists(*entry->table, entry->cells, entry->lists);
  }

  /// The lists of the shape with this number in the batch; null if there are none.
  const ListsOfRows* at(std::size_t shape) const {
    return shape < count_ && entries_[shape].table ? &entries_[shape].lists : nullptr;
  }

 private:
  struct Entry {
    const DirectionTable::Lookup* table;  ///< null: none
    CellsOfRows cells;
    ListsOfRows lists;
  };

  std::size_t count_ = 0;
  std::array<Entry, kShapesPerBatch> entries_;
};

LinkBoxes::LinkBoxes(const std::vector<BoundedLink>& links) : boxes_(links.size()) {
  for (const BoundedLink& link : links) {
    links_.push_back({shapes_.size(), link.shapes.size(), link.padding});
    for (const Shape& shape : link.shapes)
      shapes_.emplace_back(shape);
  }
}

LinkBoxes::LinkBoxes(LinkBoxes&&) noexcept = default;
LinkBoxes& LinkBoxes::operator=(LinkBoxes&&) noexcept = default;
LinkBoxes::~LinkBoxes() = default;

void LinkBoxes::update(const std::vector<MovedLink>& moved) {
  // A single link has no other one to work on while it waits for its table: as a batch it takes 1.1
  // times as long.
  if (moved.size() == 1) return bound(moved.front(), nullptr, 0);
  const MovedLink* const end = moved.data() + moved.size();
  for (const MovedLink* begin = moved.data(); begin != end;) {
    const MovedLink* const stop = begin + std::min(kLinksPerBatch, end - begin);
    updateBatch(begin, stop);
    begin = stop;
  }
}

void LinkBoxes::update(std::size_t link, const Eigen::Affine3d& world_from_link) {
  bound({link, &world_from_link}, nullptr, 0);
}

void LinkBoxes::updateBatch(const MovedLink* begin, const MovedLink* end) {
  PrefetchedLists lists;
  for (const MovedLink* moved = begin; moved != end; ++moved) {
    const Link& link = links_[moved->link];
    for (std::size_t i = 0; i < link.shapes; ++i)
      lists.prefetch(shapes_[link.first_shape + i], *moved->world_from_link);
  }
  lists.findLists();
  std::size_t first = 0;
  for (const MovedLink* moved = begin; moved != end; ++moved) {
    bound(*moved, &lists, first);
    first += links_[moved->link].shapes;
  }
}

/// `first` is the number of the link's first shape in the batch.
void LinkBoxes::bound(const MovedLink& moved, const PrefetchedLists* lists, std::size_t first) {
  std::optional<Aabb>& box = boxes_[moved.link];
  if (!box) box.emplace();
  if (!place(moved, lists, first, *box)) box.reset();
}

/// False if there is no box.
bool LinkBoxes::place(const MovedLink& moved, const PrefetchedLists* lists, std::size_t first,
                      Aabb& box) {
  const Link& link = links_[moved.link];
  if (link.shapes == 0) return false;
  const auto place_shape = [&](std::size_t i, Aabb& result) {
    PlacedShape& placed = shapes_[link.first_shape + i];
    return placeShape(placed.shape, *moved.world_from_link, lists ? lists->at(first + i) : nullptr,
                      placed.known, result);
  };
  if (!place_shape(0, box)) return false;
  for (std::size_t i = 1; i < link.shapes; ++i) {
    Aabb part;
    if (!place_shape(i, part)) return false;
    box.extend(part);
  }
  if (link.padding != 0) box = padded(box, link.padding);
  return true;
}

}  // namespace link_bounds
