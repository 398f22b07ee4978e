#pragma once

#include <vector>

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/caption_painter.h"
#include "collision_forge/io/drawing/scenario_motion.h"

namespace forge {

/// Throws std::runtime_error for what cannot be painted: an attacker's trajectory or an ego's
/// future that is empty, a trajectory that does not span now to the contact, options that are not
/// above zero. A scenario without an attack needs no trajectory.
void checkDrawable(const ScenarioView& view, const DrawingOptions& options, bool has_attack);

/// How much more opaque than ghosts the boxes at rest are.
inline constexpr double kRestGhosts = 1.5;

/// Paints the scene of one scenario, without any text, into any part of a picture. The view and the
/// options must outlive it. Who paints clips to the viewport's area.
class ScenePainter {
 public:
  /// Lines and marks scale with `mark_size`, pixels.
  ScenePainter(const ScenarioView& view, const DrawingOptions& options, double mark_size,
               PictureKind kind, bool shows_pattern);

  const ScenarioMotion& motion() const { return motion_; }
  bool hasContact() const { return forge::hasContact(view_); }

  /// The direction of the ground, radians from east, that points to the right in a picture, so that
  /// a straight road fills the width: that of the ego at now, or at keyTime() if the picture is
  /// then far less high, or the opposite one. At most a quarter turn from east: north is never
  /// down.
  double rightwards() const;
  /// When the trails of the past begin.
  double trailsFrom() const;
  /// Corners of the boxes of ego and attacker, from then to standTime().
  std::vector<Vector2> shownCorners(double from) const;

  /// The map, which stands still.
  void paintGround(Canvas& canvas, const Viewport& viewport) const;

  /// Everybody at `time`; ghosts show where ego and attacker are from `ghosts_from` to contact, and
  /// in a still where they come to rest.
  void paint(Canvas& canvas, const Viewport& viewport, double time, double ghosts_from) const;

 private:
  void paintTrails(Canvas& canvas, const Viewport& viewport) const;
  void paintGhosts(Canvas& canvas, const Viewport& viewport, double from) const;
  void paintRecorded(Canvas& canvas, const Viewport& viewport, double time) const;
  void paintPassed(Canvas& canvas, const Viewport& viewport) const;
  void paintRest(Canvas& canvas, const Viewport& viewport) const;
  void paintVehicles(Canvas& canvas, const Viewport& viewport, double time) const;
  void paintPattern(Canvas& canvas, const Viewport& viewport) const;

  const ScenarioView& view_;
  const DrawingOptions& options_;
  double mark_size_;
  PictureKind kind_;
  bool shows_pattern_;
  ScenarioMotion motion_;
};

}  // namespace forge
