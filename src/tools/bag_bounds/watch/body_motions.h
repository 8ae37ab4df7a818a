// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How the bodies of a scene moved from one look at them to the next, in one frame.
#pragma once

#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/bodies/scene.h"
#include "world/history/way_bound.h"

namespace link_bounds {

/// The boxes of a scene with the axes of another frame, by a second tracker over the same
/// transforms. Each box is that of the body itself, not a box around the scene's box. Links, and
/// objects that follow a frame, are where tf has them in this frame; objects that were placed once
/// move with the scene's fixed frame.
class FrameView {
 public:
  /// Both must outlive this; the scene has a model.
  FrameView(const std::string& frame, Scene& scene, TransformBuffer& tf, ros::Time now);

  /// To be called after each message. True if a box of a link changed.
  bool update(ros::Time now);

  /// To be called with each tick. True if a box of a link changed.
  bool expire(ros::Time now);

  TransformBuffer::Frame frame() const { return *frames_.fixedFrame(); }

  struct Placed {
    BoxState state;
    std::int64_t pose_stamp = 0;  ///< [ns], if there is a box; 0: it does not move
  };

  /// A body of the scene.
  Placed placed(const SceneBody& body);

  /// The stamp of the scene's fixed frame in the view; 0 if there is none, or if it stands.
  std::int64_t fixedStamp();

 private:
  const FramePose& poseOf(const std::string& frame);

  Scene& scene_;
  FrameTracker frames_;
  LiveBoxes links_;
  struct Followed {
    TransformBuffer::Hold hold;  ///< while it is followed; the frame may be forgotten later
    FrameTracker::Handle handle;
  };
  std::map<std::string, Followed> followed_;  ///< of objects, and the fixed frame
};

/// A motion, as tf2 interpolates it. Valid until tf changes.
struct BodyMotion {
  MotionSpan span;  ///< the stamps of both boxes
  Aabb before;      ///< the box at its begin
  double way;       ///< that no point of the body exceeds [m]; may be infinite
  TransformBuffer::Frame target;
  TransformBuffer::Frame source;  ///< the frame of the body, or the one in which it was placed
  const BoundedLink* link;        ///< its shapes
  const Eigen::Affine3d* source_from_link;            ///< null: as they are
  std::optional<Eigen::Affine3d> view_from_target{};  ///< nothing: the box has the target's axes
  /// Of an object that was replaced at the end: so much older is that than the newest stamp [ns].
  std::optional<std::int64_t> since_replaced{};
  bool is_begin_new = false;  ///< the box at its begin was not visited
};

/// Tells bodies apart faster than their names: a link has its index, an object its own number for
/// as long as it is there.
using BodyNumber = std::uint64_t;

/// All points of the shapes are at most so far from the origin of the motion's source [m].
double radiusOf(const BodyMotion& motion);

/// A body moves while the stamp of its box grows, from one transform to a later one, however long
/// that takes, and whether or not its box was lost meanwhile; a link, from the first stamp at which
/// tf knows it. It does not move, but is another one, where a marker came again, and where the
/// clock jumped back. An object that is placed once stands since its stamp.
class BodyMotions {
 public:
  /// `view` has the axes of another frame than the scene's fixed one; null: these. All must outlive
  /// this.
  BodyMotions(Scene& scene, EdgeWays& edges, FrameView* view);

  /// To be called before the first forEach(), also after finish(), when boxes change: links, and
  /// objects that follow a frame, move from there, also those that are lost when it begins.
  void remember();

  /// Calls visit(number, name, state, motion) as Scene::forEach; `motion` is null if there was none
  /// since the last call. Before it, calls visit_rest(number, name, motion) where the view was lost
  /// before the body moved on: of that motion, beside the last place of the view; and of an object
  /// that was placed once, until the stamp of the one that replaced it.
  template <class VisitRest, class Visit>
  void forEach(VisitRest&& visit_rest, Visit&& visit) {
    ++pass_;
    followView();
    scene_.forEach([&](const SceneBody& body) {
      const FrameView::Placed placed = placedIn(body);
      Last& last = lastOf(body);
      if (!placed.state.box && hasRest(last, body))
        visit_rest(last.number, body.name, rest(last, body));
      noteReplaced(last, body);
      visitFormers(last, visit_rest);
      const BodyMotion* motion = next(last, body, placed);
      visit(last.number, body.name, placed.state, motion);
    });
    forgetObjects(visit_rest);
  }

