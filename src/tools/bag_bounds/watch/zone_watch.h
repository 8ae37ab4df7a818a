// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Who was in which zone, and how near the nearest body came.
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

/// As in all formats.
const char* toText(StayEnd end);

/// One body in one zone. Where it entered or left between two messages, that happened between two
/// known stamps: `outside_at` and that of `entered`, `inside_at` and that of `left`.
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
  std::optional<NearestToZone> nearest;  ///< of all poses that were looked at
  /// Proven: nothing that has a box ever came nearer, also between messages [m]; 0 if something
  /// entered it, or if that is not decided.
  double clearance = std::numeric_limits<double>::infinity();
  std::uint64_t undecided = 0;  ///< motions
  std::string first_undecided;  ///< the first of these, in words
  /// The share of the time in which links had boxes, in which all of these also had one in the
  /// frame of the zone.
  double coverage = 1;
  bool is_lost = false;  ///< at the end, or where the clock jumped back, some of these had none
  bool is_late = false;  ///< all first had one when tf had forgotten how they moved before
};

/// A body is in a zone while its box, with padding, and the zone overlap or touch: at a message, or
/// between two of them. Who is inside at both is not looked at between them.
class ZoneWatch {
 public:
  /// A body at the edge of a zone may enter it without end; further entries are only counted.
  static constexpr std::size_t kMaxStays = 1000;

  /// `gives_up` is asked often while a motion between two messages is looked at.
  explicit ZoneWatch(
      const std::vector<Zone>& zones, std::function<bool()> gives_up = [] { return false; });

  /// To be called when the scene has a model. Both must outlive this, which holds frames of `tf`.
  void watch(Scene& scene, TransformBuffer& tf, ros::Time now);

  /// To be called when a box of the scene changed, at the record time [ns]; `is_reported`: compares
  /// all boxes with the zones.
  void onNews(std::int64_t now, bool is_reported);

  /// To be called after each message or tick, after onNews().
  void onStep(std::int64_t now, bool is_tick, bool is_reported);

  /// To be called before tf forgets: all motions are over.
  void endMotions();

  /// Ends the stays of those that are in a zone.
  void finish(std::int64_t now);

  std::vector<ZoneRecord> records() const;
  bool wasEntered() const;

  /// Motions between messages of which it is not known whether they met a zone.
  std::uint64_t undecided() const;

  /// A zone in whose frame there never was a box; null if there is none.
  const Zone* neverCompared() const;

 private:
  /// A body in a zone.
  struct Inside {
    std::size_t stay;  ///< in ZoneRecord::stays; beyond the last if it is only counted
    std::uint64_t seen;
    std::int64_t stamp;
  };

  struct Watched {
    ZoneRecord record;
    /// Looked up for each box that is compared: by names it took a tenth of the time of a bag.
    std::unordered_map<BodyNumber, Inside> inside;
  };

  /// The zones of one frame.
  struct Group {
    FrameView* view;  ///< null: that of the scene
    BodyMotions motions;
    std::vector<Watched*> zones;
    std::int64_t compared = 0;            ///< the last time [ns]
    std::optional<std::int64_t> sampled;  ///< the last time at which the next two were looked up
    bool is_compared = false;             ///< since motions ended
    bool has_boxes = false;               ///< a link had a box
    bool is_whole = false;                ///< and so it had in the frame of the zones
    bool was_whole = false;               ///< since motions ended
    std::optional<std::int64_t> since{};  ///< when a link first had a box since then [ns]
    std::int64_t time = 0;                ///< with boxes [ns]
    std::int64_t whole_time = 0;          ///< of that [ns]
  };

  using InsideBody = std::unordered_map<BodyNumber, Inside>::iterator;

  /// A body that is compared with the zones of a group.
  struct Seen {
    BodyNumber number;
    const std::string& name;
    const BoxState& state;     ///< with a box
    const BodyMotion* motion;  ///< null: it stood
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
  std::optional<EdgeWays> edges_;  ///< which the zones of all frames share
  std::function<bool()> gives_up_;
  std::vector<Watched> zones_;
  std::map<std::string, FrameView> views_;  ///< by frame, without the fixed one
  std::map<std::string, Group> groups_;     ///< by frame
  EdgeBegins begins_;
  std::uint64_t tf_version_ = 0;     ///< of which the views are
  bool have_views_changed_ = false;  ///< since they were compared
  std::uint64_t comparisons_ = 0;
};

}  // namespace link_bounds
