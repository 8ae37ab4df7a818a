// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads bags, moves the scene, and records what the report needs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "tools/bag_bounds/boxes/boxes_bag.h"
#include "tools/bag_bounds/boxes/coverage.h"
#include "tools/bag_bounds/boxes/series_file.h"
#include "tools/bag_bounds/run/bag_bounds_options.h"
#include "tools/bag_bounds/run/bag_question.h"
#include "tools/bag_bounds/run/bag_report.h"
#include "tools/bag_bounds/run/record_order.h"
#include "tools/bag_bounds/scene/recorded_scene.h"

namespace link_bounds {

class BagRun {
 public:
  /// Called regularly with the share of the bags that was read, 0 to 1, and with 1 at the end.
  using OnProgress = std::function<void(double share)>;

  /// Opens all files. Throws std::exception. `options` and `question` must outlive this.
  BagRun(const BagBoundsOptions& options, BagQuestion& question, OnProgress on_progress);
  BagRun(const BagRun&) = delete;
  BagRun& operator=(const BagRun&) = delete;

  /// Reads the bags to the end of the report. Throws std::exception.
  void read();

  /// Call it after read().
  BagReport report() const;

  /// Why the report is about nothing, or not about all zones; "" if it is useful, or was
  /// interrupted.
  std::string whyUseless(const BagReport& report) const;

  /// The outcome of the report. Warns of losses, and says why the report is useless.
  Outcome outcome(const BagReport& report) const;

 private:
  void begin();
  void takeStatic();
  void findOtherTopics();
  bool lacksLinkBox() const;
  void readMessages();
  void endMotions();
  bool passToEnd();
  bool lookBefore(std::int64_t message);
  bool lookBetween(std::int64_t message);
  void beginBoxesAt(std::int64_t next);
  bool isReported(std::int64_t now) const { return from_ <= now && now <= to_; }
  void onNews(std::int64_t now);
  void onStep(std::int64_t now, bool is_tick);
  void record(std::int64_t now);
  bool glance();
  void addCoverage(std::vector<BoxRecord>& boxes) const;
  std::vector<std::string> losses() const;
  static void addOpenPairs(const NearestPairs& pairs, Outcome& outcome);
  const BagBoundsOptions& options_;
  BagQuestion& question_;
  OnProgress on_progress_;
  BagReader reader_;
  std::unique_ptr<JointTransforms> joints_;
  const std::shared_ptr<const Model> model_;
  RecordedScene scene_;
  ZoneWatch zones_;  ///< after the scene, whose frames it holds
  BoxRecords boxes_;
  Coverage coverage_;
  std::optional<BoxesAt> boxes_at_;
  std::optional<NearestPairs> pairs_;
  std::optional<BoxesBag> out_;
  std::optional<SeriesFile> series_;
  std::int64_t begin_ = 0;  ///< record time of the first message [ns]
  std::int64_t from_ = 0;   ///< begin of what is reported, record time [ns]
  std::int64_t to_ = 0;
  std::set<std::int64_t> looks_;  ///< record times to look at even without a message [ns]
  std::int64_t last_ = 0;         ///< the newest record time that is reported [ns]
  RecordOrder order_;
  bool has_recorded_ = false;
  bool was_interrupted_ = false;
  std::uint64_t messages_ = 0;
  std::uint64_t steps_ = 0;
  std::uint64_t back_before_start_ = 0;  ///< messages before --start, after the report began
  bool ended_early_ = false;             ///< at --end
  bool goes_back_after_end_ = false;     ///< after --end, record times go back to unread messages
  std::set<std::string> unused_topics_;
  std::string other_topics_;  ///< remedy: other topics with transforms; "" if there are none
  std::vector<std::string> static_losses_;  ///< of the bag of --static-from
  TfIntake intake_before_;                  ///< transforms of needed edges before the report
};

}  // namespace link_bounds
