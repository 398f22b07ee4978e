#include "collision_forge/ros/rviz/following_view.h"

#include <algorithm>
#include <cmath>

namespace forge {

namespace {

constexpr double kSettling = 0.35;     // s, time constant of the motion to the goal
constexpr double kLongestPan = 150.0;  // m; the view jumps to a goal farther away
constexpr double kSamePlace = 0.01;    // m; the properties of RViz are floats
constexpr double kSameScale = 1e-3;    // relative

}  // namespace

TopView viewOf(const geometry_msgs::Polygon& area, int width, int height) {
  const auto [left, right] =
      std::minmax_element(area.points.begin(), area.points.end(),
                          [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [low, high] =
      std::minmax_element(area.points.begin(), area.points.end(),
                          [](const auto& a, const auto& b) { return a.y < b.y; });
  return {(left->x + right->x) / 2.0, (low->y + high->y) / 2.0,
          std::min(width / (right->x - left->x), height / (high->y - low->y))};
}

TopView FollowingView::next(const TopView& shown, const TopView& goal, double duration) {
  if (!set_) {
    fitted_ = goal;
    user_ = {};
  } else {
    takeOver(shown);
    const bool is_far = std::hypot(goal.x - fitted_.x, goal.y - fitted_.y) > kLongestPan;
    const double share = is_far ? 1.0 : 1.0 - std::exp(-duration / kSettling);
    fitted_.x += share * (goal.x - fitted_.x);
    fitted_.y += share * (goal.y - fitted_.y);
    fitted_.scale *= std::pow(goal.scale / fitted_.scale, share);
  }
  set_ = {fitted_.x + user_.x, fitted_.y + user_.y, fitted_.scale * user_.scale};
  return *set_;
}

/// Adds the difference between `shown` and the last result to the user's offset and zoom.
void FollowingView::takeOver(const TopView& shown) {
  if (std::hypot(shown.x - set_->x, shown.y - set_->y) > kSamePlace) {
    user_.x += shown.x - set_->x;
    user_.y += shown.y - set_->y;
  }
  const double zoom = shown.scale / set_->scale;
  if (std::abs(zoom - 1.0) > kSameScale) user_.scale *= zoom;
}

}  // namespace forge
