// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Motions of the bodies of a scene between two looks at them, in one frame.
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
/// transforms. Each box is computed from the body itself, not from the scene's box. Links, and
/// objects that follow a frame, are where tf has them in this frame. Objects that were placed once
/// move with the scene's fixed frame.
class FrameView {
 public:
  /// `scene` and `tf` must outlive this; the scene must have a model.
  FrameView(const std::string& frame, Scene& scene, TransformBuffer& tf, ros::Time now);

  /// Call it after each message. True if a box of a link changed.
  bool update(ros::Time now);

  /// Call it with each tick. True if a box of a link changed.
  bool expire(ros::Time now);

  TransformBuffer::Frame frame() const { return *frames_.fixedFrame(); }

  struct Placed {
    BoxState state;
    std::int64_t pose_stamp = 0;  ///< [ns], if there is a box; 0: it does not move
  };

  /// A body of the scene.
  Placed placed(const SceneBody& body);

  /// Stamp of the pose of the scene's fixed frame in the view [ns]; 0 if it has no pose or is
  /// static.
  std::int64_t fixedStamp();

 private:
  const FramePose& poseOf(const std::string& frame);

  Scene& scene_;
  FrameTracker frames_;
  LiveBoxes links_;
  struct Followed {
    TransformBuffer::Hold hold;  ///< keeps the frame in tf while it is followed
    FrameTracker::Handle handle;
  };
  std::map<std::string, Followed> followed_;  ///< by name: frames of objects, the fixed frame
};

/// A motion, as tf2 interpolates it. Valid until tf changes.
struct BodyMotion {
  MotionSpan span;  ///< the stamps of both boxes
  Aabb before;      ///< the box at its begin
  double way;       ///< upper bound on the path length of all points [m]; may be infinite
  TransformBuffer::Frame target;
  TransformBuffer::Frame source;  ///< the frame of the body, or the one in which it was placed
  const BoundedLink* link;        ///< its shapes
  const Eigen::Affine3d* source_from_link;            ///< null: identity
  std::optional<Eigen::Affine3d> view_from_target{};  ///< nothing: the box has the target's axes
  /// For an object that was replaced at the end: by how much the end is older than the newest stamp
  /// [ns].
  std::optional<std::int64_t> since_replaced{};
  bool is_begin_new = false;  ///< the box at its begin was not visited
};

/// Tells bodies apart faster than their names: a link has its index, an object its own number for
/// as long as it is there.
using BodyNumber = std::uint64_t;

/// Upper bound on the distance of all points of the shapes from the origin of the source frame [m].
double radiusOf(const BodyMotion& motion);

/// A body moves while the stamp of its box grows: from one transform to a later one, however long
/// that takes, even if its box was lost meanwhile. A link moves from the first stamp at which tf
/// knows it. A marker that came again is another body, and so is every body after a backward jump
/// of the clock; there is no motion to them. An object that is placed once stands still since its
/// stamp.
class BodyMotions {
 public:
  /// `view` shows the scene in another frame than its fixed one; null: in the fixed frame. All must
  /// outlive this.
  BodyMotions(Scene& scene, EdgeWays& edges, FrameView* view);

  /// Call it when boxes change before the first forEach(), also after finish(). Links, and objects
  /// that follow a frame, then move from here, even if they are lost at the first forEach().
  void remember();

  /// Calls visit(number, name, state, motion) as Scene::forEach; `motion` is null if there was none
  /// since the last call. Before it, calls visit_rest(number, name, motion) in two cases: the view
  /// was lost before the body moved on; then the motion is relative to the last pose of the view.
  /// Or an object that was placed once was replaced; then it stands until the stamp of the new one.
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

  /// Ends all motions: calls visit_rest as above. Call it before tf forgets.
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
    std::int64_t ahead = 0;  ///< stamp of the box in the scene, if there is a view; else 0
    Aabb box;
    bool is_new = false;                          ///< `box` was not visited
    std::shared_ptr<const ObjectContent> object;  ///< kept, so that its address is not used again
    std::optional<Eigen::Affine3d> place;  ///< in the scene's fixed frame, if it stands there
    std::vector<Former> formers;
    BodyNumber number = 0;
    std::uint64_t seen = 0;  ///< the last pass with this body

    /// Keeps only the number and the objects that were replaced before.
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

  /// Forgets objects that are gone, but not those that they replaced, which stand until their
  /// stamp.
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
  /// Newest stamp of the scene's fixed frame in the view so far; 0: none yet, or it stands.
  std::int64_t view_stamp_ = 0;
  std::int64_t view_since_ = 0;  ///< begin of the motions up to view_stamp_
  std::vector<double> radii_;    ///< of the links
  std::vector<Last> last_links_;
  std::map<ObjectKey, Last> last_objects_;
  std::uint64_t pass_ = 0;
  BodyNumber last_number_;  ///< of the newest body
  BodyMotion motion_;
};

}  // namespace link_bounds
