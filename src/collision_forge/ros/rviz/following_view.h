#pragma once

#include <geometry_msgs/Polygon.h>

#include <optional>

namespace forge {

/// What a view of RViz's class TopDownOrtho shows: the middle in metres in its target frame, and
/// the scale in pixels per metre.
struct TopView {
  double x = 0.0;
  double y = 0.0;
  double scale = 1.0;
};

/// Returns the view that holds an area in a picture of that many pixels. `area` must have points
/// and an extent.
TopView viewOf(const geometry_msgs::Polygon& area, int width, int height);

/// Moves a view smoothly to where it holds the area of the moment. Where the user zooms or drags
/// the picture, the view keeps that zoom and that offset.
class FollowingView {
 public:
  /// Returns the view `duration` seconds after the last call. `shown` is the view in the picture,
  /// `goal` the one that holds the area. The first call returns `goal`.
  TopView next(const TopView& shown, const TopView& goal, double duration);
  /// Forgets the user's zoom and offset.
  void reset() { set_.reset(); }

 private:
  void takeOver(const TopView& shown);

  std::optional<TopView> set_;  ///< what the last call returned
  TopView fitted_;              ///< the same without the user's zoom and offset
  TopView user_;                ///< offset and zoom
};

}  // namespace forge