  /// All motions are over: calls visit_rest as above. To be called before tf forgets.
  template <class VisitRest>
  void finish(VisitRest&& visit_rest) {
    scene_.forEach([&](const SceneBody& body) {
      Last& last = lastOf(body);
      if (hasRest(last, body)) visit_rest(last.number, body.name, rest(last, body));
    });
    view_stamp_ = 0;
    for (Last& last : last_links_)
      last.stamp = last.ahead = 0;
    for (auto& [key, last] : last_objects_) {
      last.stamp = last.ahead = 0;
      last.formers.clear();
    }
  }

 private:
  /// An object that was placed once and replaced. It stands until the stamp of the new one, which
  /// may be ahead of the view.
  struct Former {
    std::shared_ptr<const ObjectContent> object;
    Eigen::Affine3d place;  ///< in the scene's fixed frame
    Aabb box;               ///< in the view at `stamp`
    std::int64_t stamp;
    std::int64_t until;
  };

  struct Last {
    std::int64_t stamp = 0;  ///< of the newest pose; 0: there was none, or it does not move
    std::int64_t ahead = 0;  ///< that of the scene's box, as long as it is newer; else 0
    Aabb box;
    bool is_new = false;                          ///< the box was not visited
    std::shared_ptr<const ObjectContent> object;  ///< kept, so that its address is not used again
    std::optional<Eigen::Affine3d> place;  ///< in the scene's fixed frame, if it stands there
    std::vector<Former> formers;
    BodyNumber number = 0;
    std::uint64_t seen = 0;  ///< pass

    /// All but what was replaced before.
    void forget() {
      stamp = ahead = 0;
      object.reset();
      place.reset();
    }
  };

  FrameView::Placed placedIn(const SceneBody& body);
  FrameView::Placed placedInScene(const SceneBody& body) const;
  Last& lastOf(const SceneBody& body);
  void followView();
  void beginKnown(Last& last, const BoxSource& source, const FrameView::Placed& placed) const;
  bool hasRest(const Last& last, const SceneBody& body) const;
  const BodyMotion& rest(Last& last, const SceneBody& body);
  void noteReplaced(Last& last, const SceneBody& body) const;
  void forgetFormers(Last& last) const;
  const BodyMotion* untilReplaced(Former& former);
  const BodyMotion* next(Last& last, const SceneBody& body, const FrameView::Placed& placed);

  template <class VisitRest>
  void visitFormers(Last& last, VisitRest&& visit_rest) {
    forgetFormers(last);
    for (Former& former : last.formers) {
      if (const BodyMotion* motion = untilReplaced(former))
        visit_rest(last.number, former.object->bounded.name, *motion);
    }
  }

  /// What was replaced by one of them stands until its stamp nevertheless.
  template <class VisitRest>
  void forgetObjects(VisitRest&& visit_rest) {
    if (last_objects_.size() == scene_.objects.objects().size()) return;
    for (auto entry = last_objects_.begin(); entry != last_objects_.end();) {
      Last& last = entry->second;
      const bool is_gone = last.seen != pass_;
      if (is_gone) {
        last.forget();
        visitFormers(last, visit_rest);
      }
      entry = is_gone && last.formers.empty() ? last_objects_.erase(entry) : std::next(entry);
    }
  }

  Scene& scene_;
  FrameView* view_;
  WayBound ways_;
  WayBound scene_ways_;
  TransformBuffer::Frame target_;
  std::int64_t view_stamp_ = 0;  ///< of the scene's fixed frame in the view; 0: none, or it stands
  std::int64_t view_since_ = 0;  ///< the motions that lead there begin
  std::vector<double> radii_;    ///< of the links
  std::vector<Last> last_links_;
  std::map<ObjectKey, Last> last_objects_;
  std::uint64_t pass_ = 0;
  BodyNumber last_number_;  ///< of the newest body
  BodyMotion motion_;
};

}  // namespace link_bounds
