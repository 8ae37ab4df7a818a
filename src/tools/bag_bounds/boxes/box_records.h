// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Extreme coordinates of the box of each link and object, and the times without a box.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/bag_bounds/scene/record_time.h"
#include "world/bodies/scene.h"

namespace link_bounds {

struct Extreme {
  double value = 0;  ///< [m]
  RecordTime when;
};

struct BoxRecord {
  std::string name;
  bool has_box = false;        ///< at any time; the next two are then defined
  std::array<Extreme, 3> min;  ///< smallest x, y, z
  std::array<Extreme, 3> max;
  std::optional<Extreme> speed;     ///< max of its centre [m/s], see centreSpeed()
  std::optional<Aabb> last;         ///< the box at the last add(), if it had one
  std::int64_t last_stamp = 0;      ///< its stamp [ns]
  std::uint64_t gaps = 0;           ///< how often the box was lost
  std::optional<std::int64_t> gap;  ///< begin of the present gap [ns]
  std::int64_t first_gap = 0;       ///< begin of the first gap, record time [ns]
  std::int64_t gaps_length = 0;     ///< total of the gaps that have ended [ns]
  std::string reason;               ///< of the first gap; if there never was a box, the newest
  bool is_lost = false;             ///< had a box, but none at the end
  bool is_object = false;
  std::int64_t time = 0;           ///< for an object: how long it was there [ns]
  std::int64_t covered = 0;        ///< part of `time` with a box [ns]
  std::optional<double> coverage;  ///< of a link, see Coverage; of an object, covered / time
  std::int64_t delay = 0;          ///< of the first box of a link [ns], see Coverage
  std::string remedy;              ///< for a link whose box came late or never; "" if none is known
  bool is_waiting = false;         ///< has no box until tf says where it was placed
  std::int64_t waited = 0;         ///< time of waiting [ns]; it is covered if tf places it
  std::string waits;               ///< why it, or its new marker, waits for tf; "" if it does not
  std::shared_ptr<const ObjectContent> waiting;  ///< the marker that waits
  bool is_there = false;  ///< for an object: it was in the scene at the last add()
  std::string partial;    ///< why the box does not cover everything; "" if it does
};

/// Speed of the centre of a box from one stamp to the next [m/s]. std::nullopt between static
/// boxes, if stamps do not grow, if the speed is not finite, or if the stamps are farther apart
/// than `timeout` [s; 0: no limit].
std::optional<double> centreSpeed(const Aabb& from, std::int64_t from_stamp, const Aabb& to,
                                  std::int64_t to_stamp, double timeout);

class BoxRecords {
 public:
  /// Objects of further names are only counted, so that memory has a limit.
  static constexpr std::size_t kMaxObjects = 10'000;

  /// Takes all boxes of a scene that has a model. True if the box of a link appeared or
  /// disappeared.
  bool add(const Scene& scene, std::int64_t now);

  /// Ends the gaps, and the time of objects that are there.
  void finish(std::int64_t now);

  /// In the order of ~boxes.
  std::vector<BoxRecord> records() const;

  /// Whether a link ever had a box.
  bool hasLinkBox() const;

  std::uint64_t objectsLeftOut() const { return left_out_; }

 private:
  BoxRecord* recordOf(const SceneBody& body);
  void passTo(std::int64_t now);

  std::vector<BoxRecord> links_;
  std::map<ObjectKey, BoxRecord> objects_;
  std::vector<BoxRecord*> present_;  ///< objects that were there at the last add()
  std::int64_t last_ = 0;            ///< time of the last add() [ns]
  std::uint64_t left_out_ = 0;       ///< boxes of objects beyond kMaxObjects
};

}  // namespace link_bounds
