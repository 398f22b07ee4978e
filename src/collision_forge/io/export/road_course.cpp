#include "collision_forge/io/export/road_course.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace forge {
namespace {

constexpr double kMinPiece = 1e-6;   // m; shorter pieces are rounding
constexpr double kMinLength = 0.05;  // m, of a course
constexpr double kMinWidth = 2.0;    // m
constexpr double kMaxWidth = 8.0;    // m
constexpr int kMostSteps = 50;       // of a search along a course
constexpr double kTolerance = 1e-7;  // m, of its result

void addArcs(const ArcPath& path, std::vector<RoadPiece>& pieces) {
  double begin = 0.0;
  for (std::size_t i = 0; i < path.shape.size(); ++i) {
    const double length = path.segment_length[i];
    if (length > kMinPiece) pieces.push_back({poseAt(path, begin), length, curvatureOf(path, i)});
    begin += length;
  }
}

/// Adds the arc that leaves a pose along its heading and ends at a point.
void addArcThrough(const Pose2& from, const Vector2& to, std::vector<RoadPiece>& pieces) {
  const Vector2 chord = to - from.position();
  const double distance = chord.norm();
  if (distance <= kMinPiece) return;
  const double half_turn = angleBetween(from.yaw, std::atan2(chord.y(), chord.x()));
  if (std::abs(half_turn) < 1e-9) {
    pieces.push_back({from, distance, 0.0});
  } else {
    pieces.push_back(
        {from, distance * half_turn / std::sin(half_turn), 2.0 * std::sin(half_turn) / distance});
  }
}

}  // namespace

RoadCourse::RoadCourse(std::vector<RoadPiece> pieces) : pieces_(std::move(pieces)) {
  for (const RoadPiece& piece : pieces_) {
    begins_.push_back(length_);
    length_ += piece.length;
  }
}

Pose2 RoadCourse::poseAt(double arc_length) const {
  const auto after = std::upper_bound(begins_.begin() + 1, begins_.end(), arc_length);
  const auto index = static_cast<std::size_t>(after - begins_.begin()) - 1;
  const RoadPiece& piece = pieces_[index];
  const double along = arc_length - begins_[index];
  const double inside = std::clamp(along, 0.0, piece.length);
  return alongArc(alongArc(piece.start, piece.curvature, inside), 0.0, along - inside);
}

RoadCourse RoadCourse::between(double from, double to) const {
  std::vector<RoadPiece> part;
  const auto add = [&](const Pose2& start, double length, double curvature) {
    if (length > kMinPiece) part.push_back({start, length, curvature});
  };
  add(poseAt(from), std::min(to, 0.0) - from, 0.0);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const RoadPiece& piece = pieces_[i];
    const double first = std::clamp(from - begins_[i], 0.0, piece.length);
    const double last = std::clamp(to - begins_[i], 0.0, piece.length);
    add(first > 0.0 ? alongArc(piece.start, piece.curvature, first) : piece.start, last - first,
        piece.curvature);
  }
  add(poseAt(std::max(from, length_)), to - std::max(from, length_), 0.0);
  return RoadCourse(std::move(part));
}

double RoadCourse::crossing(const Pose2& pose, double guess) const {
  constexpr int kMostSteps = 20;
  constexpr double kTolerance = 1e-7;   // m
  constexpr double kLongestStep = 5.0;  // m; a bend may turn away within a longer one
  double at = guess;
  for (int i = 0; i < kMostSteps; ++i) {
    const Pose2 here = poseAt(at);
    const double ahead = (here.position() - pose.position()).dot(pose.heading());
    if (std::abs(ahead) < kTolerance) return at;
    const double rate = here.heading().dot(pose.heading());
    if (std::abs(rate) < 0.1) break;
    at -= std::clamp(ahead / rate, -kLongestStep, kLongestStep);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double RoadCourse::projection(const Vector2& point, double guess) const {
  double at = guess;
  for (int i = 0; i < kMostSteps; ++i) {
    const Pose2 here = poseAt(at);
    const double ahead = (point - here.position()).dot(here.heading());
    if (std::abs(ahead) < kTolerance) return at;
    at += ahead;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double RoadCourse::roughProjection(const Vector2& point) const {
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  const auto count = static_cast<int>(std::ceil(length_));
  for (int i = 0; i <= count; ++i) {
    const double at = length_ * i / count;
    const double distance = (poseAt(at).position() - point).squaredNorm();
    if (distance < least) std::tie(best, least) = std::pair(at, distance);
  }
  return best;
}

void RoadCourse::append(const RoadCourse& other) {
  for (const RoadPiece& piece : other.pieces_) {
    pieces_.push_back(piece);
    begins_.push_back(length_);
    length_ += piece.length;
  }
}

RoadCourse courseOf(const Lane& lane, const LaneArcs& arcs) {
  std::vector<RoadPiece> pieces;
  const auto found = arcs.find(lane.id);
  if (found != arcs.end()) {
    for (const ArcPath& path : found->second) addArcs(path, pieces);
  } else {
    for (std::size_t i = 1; i < lane.centerline.size(); ++i) {
      addArcThrough(lane.centerline[i - 1], lane.centerline[i].position(), pieces);
    }
  }
  RoadCourse course(std::move(pieces));
  return course.length() < kMinLength ? RoadCourse() : course;
}

double widthOf(const Lane& lane, double length, double otherwise) {
  if (lane.polygon.size() < 3 || !(length > 0.0)) return otherwise;
  double twice_area = 0.0;
  for (std::size_t i = 0; i < lane.polygon.size(); ++i) {
    const Vector2 a = lane.polygon[i] - lane.polygon[0];
    const Vector2 b = lane.polygon[(i + 1) % lane.polygon.size()] - lane.polygon[0];
    twice_area += a.x() * b.y() - b.x() * a.y();
  }
  return std::clamp(std::abs(twice_area) / 2.0 / length, kMinWidth, kMaxWidth);
}

}  // namespace forge
