#pragma once

#include <geometry_msgs/Polygon.h>

#include <optional>

namespace forge {

/// State of an RViz TopDownOrtho view: centre in metres in its target frame, scale in pixels per
/// metre.
struct TopView {
  double x = 0.0;
  double y = 0.0;
  double scale = 1.0;
};

/// Returns the view that fits `area` (m) into `width` x `height` pixels. `area` must have a
/// positive extent.
TopView viewOf(const geometry_msgs::Polygon& area, int width, int height);

/// Moves a view smoothly towards a goal view and keeps the zoom and offset set by the user.
class FollowingView {
 public:
  /// Returns the next view, `duration` seconds after the last call. `shown`: current view,
  /// including changes by the user; `goal`: view that fits the area. The first call returns `goal`.
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
