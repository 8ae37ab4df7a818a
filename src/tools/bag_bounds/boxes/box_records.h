// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far each link and object reached, and when it had no box.
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
  std::optional<Extreme> speed;     ///< the largest of its centre [m/s], see centreSpeed
  std::optional<Aabb> last;         ///< the box of the last time
  std::int64_t last_stamp = 0;      ///< its stamp [ns]
  std::uint64_t gaps = 0;           ///< how often the box was lost
  std::optional<std::int64_t> gap;  ///< begin of the present gap [ns]
  std::int64_t first_gap = 0;       ///< record time of its begin [ns]
  std::int64_t gaps_length = 0;     ///< of those that have ended [ns]
  std::string reason;               ///< of the first gap; without any box: the newest
  bool is_lost = false;             ///< had a box, but none at the end
  bool is_object = false;
  std::int64_t time = 0;           ///< of an object: how long it was there [ns]
  std::int64_t covered = 0;        ///< of that, with a box [ns]
  std::optional<double> coverage;  ///< of links, see Coverage; of objects, of `time`
  std::int64_t delay = 0;          ///< of links, of the first box [ns], see Coverage
  std::string remedy;              ///< for a link whose box came late or never; "" if none is known
  bool is_waiting = false;         ///< has no box until tf says where it was placed
  std::int64_t waited = 0;         ///< so long [ns]; covered if it is placed, since its stamp
  std::string waits;               ///< why it, or its new marker, waits; "" if nothing does
  std::shared_ptr<const ObjectContent> waiting;  ///< that marker
  bool is_there = false;  ///< of an object: it was in the scene at the last add()
  std::string partial;    ///< why the box does not cover everything; "" if it does
};

/// How fast the centre of a box moved from one stamp to the next [m/s]. Nothing between static
/// boxes, where stamps do not grow, where it is not finite, and where they are farther apart than
/// `timeout` [s; 0: never].
std::optional<double> centreSpeed(const Aabb& from, std::int64_t from_stamp, const Aabb& to,
                                  std::int64_t to_stamp, double timeout);

class BoxRecords {
 public:
  /// Objects of further names are only counted, so that memory has a limit.
  static constexpr std::size_t kMaxObjects = 10'000;

  /// Takes all boxes of a scene that has a model. True if the box of a link came or went.
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
  std::int64_t last_ = 0;            ///< time of that [ns]
  std::uint64_t left_out_ = 0;       ///< boxes of objects
};

}  // namespace link_bounds
