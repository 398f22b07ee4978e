#include "collision_forge/io/maps/open_drive_strips.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace forge {
namespace {

/// A border at one arc length of the reference line.
struct BorderPoint {
  double offset = 0.0;  ///< m from the reference line, positive to the left
  double slope = 0.0;   ///< change of the offset with the arc length
};

BorderPoint borderAt(const PiecewiseCubic& cubic, double arc_length) {
  return {cubic.value(arc_length), cubic.slope(arc_length)};
}

/// Returns the outer border of a lane. `middle`: the lane offset; `side`: 1 left, -1 right.
BorderPoint outerBorder(const OpenDriveLane& lane, const BorderPoint& middle,
                        const BorderPoint& inner, double side, double arc_length) {
  const BorderPoint outline = borderAt(lane.outline, arc_length);
  if (lane.is_border) return {middle.offset + outline.offset, middle.slope + outline.slope};
  if (!(outline.offset > 0.0)) return inner;
  return {inner.offset + side * outline.offset, inner.slope + side * outline.slope};
}

/// Returns the distance (m) of samples between two arc lengths: at most `resolution`, less in
/// bends.
double spacing(const ReferenceLine& line, double from, double to, double resolution) {
  constexpr double kMostSag = 0.01;  // m between a bend and its chord
  constexpr double kReach = 10.0;    // m; lanes outside of a bend are longer than its line
  constexpr double kClosest = 0.05;  // m; at a cusp
  double bend = 0.0;
  for (const double share : {0.0, 0.5, 1.0}) {
    bend = std::max(bend, std::abs(line.at(from + share * (to - from)).curvature));
  }
  const double close = std::sqrt(8.0 * kMostSag / (bend * (1.0 + bend * kReach)));
  return std::min(resolution, std::max(close, kClosest));
}

/// Returns the arc lengths at which a section is sampled: at both ends, where a polynomial or a
/// piece of the reference line begins, and between.
std::vector<double> sampledAt(const OpenDriveRoad& road, const OpenDriveSection& section,
                              double resolution) {
  std::set<double> corners(road.line.begins().begin(), road.line.begins().end());
  const auto add = [&](const PiecewiseCubic& cubic) {
    for (const auto& [begin, piece] : cubic.pieces()) corners.insert(begin);
  };
  add(road.lane_offset);
  for (const OpenDriveLane& lane : section.left) add(lane.outline);
  for (const OpenDriveLane& lane : section.right) add(lane.outline);

  // A step of a polynomial or of the line at the section's end belongs to the next section.
  constexpr double kBeforeEnd = 1e-9;  // m
  const double last = std::max(section.begin, section.end - kBeforeEnd);
  constexpr double kApart = 1e-3;  // m; closer points have no useful direction
  std::vector<double> samples = {section.begin};
  corners.insert(last);
  for (auto corner = corners.upper_bound(section.begin + kApart); corner != corners.end();
       ++corner) {
    if (*corner > last || (*corner != last && *corner > last - kApart)) continue;
    const double from = samples.back();
    if (*corner - from < kApart) continue;
    const double most = spacing(road.line, from, *corner, resolution);
    const int steps = std::max(1, static_cast<int>(std::ceil((*corner - from) / most)));
    for (int i = 1; i <= steps; ++i) samples.push_back(from + (*corner - from) * i / steps);
  }
  return samples;
}

void addPoint(const LinePoint& line, const BorderPoint& inner, const BorderPoint& outer,
              double side, LaneStrip& strip) {
  const Pose2& pose = line.pose;
  const Vector2 normal(-std::sin(pose.yaw), std::cos(pose.yaw));
  const double offset = 0.5 * (inner.offset + outer.offset);
  const double slope = 0.5 * (inner.slope + outer.slope);
  const Vector2 centre = pose.position() + offset * normal;
  const double turn = std::atan2(slope, 1.0 - line.curvature * offset);
  strip.centre.push_back({centre.x(), centre.y(), wrapAngle(pose.yaw + turn)});
  strip.left.push_back(pose.position() + std::max(inner.offset, outer.offset) * normal);
  strip.right.push_back(pose.position() + std::min(inner.offset, outer.offset) * normal);
  strip.widest = std::max(strip.widest, side * (outer.offset - inner.offset));
}

void addPoints(const LinePoint& line, const std::vector<OpenDriveLane>& lanes,
               const BorderPoint& middle, double side, double arc_length,
               std::vector<LaneStrip>& strips) {
  BorderPoint inner = middle;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const BorderPoint outer = outerBorder(lanes[i], middle, inner, side, arc_length);
    addPoint(line, inner, outer, side, strips[i]);
    inner = outer;
  }
}

}  // namespace

SectionStrips laneStrips(const OpenDriveRoad& road, const OpenDriveSection& section,
                         double resolution) {
  SectionStrips strips{std::vector<LaneStrip>(section.left.size()),
                       std::vector<LaneStrip>(section.right.size())};
  for (const double arc_length : sampledAt(road, section, resolution)) {
    const LinePoint line = road.line.at(arc_length);
    const BorderPoint middle = borderAt(road.lane_offset, arc_length);
    addPoints(line, section.left, middle, 1.0, arc_length, strips.left);
    addPoints(line, section.right, middle, -1.0, arc_length, strips.right);
  }
  return strips;
}

}  // namespace forge
