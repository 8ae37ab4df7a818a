// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which bodies were in which zone, and how near the nearest body came.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "tools/bag_bounds/scene/edge_begins.h"
#include "tools/bag_bounds/scene/record_time.h"
#include "tools/bag_bounds/watch/body_motions.h"
#include "tools/bag_bounds/watch/zone_search.h"
#include "tools/bag_bounds/watch/zones.h"

namespace link_bounds {

/// How a stay in a zone ended: the box left, there was no box any more, or the report ended.
enum class StayEnd { kLeft, kLost, kReportEnded };

/// The word for it in all formats.
const char* toText(StayEnd end);

/// The stay of one body in one zone. An entry between two messages lies between the stamps
/// `outside_at` and that of `entered`, an exit between `inside_at` and that of `left`.
struct Stay {
  std::string name;
  RecordTime entered;
  std::optional<std::int64_t> outside_at;  ///< the last stamp at which it was known outside [ns]
  StayEnd end = StayEnd::kReportEnded;
  RecordTime left;                        ///< when it ended
  std::optional<std::int64_t> inside_at;  ///< the last stamp at which it was known inside [ns]
};

struct NearestToZone {
  std::string name;
  double distance;  ///< of the two boxes [m], see signedDistance: no point of the body is nearer
  RecordTime when;
};

struct ZoneRecord {
  Zone zone;
  std::uint64_t entries = 0;
  std::vector<Stay> stays;               ///< the first kMaxStays of the entries, as they are found
  std::optional<Stay> first;             ///< the first entry in time, without its end
  std::optional<NearestToZone> nearest;  ///< of all poses that were examined
  /// Proven: no body that has a box came nearer, also between messages [m]. 0 if a body entered the
  /// zone, or if that is undecided.
  double clearance = std::numeric_limits<double>::infinity();
  std::uint64_t undecided = 0;  ///< number of motions that may have met the zone
  std::string first_undecided;  ///< a message about the first of them
  /// How much of the time in which links had boxes, each of these links also had one in the frame
  /// of the zone (0 to 1).
  double coverage = 1;
  bool is_lost = false;  ///< at the end, or at a backward jump, a link lacked a box in that frame
  bool is_late = false;  ///< all links first had one after tf forgot their earlier motions
};

/// A body is in a zone while its box, with padding, and the zone overlap or touch: at a message, or
/// between two messages. If it is inside at both, the motion between them is not examined.
class ZoneWatch {
 public:
  /// A body at the edge of a zone may enter it without end; further entries are only counted.
  static constexpr std::size_t kMaxStays = 1000;

  /// `gives_up` is called often while a motion between two messages is examined; true ends that.
  explicit ZoneWatch(
      const std::vector<Zone>& zones, std::function<bool()> gives_up = [] { return false; });

  /// Call it when the scene has a model. `scene` and `tf` must outlive this, which holds frames of
  /// `tf`.
  void watch(Scene& scene, TransformBuffer& tf, ros::Time now);

  /// Call it when a box of the scene changed, at the record time `now` [ns]. `is_reported`:
  /// compares all boxes with the zones.
  void onNews(std::int64_t now, bool is_reported);

  /// Call it after each message or tick, after onNews().
  void onStep(std::int64_t now, bool is_tick, bool is_reported);

  /// Ends all motions. Call it before tf forgets.
  void endMotions();

  /// Ends the stays of all bodies that are in a zone.
  void finish(std::int64_t now);

  std::vector<ZoneRecord> records() const;
  bool wasEntered() const;

  /// Number of motions between messages for which it is not known whether they met a zone.
  std::uint64_t undecided() const;

  /// A zone in whose frame there never was a box; null if there is none.
  const Zone* neverCompared() const;

 private:
  /// A body in a zone.
  struct Inside {
    std::size_t stay;  ///< index in ZoneRecord::stays; past its end: only counted
    std::uint64_t seen;
    std::int64_t stamp;
  };

  struct Watched {
    ZoneRecord record;
    /// By number, because it is looked up for each box: by name that took a tenth of all time.
    std::unordered_map<BodyNumber, Inside> inside;
  };

  /// The zones of one frame.
  struct Group {
    FrameView* view;  ///< null: the frame is the scene's fixed one
    BodyMotions motions;
    std::vector<Watched*> zones;
    std::int64_t compared = 0;            ///< record time of the last comparison [ns]
    std::optional<std::int64_t> sampled;  ///< record time of the last sample() [ns]
    bool is_compared = false;             ///< at least once since motions ended
    bool has_boxes = false;               ///< at the last sample: a link had a box
    bool is_whole = false;                ///< and each such link had one in the frame of the zones
    bool was_whole = false;               ///< is_whole was true since motions ended
    std::optional<std::int64_t> since{};  ///< when a link first had a box after that [ns]
    std::int64_t time = 0;                ///< total time with boxes [ns]
    std::int64_t whole_time = 0;          ///< part of `time` while is_whole is true [ns]
  };

  using InsideBody = std::unordered_map<BodyNumber, Inside>::iterator;

  /// A body that is compared with the zones of a group.
  struct Seen {
    BodyNumber number;
    const std::string& name;
    const BoxState& state;     ///< empty if only `motion` is examined
    const BodyMotion* motion;  ///< null: it did not move
  };

  void updateViews(ros::Time now);
  void compareOrRemember(Group& group, std::int64_t now, bool is_reported);
  void compare(Group& group, std::int64_t now);
  void sample(Group& group, std::int64_t now);
  static void note(bool ZoneRecord::*fault, const Group& group);
  static void noteEnd(const Group& group);
  void visit(Watched& watched, const Seen& body, std::int64_t now);
  void visitBegin(Watched& watched, const Seen& body, std::int64_t now) const;
  static std::optional<std::int64_t> outsideAt(const Watched& watched, const Seen& body);
  void lookAtRest(Group& group, const Seen& body, std::int64_t now);
  void lookAtRest(Watched& watched, const Seen& body, std::int64_t now);
  void lookBetween(Watched& watched, const Seen& body, double distance, std::int64_t now);
  void take(Watched& watched, const Seen& body, const ZoneSearch& found, std::int64_t now);
  InsideBody enter(Watched& watched, const Seen& body, const RecordTime& now,
                   std::optional<std::int64_t> outside_at) const;
  static void end(Watched& watched, InsideBody body, StayEnd how, const RecordTime& now);

  Scene* scene_ = nullptr;
  TransformBuffer* tf_ = nullptr;
  std::optional<EdgeWays> edges_;  ///< shared by the zones of all frames
  std::function<bool()> gives_up_;
  std::vector<Watched> zones_;
  std::map<std::string, FrameView> views_;  ///< by frame, without the scene's fixed frame
  std::map<std::string, Group> groups_;     ///< by frame
  EdgeBegins begins_;
  std::uint64_t tf_version_ = 0;     ///< version of tf for which the views are up to date
  bool have_views_changed_ = false;  ///< since the last comparison
  std::uint64_t comparisons_ = 0;
};

}  // namespace link_bounds
