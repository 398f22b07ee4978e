#pragma once

#include <geometry_msgs/Polygon.h>

#include <optional>

namespace forge {

/// State of RViz's view TopDownOrtho: the middle, m in its target frame, and the scale in pixels
/// per metre.
struct TopView {
  double x = 0.0;      ///< m
  double y = 0.0;      ///< m
  double scale = 1.0;  ///< pixels per metre
};

/// Returns the view that contains `area` in a picture of `width` x `height` pixels. `area` must
/// have points and an extent.
TopView viewOf(const geometry_msgs::Polygon& area, int width, int height);

/// Moves a view smoothly to a changing area. Zoom and offset that the user sets are kept.
class FollowingView {
 public:
  /// Returns the view `duration` seconds after the last call. `shown` is the view in the picture,
  /// `goal` the view of the area. The first call returns `goal`.
  TopView next(const TopView& shown, const TopView& goal, double duration);
  /// Drops the user's zoom and offset; the next call returns its goal.
  void reset() { set_.reset(); }

 private:
  void takeOver(const TopView& shown);

  std::optional<TopView> set_;  ///< result of the last call
  TopView fitted_;              ///< the same without the user's zoom and offset
  TopView user_;                ///< offset (m) and zoom factor of the user
};

}  // namespace forge
