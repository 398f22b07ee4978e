#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"

namespace forge {

class LaneRandom {
 public:
  explicit LaneRandom(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

 private:
  std::mt19937 engine_;
};

inline Lane makeLane(const std::string& id, const std::vector<Vector2>& points,
                     const std::vector<std::string>& outgoing = {}) {
  Lane lane;
  lane.id = id;
  lane.outgoing = outgoing;
  for (const Vector2& point : points) {
    lane.centerline.push_back({point.x(), point.y(), 0.0});
  }
  return lane;
}

/// Returns points of an arc from `start` with a total turn of `turn`.
inline std::vector<Vector2> arc(const Pose2& start, double length, double turn) {
  std::vector<Vector2> points = {start.position()};
  double yaw = start.yaw + 0.05 * turn;
  for (int i = 0; i < 10; ++i, yaw += 0.1 * turn) {
    points.push_back(points.back() + 0.1 * length * Vector2(std::cos(yaw), std::sin(yaw)));
  }
  return points;
}

/// Returns winding lanes of all directions, including one without points and one of a single point.
inline LaneMap randomMap(LaneRandom& random, int count) {
  LaneMap map;
  for (int i = 0; i < count; ++i) {
    const Pose2 start{random.between(-100, 100), random.between(-100, 100),
                      random.between(-M_PI, M_PI)};
    map.lanes.push_back(
        makeLane(std::to_string(i), arc(start, random.between(1, 60), random.between(-2, 2))));
  }
  map.lanes[1].centerline.clear();
  map.lanes[2].centerline.resize(1);
  map.lanes[3].centerline.assign(4, Pose2{1.0, 2.0, 0.3});
  return map;
}

}  // namespace forge
