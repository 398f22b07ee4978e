#include "collision_forge/attack/forecast/motion_estimate.h"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>

namespace forge {

std::size_t unbrokenStart(const std::vector<AgentState>& states, int frames) {
  std::size_t first = states.size() - 1;
  while (first > 0 && states.size() - first < static_cast<std::size_t>(frames) &&
         states[first].time - states[first - 1].time <= kMaxGap) {
    --first;
  }
  return first;
}

Motion estimateMotion(const Track& track, int frames) {
  if (track.states.empty()) throw std::invalid_argument("track " + track.id + " has no states");
  const AgentState& newest = track.states.back();
  const std::size_t first = unbrokenStart(track.states, frames);
  const auto count = static_cast<Eigen::Index>(track.states.size() - first);
  Motion motion{newest.pose};
  if (count < 2) return motion;

  // Columns of the design: 1, t, t^2/2 with t = 0 at the newest state.
  const Eigen::Index degree = std::min<Eigen::Index>(count - 1, 2);
  Eigen::MatrixXd design(count, degree + 1);
  Eigen::MatrixXd values(count, 3);
  for (Eigen::Index row = 0; row < count; ++row) {
    const AgentState& state = track.states[first + static_cast<std::size_t>(row)];
    const double t = state.time - newest.time;
    design(row, 0) = 1.0;
    design(row, 1) = t;
    if (degree == 2) design(row, 2) = 0.5 * t * t;
    values.row(row) << state.pose.x - newest.pose.x, state.pose.y - newest.pose.y,
        angleBetween(newest.pose.yaw, state.pose.yaw);
  }
  const Eigen::MatrixXd positions = design.colPivHouseholderQr().solve(values.leftCols(2));
  const Eigen::MatrixXd yaws = design.leftCols(2).colPivHouseholderQr().solve(values.col(2));

  const Vector2 heading = newest.pose.heading();
  motion.speed = heading.dot(positions.row(1).transpose());
  if (degree == 2) motion.acceleration = heading.dot(positions.row(2).transpose());
  motion.yaw_rate = yaws(1, 0);
  return motion;
}

}  // namespace forge
