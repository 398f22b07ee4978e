#pragma once

#include <geometry_msgs/Polygon.h>

#include <optional>

namespace forge {

/// State of RViz's view TopDownOrtho: the middle, m in its target frame, and the scale in pixels
/// per metre.
struct TopView {
  double x = 0.0;      ///< m, middle of the picture
  double y = 0.0;      ///< m, middle of the picture
  double scale = 1.0;  ///< pixels per metre
};

/// Returns the view that shows the bounding rectangle (along x and y) of the points of `area` (m,
/// target frame) in the middle and as large as possible in a picture of `width` x `height` pixels.
/// The points must have an extent along x and along y.
TopView viewOf(const geometry_msgs::Polygon& area, int width, int height);

/// Moves a view smoothly (exponentially, with a time constant of 0.35 s) to a changing area. Zoom
/// and offset that the user sets are kept.
class FollowingView {
 public:
  /// Returns the view to show now, `duration` seconds after the last call. `shown` is the present
  /// view in the picture: its difference to the last result (more than 1 cm, or 0.1 % of the scale)
  /// is a change by the user. `goal` is viewOf() the area. The first call returns `goal`; if the
  /// goal is more than 150 m from the view without the user's offset, the view jumps there.
  TopView next(const TopView& shown, const TopView& goal, double duration);
  /// Drops the user's zoom and offset; the next call returns its goal.
  void reset() { set_.reset(); }

 private:
  /// Adds what the user changed since the last call to `user_`.
  void takeOver(const TopView& shown);

  std::optional<TopView> set_;  ///< result of the last call; empty before the first
  TopView fitted_;              ///< the same without the user's zoom and offset
  TopView user_;                ///< of the user: offset (x, y: m) and zoom (scale: a factor)
};

}  // namespace forge
