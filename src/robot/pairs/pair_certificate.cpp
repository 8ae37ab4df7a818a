// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/pair_certificate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>

#include "robot/pairs/pair_search.h"

namespace link_bounds {
namespace {

constexpr std::size_t kMaxBoxes = 1'000'000;
constexpr double kFinestDistance = 1e-8;  // m
constexpr double kMargin = 1e-8;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Directions are rounded to multiples of 1 / kDigits, which is as good, and shorter to write.
constexpr double kDigits = 1e6;

/// An interval of shares is not halved further if its half is shorter than this.
constexpr double kShortest = 1e-9;

struct Shares {
  double middle;
  double half;
};

/// Writes a tree. `close` writes the proof for a box, or returns false. `halve` writes the variable
/// that is halved and returns the halves, the one with smaller values first, or nothing.
template <typename Box, typename Close, typename Halve>
bool writeHalved(const Box& whole, const Close& close, const Halve& halve,
                 const std::function<bool()>& is_over, std::ostream& out) {
  std::vector<Box> open{whole};
  for (std::size_t count = 0; !open.empty(); ++count) {
    if (count > kMaxBoxes || is_over()) return false;
    const Box box = std::move(open.back());
    open.pop_back();
    out << (count > 0 ? "," : "[");
    if (close(box)) continue;
    const std::optional<std::array<Box, 2>> parts = halve(box);
    if (!parts) return false;
    open.push_back(parts->back());
    open.push_back(parts->front());
  }
  out << "]";
  return true;
}

}  // namespace

PairCertificate::PairCertificate(JointPath path, const PairBody& first, const PairBody& second,
                                 PairClaim claim)
    : path_(std::move(path)),
      first_(first),
      second_(second),
      claim_(claim),
      motion_(path_, first.hull.cloud, second.hull.cloud) {
  distances_.set(0, first.body);
  distances_.set(1, second.body);
  distances_.move(0, Eigen::Affine3d::Identity());
}

bool PairCertificate::writeTree(const std::function<bool()>& is_over, std::ostream& out) {
  const auto close = [&](const JointBox& box) { return writeClosing(box, out); };
  const auto halve = [&](const JointBox& box) -> std::optional<std::array<JointBox, 2>> {
    if (path_.variables.empty()) return std::nullopt;
    const std::size_t widest = motion_.widestVariable();
    out << widest;
    return halves(box, widest);
  };
  return writeHalved(wholeBox(path_), close, halve, is_over, out);
}

bool PairCertificate::writeTree(const BoxOfShares& box_of, const std::function<bool()>& is_over,
                                std::ostream& out) {
  const auto close = [&](const Shares& shares) {
    return writeClosing(box_of(shares.middle, shares.half), out);
  };
  const auto halve = [&](const Shares& shares) -> std::optional<std::array<Shares, 2>> {
    const double half = shares.half / 2;
    if (path_.variables.empty() || half < kShortest) return std::nullopt;
    out << 0;
    return {{Shares{shares.middle - half, half}, Shares{shares.middle + half, half}}};
  };
  return writeHalved(Shares{0.5, 0.5}, close, halve, is_over, out);
}

/// Writes the proof for a box. False if the box must be halved.
bool PairCertificate::writeClosing(const JointBox& box, std::ostream& out) {
  path_.place(box.center, placed_);
  motion_.set(box, placed_);
  return claim_.is_contact ? writeContact(out) : writeGap(out);
}

bool PairCertificate::writeGap(std::ostream& out) {
  const BodyCloud& first = first_.hull.cloud;
  const BodyCloud& second = second_.hull.cloud;
  const Eigen::Vector3d between = placed_.first_from_second * second.center() - first.center();
  if (writeDirection(between, first_.hull, second_.hull, out)) return true;
  if (first.radius() + second.radius() + between.norm() < motion_.motion()) return false;
  if (writeDirection(directionOf(first_.hull, second_.hull), first_.hull, second_.hull, out))
    return true;
  if (writeDirections(out)) return true;
  if (!areTrianglesApart()) return false;
  out << "\"mesh\"";
  return true;
}

/// Writes two points that stay within the claimed distance. The margin is for checkers, which bound
/// the motion with other rounding.
bool PairCertificate::writeContact(std::ostream& out) {
  const Eigen::Affine3d first_from_second(placed_.first_from_second);
  const double max_distance =
      claim_.distance - motion_.motion() * (1 + kMargin) - 2 * motion_.rounding();
  distances_.move(1, first_from_second);
  distances_.setGoal({kFinestDistance, kNoLimit, PairGoal::kMaxTreeSteps});
  auto found = distances_.find(0, 1);
  if (!found || found->upper > max_distance)
    found = coreContact(first_, second_, first_from_second, max_distance);
  if (!found) return false;
  const Eigen::Vector3d& a = found->on_first;
  const Eigen::Vector3d b = placed_.first_from_second.inverse() * found->on_second;
  std::ostringstream text;
  text.precision(17);
  text << "[[" << a.x() << "," << a.y() << "," << a.z() << "],[" << b.x() << "," << b.y() << ","
       << b.z() << "]]";
  out << text.str();
  return true;
}

/// Writes the direction and returns true if the two are as far apart along it as claimed, anywhere
/// in the box.
bool PairCertificate::writeDirection(Eigen::Vector3d direction, const PairHull& first,
                                     const PairHull& second, std::ostream& out) const {
  const double length = direction.norm();
  if (!(length > 0)) return false;
  const Eigen::Array3d rounded = (direction / length * kDigits).array().round() / kDigits;
  direction = rounded.matrix().normalized();
  const Eigen::Isometry3d& pose = placed_.first_from_second;
  const double gap = direction.dot(pose.translation()) - first.cloud.support(direction) -
                     second.cloud.support(pose.linear().transpose() * -direction);
  const double least = claim_.distance + motion_.rounding();
  if (gap - motion_.motion() < least &&
      motion_.gapAlong(direction, first.cloud, second.cloud) < least)
    return false;
  out << "[" << rounded.x() << "," << rounded.y() << "," << rounded.z() << "]";
  return true;
}

/// Writes a direction for each pair of shapes.
bool PairCertificate::writeDirections(std::ostream& out) const {
  if (first_.parts.empty() && second_.parts.empty()) return false;
  std::ostringstream text;
  for (const PairHull* first : partsOf(first_)) {
    for (const PairHull* second : partsOf(second_)) {
      text << (text.tellp() > 0 ? "," : "[");
      if (!writeDirection(directionOf(*first, *second), *first, *second, text)) return false;
    }
  }
  out << text.str() << "]";
  return true;
}

/// A direction along which the hulls are nearly as far apart as possible; zero if they touch.
Eigen::Vector3d PairCertificate::directionOf(const PairHull& first, const PairHull& second) const {
  const auto distance = bodyDistance(*first.body, Eigen::Affine3d::Identity(), *second.body,
                                     Eigen::Affine3d(placed_.first_from_second),
                                     {accuracy(), kNoLimit, PairGoal::kMaxTreeSteps});
  return distance ? distance->normal : Eigen::Vector3d::Zero();
}

/// The accuracy of distances in the box [m].
double PairCertificate::accuracy() const {
  return std::max(kFinestDistance, PairGoal::kShareOfMotion * motion_.motion());
}

bool PairCertificate::areTrianglesApart() {
  const double least = claim_.distance + motion_.motion() + motion_.rounding();
  distances_.move(1, Eigen::Affine3d(placed_.first_from_second));
  distances_.setGoal({accuracy(), least + accuracy(), PairGoal::kMaxTreeSteps});
  const std::optional<BodyDistance> distance = distances_.find(0, 1);
  return distance && distance->lower >= least;
}

}  // namespace link_bounds
