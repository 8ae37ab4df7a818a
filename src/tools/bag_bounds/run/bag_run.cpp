// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Before --start, transforms are taken, but nothing is recorded.
#include "tools/bag_bounds/run/bag_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robot/threads/row_threads.h"
#include "robot/urdf/trimmed.h"
#include "tools/bag_bounds/scene/record_time.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"

namespace link_bounds {
namespace {

constexpr std::uint64_t kStepsPerGlance = 256;  // between two calls of OnProgress

constexpr char kStaticEnd[] = "_static";

std::string staticTopic(const BagBoundsOptions& options) {
  return options.tf_topic + kStaticEnd;
}

/// "/tf" for both "/tf" and "/tf_static".
std::string withoutStatic(const std::string& topic) {
  return withoutEnd(topic, kStaticEnd).value_or(topic);
}

std::set<std::string> topicsOf(const BagBoundsOptions& options) {
  std::set<std::string> topics = options.objects;
  if (options.joint_states.empty()) {
    topics.insert({options.tf_topic, staticTopic(options)});
  } else {
    topics.insert(options.joint_states);
  }
  return topics;
}

/// `begin` [ns] plus any number of seconds.
std::int64_t after(std::int64_t begin, double seconds) {
  constexpr double kFar = 4e9;  // s
  return begin + std::llround(std::min(seconds, kFar) * 1e9);
}

/// Adds losses: transforms that boxes needed, but that were left out. Repeated transforms are no
/// loss, unless they contradict each other.
void addRefusals(const TfIntake& before, const TfIntake& after, std::vector<std::string>& losses) {
  const auto add = [&](std::uint64_t TfIntake::*what, const std::string& why) {
    const std::uint64_t count = after.*what - before.*what;
    if (count > 0)
      losses.push_back(std::to_string(count) + (count == 1 ? " transform" : " transforms") +
                       " left out, " + why);
  };
  add(&TfIntake::unusable, "which tf2 refuses, too; a warning names a frame");
  add(&TfIntake::too_old, "more than 10 s older than others of their frame; record them in time");
  add(&TfIntake::other,
      "because another pose of the same frame and stamp came first; end one of the publishers");
  add(&TfIntake::dropped, "of the time before a jump of the clock");
}

}  // namespace

BagRun::BagRun(const BagBoundsOptions& options, BagQuestion& question, OnProgress on_progress)
    : options_(options),
      question_(question),
      on_progress_(std::move(on_progress)),
      reader_(
          options.bags, topicsOf(options), [this] { return glance(); },
          options.jobs.value_or(coreCount())),
      model_(question.model()),
      scene_([this](const std::string& uri) { return question_.loadMesh(uri); },
             [this](std::int64_t now) { onNews(now); },
             [this](std::int64_t now, bool is_tick) { onStep(now, is_tick); }, options.tf_topic),
      zones_(question.zones(), isInterrupted),
      unused_topics_(options.objects) {
  if (options.distances)
    pairs_.emplace([this](const std::string& uri) { return question_.loadTree(uri); });
  if (!options.joint_states.empty())
    joints_ = std::make_unique<JointTransforms>(*model_->robot, options.parameters.tf_prefix);
  if (!options.out.empty()) out_.emplace(options.out);
  if (!options.series.empty()) series_.emplace(options.series);
}

/// The first message may be of any topic, as for rosbag play. If reading it was interrupted, the
/// report begins at 0 and ends there.
void BagRun::begin() {
  BagMessage first{};
  BagReader all(options_.bags, {}, isInterrupted);
  if (!all.next(first) && !all.wasInterrupted()) {
    const auto& losses = all.losses();
    throw std::runtime_error("there is no message to read" +
                             (losses.empty() ? "; the bags are empty" : ": " + losses.front()));
  }
  begin_ = first.time;
  from_ = after(begin_, options_.start);
  to_ = options_.end ? after(begin_, *options_.end) : std::numeric_limits<std::int64_t>::max();
  if (options_.start == 0) from_ = std::numeric_limits<std::int64_t>::min();
  last_ = begin_;
  looks_ = {from_};
  if (options_.at) looks_.insert(boxes_at_.emplace(after(begin_, *options_.at)).stamp());
  scene_.adopt(model_, begin_);
  zones_.watch(scene_.scene(), scene_.tf(), toRosTime(begin_));
  if (joints_) scene_.takeJoints(options_.joint_states, *joints_);
  if (!options_.static_from.empty()) takeStatic();
  onStep(begin_, false);
}

/// Takes the static transforms as if they had been sent at the begin.
void BagRun::takeStatic() {
  BagReader reader({options_.static_from}, {staticTopic(options_)}, isInterrupted);
  BagMessage message{};
  bool is_empty = true;
  for (; reader.next(message); is_empty = false)
    scene_.takeStatic(message);
  static_losses_ = reader.losses();
  intake_before_ = scene_.tf().neededIntake();
  if (is_empty && !reader.wasInterrupted())
    throw UsageError("--static-from " + options_.static_from + " has no message on " +
                     staticTopic(options_) + "; name the bag of the first part of the recording");
}

void BagRun::read() {
  begin();
  readMessages();
  on_progress_(1);
  beginBoxesAt(std::numeric_limits<std::int64_t>::max());
  if (!was_interrupted_) endMotions();
  coverage_.sample(scene_.scene(), scene_.tf(), last_);
  boxes_.finish(last_);
  zones_.finish(last_);
  if (out_) out_->close();
  if (series_) series_->close();
  findOtherTopics();
  for (const std::string& topic : was_interrupted_ ? std::set<std::string>() : unused_topics_)
    warn("no message on " + topic + " was read; see rosbag info for the topics of the bags");
  for (const std::string& topic : scene_.objectTopics().ignored())
    warn(topic +
         " has only what a node of link_bounds draws, which is ignored; give the topic of "
         "its boxes to --objects");
  if (was_interrupted_) {
    say("interrupted " + shortSeconds(scene_.now(), begin_) + " s after the begin, " +
        std::to_string(static_cast<int>(100 * reader_.progress())) +
        " % of the bags were read; the report ends there");
  }
}

/// Looks through the bags again, but only where a remedy may name another topic.
void BagRun::findOtherTopics() {
  if (joints_ || (scene_.transforms() > 0 && !lacksLinkBox())) return;
  std::set<std::string> topics;
  BagReader reader(options_.bags, {}, isInterrupted, options_.jobs.value_or(coreCount()));
  for (BagMessage message{}; reader.next(message);) {
    const bool is_tf = *message.type == "tf2_msgs/TFMessage" || *message.type == "tf/tfMessage";
    if (is_tf) topics.insert(withoutStatic(*message.topic));
  }
  topics.erase(options_.tf_topic);
  for (const std::string& topic : topics)
    other_topics_ += (other_topics_.empty() ? "--tf-topic " : " or --tf-topic ") + topic;
  if (!topics.empty())
    other_topics_ =
        "the bags have transforms on " + *topics.begin() + ", too; add " + other_topics_;
}

/// True if a link with shapes never had a box.
bool BagRun::lacksLinkBox() const {
  const std::vector<BoxRecord> boxes = boxes_.records();
  for (std::size_t i = 0; i < std::min(model_->links.size(), boxes.size()); ++i) {
    if (!boxes[i].has_box && !model_->links[i].shapes.empty()) return true;
  }
  return false;
}

void BagRun::readMessages() {
  BagMessage message;
  while (reader_.next(message)) {
    was_interrupted_ = !lookBefore(message.time);
    if (was_interrupted_) return;
    if (message.time > to_) {
      was_interrupted_ = !scene_.passTo(to_);
      goes_back_after_end_ = reader_.goesBackTo(to_);
      was_interrupted_ |= reader_.wasInterrupted();
      ended_early_ = true;
      return;
    }
    const bool is_jump_back = scene_.goesBackTo(message.time);
    if (is_jump_back) {
      endMotions();
      coverage_.jumpBack(message.time);
    }
    order_.watch(message, is_jump_back);
    if (!unused_topics_.empty()) unused_topics_.erase(*message.topic);
    if (has_recorded_ && message.time < from_) ++back_before_start_;
    if (scene_.take(message)) ++messages_;
    was_interrupted_ = isInterrupted();
    if (was_interrupted_) return;
  }
  was_interrupted_ = reader_.wasInterrupted() || !passToEnd();
}

/// Lets time pass to the end of the bags: other topics may go on after those that are read. False
/// if it was interrupted.
bool BagRun::passToEnd() {
  const std::int64_t end = std::min(reader_.endTime(), to_);
  if (end <= scene_.now()) return true;
  if (!lookBefore(end) || !scene_.passTo(end)) return false;
  onStep(end, false);
  return true;
}

/// Lets time pass to the begin of the report and to --at if they are before the message. The scene
/// at that time counts, before a message changes it. False if it was interrupted.
bool BagRun::lookBefore(std::int64_t message) {
  if (!lookBetween(message)) return false;
  beginBoxesAt(message);
  return true;
}

bool BagRun::lookBetween(std::int64_t message) {
  for (const std::int64_t time : looks_) {
    if (time <= scene_.now() || time >= message || time > to_) continue;
    if (!scene_.passTo(time)) return false;
    onStep(time, false);
  }
  return true;
}

/// Begins --at after the last message up to its time.
void BagRun::beginBoxesAt(std::int64_t next) {
  if (!boxes_at_ || boxes_at_->hasBegun()) return;
  const std::int64_t stamp = boxes_at_->stamp();
  if (stamp <= scene_.now() && stamp != next && stamp <= to_)
    boxes_at_->begin(scene_.scene(), scene_.tf());
}

void BagRun::endMotions() {
  zones_.endMotions();
  if (boxes_at_) boxes_at_->endMotions();
  if (pairs_) pairs_->endMotions(scene_.tf());
}

/// The reader calls it regularly.
bool BagRun::glance() {
  on_progress_(reader_.progress());
  return isInterrupted();
}

void BagRun::onNews(std::int64_t now) {
  zones_.onNews(now, isReported(now));
  if (isReported(now)) {
    record(now);
  } else if (pairs_) {
    pairs_->remember(scene_.scene(), now);
  }
}

/// Also records the scene as it is when the report begins.
void BagRun::onStep(std::int64_t now, bool is_tick) {
  if (++steps_ % kStepsPerGlance == 0) on_progress_(reader_.progress());
  zones_.onStep(now, is_tick, isReported(now));
  if (boxes_at_) boxes_at_->look(scene_.scene(), scene_.tf(), now);
  if (!isReported(now)) {
    if (!has_recorded_) intake_before_ = scene_.tf().neededIntake();
    return;
  }
  last_ = now;
  if (is_tick) coverage_.sample(scene_.scene(), scene_.tf(), now);
  if (has_recorded_) return;
  zones_.onNews(now, true);
  record(now);
}

void BagRun::record(std::int64_t now) {
  has_recorded_ = true;
  last_ = now;
  if (boxes_.add(scene_.scene(), now)) coverage_.sample(scene_.scene(), scene_.tf(), now);
  if (pairs_) pairs_->add(scene_.scene(), scene_.tf(), now);
  if (out_) out_->write(scene_.scene(), now);
  if (series_) {
    series_->add(scene_.scene(), pairs_ ? pairs_->latest() : std::vector<Distance>(), now, begin_);
  }
}

BagReport BagRun::report() const {
  BagReport report;
  report.frame = model_->fixed_frame;
  report.left_out = model_->left_out;
  report.begin = begin_;
  report.from = std::max(from_, begin_);
  report.to = std::max(report.from, last_);
  report.messages = messages_;
  report.boxes = boxes_.records();
  addCoverage(report.boxes);
  if (boxes_at_) {
    report.at = boxes_at_->stamp();
    report.boxes_at = boxes_at_->boxes(scene_.scene());
  }
  report.min_coverage = options_.min_coverage;
  report.zones = zones_.records();
  if (pairs_) report.distances = pairs_->pairs();
  report.has_compared = pairs_ && pairs_->hasCompared();
  report.distance_limit = options_.distances.value_or(0);
  report.losses = losses();
  return report;
}

/// Messages about recorded data that is missing in the report.
std::vector<std::string> BagRun::losses() const {
  std::vector<std::string> losses = reader_.losses();
  losses.insert(losses.end(), static_losses_.begin(), static_losses_.end());
  if (const std::uint64_t count = scene_.damaged(); count > 0)
    losses.push_back(std::to_string(count) + (count == 1 ? " message is" : " messages are") +
                     " too short and left out; the bag is damaged, record it again");
  if (const std::uint64_t count = scene_.unfit(); count > 0)
    losses.push_back(std::to_string(count) + (count == 1 ? " message" : " messages") +
                     " of joints left out, with other than one position for each name, "
                     "which robot_state_publisher ignores, too");
  for (const std::string& loss : {scene_.objectTopics().loss(), joints_ ? joints_->loss() : ""})
    if (!loss.empty()) losses.push_back(loss);
  const std::vector<std::int64_t>& steps_back = order_.stepsBack();
  if (!steps_back.empty())
    losses.push_back("record time goes back " + std::to_string(steps_back.size()) +
                     (steps_back.size() == 1 ? " time, to " : " times, first to ") +
                     shortSeconds(steps_back.front(), begin_) +
                     " s: messages are not in the order of their times, as where one topic was "
                     "written after the other; sort them: rosbag filter OLD.bag NEW.bag True");
  if (back_before_start_ > 0)
    losses.push_back("after the clock went back, " + std::to_string(back_before_start_) +
                     " messages have a time before --start; leave out --start");
  if (goes_back_after_end_)
    losses.emplace_back(
        "after --end the clock went back, to messages that were not read; leave out --end");
  addRefusals(intake_before_, scene_.tf().neededIntake(), losses);
  if (was_interrupted_) losses.emplace_back("interrupted before the end");
  return losses;
}

/// Adds the coverage of links, which are the first boxes. Links without shapes get none.
void BagRun::addCoverage(std::vector<BoxRecord>& boxes) const {
  const std::vector<double> shares = coverage_.shares();
  const std::vector<std::int64_t> delays = coverage_.delays();
  for (std::size_t i = 0; i < std::min(shares.size(), boxes.size()); ++i) {
    if (model_->links[i].shapes.empty()) continue;
    boxes[i].coverage = shares[i];
    boxes[i].delay = delays[i];
    if (boxes[i].has_box) {
      const std::string bag = options_.bags.size() == 1 ? options_.bags.front() : "BAG";
      if (!joints_ && options_.static_from.empty())
        boxes[i].remedy = lateRemedy(i, bag, scene_.scene(), scene_.tf());
    } else if (joints_) {
      const std::string names = joined(joints_->missing(), ", ");
      if (!names.empty()) boxes[i].remedy = "no message has the position of " + names;
    } else {
      boxes[i].remedy = other_topics_ + (other_topics_.empty() ? "" : "; ") +
                        frameRemedy(i, scene_.scene(), scene_.tf());
    }
  }
}

/// Returns "" after an interrupt: the user knows that there may be more.
std::string BagRun::whyUseless(const BagReport& report) const {
  if (was_interrupted_) return "";
  if (scene_.transforms() == 0 && ended_early_)
    return "there are no transforms before --end; let it be later";
  if (scene_.transforms() == 0 && joints_)
    return "there is no message on " + options_.joint_states +
           "; see rosbag info for the topics of the bags";
  if (scene_.transforms() == 0)
    return "there is no message on " + options_.tf_topic + " or " + staticTopic(options_) + "; " +
           (other_topics_.empty() ? "record them, or name the bags that have them" : other_topics_);
  if (!has_recorded_)
    return "nothing was recorded between --start and --end; the bags end " +
           shortSeconds(scene_.now(), begin_) + " s after their begin";
  if (!boxes_.hasLinkBox())
    return "no link ever had a box: " + withRemedy(report.boxes.front()) +
           "; is it the bag of this robot, and does --fixed-frame exist in it?";
  if (const Zone* zone = zones_.neverCompared())
    return "zone \"" + zone->name +
           "\" was never compared with a link: tf does not connect its frame \"" + zone->frame +
           "\" with the robot; correct the frame, or record what connects it";
  return "";
}

/// Adds the open questions about distances of pairs.
void BagRun::addOpenPairs(const NearestPairs& pairs, Outcome& outcome) {
  if (pairs.wasInterrupted())
    outcome.open.emplace_back("distances of the last step, which was interrupted");
  if (!pairs.hasCompared()) outcome.open.emplace_back(kNothingCompared);
  outcome.addOpen("names of which not all distances are known", pairs.incomplete().size());
  if (pairs.undecided() > 0)
    warn(std::to_string(pairs.undecided()) +
         " motions of two bodies between two messages are not decided, the first of " +
         pairs.firstUndecided() + "; record tf at a higher rate");
  outcome.addOpen("motions of pairs that are not decided", pairs.undecided());
  outcome.addOpen("distances of further pairs", pairs.pairsLeftOut());
  outcome.addOpen("meshes without triangles", pairs.problems().size());
}

Outcome BagRun::outcome(const BagReport& report) const {
  Outcome outcome;
  for (const std::string& loss : report.losses)
    warn(loss);
  if (pairs_) {
    for (const std::string& problem : pairs_->problems())
      warn("distances to the convex hull only: " + problem);
  }
  for (const ZoneRecord& zone : report.zones) {
    if (zone.undecided > 0)
      warn("zone \"" + zone.zone.name + "\": " + std::to_string(zone.undecided) +
           " motions between two messages are not decided, the first of " + zone.first_undecided +
           "; record tf at a higher rate");
  }
  outcome.has_finding = zones_.wasEntered() || (pairs_ && pairs_->wasUndercut());
  const std::string useless = whyUseless(report);
  if (!useless.empty()) say((outcome.has_finding ? "warning: " : "error: ") + useless);
  outcome.is_unusable = !useless.empty() && !outcome.has_finding;
  const std::size_t warnings = model_->robot->warnings.size();
  outcome.lost_geometry = !model_->problems.empty() || warnings > 0;
  outcome.addOpen("warnings of the URDF", warnings);
  outcome.addOpen("losses while reading", report.losses.size());
  outcome.addOpen("incomplete names", incompleteOf(report).size());
  outcome.addOpen("topics without any message", unused_topics_.size());
  outcome.addOpen("topics whose messages are all ignored", scene_.objectTopics().ignored().size());
  outcome.addOpen("motions beside zones that are not decided", zones_.undecided());
  if (pairs_ || !options_.zones.empty()) {
    const TfIntake& intake = scene_.tf().neededIntake();
    outcome.addOpen("late transforms, which change motions that were looked at",
                    intake.late - intake_before_.late);
    outcome.addOpen(
        "static transforms that replaced others, beside which motions were not looked at",
        intake.replaced - intake_before_.replaced);
  }
  outcome.addOpen("boxes of further objects", boxes_.objectsLeftOut());
  if (pairs_) addOpenPairs(*pairs_, outcome);
  return outcome;
}

}  // namespace link_bounds
