#pragma once

#include <vector>

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/caption_painter.h"
#include "collision_forge/io/drawing/scenario_motion.h"

namespace forge {

/// Throws std::runtime_error if the view cannot be painted: the attacker's trajectory or the ego's
/// future is empty, the trajectory does not cover t0 to keyTime(), or gif_frames_per_second,
/// ghost_interval, min_extent or close_up_extent of `options` is not positive.
void checkDrawable(const ScenarioView& view, const DrawingOptions& options);

/// Factor on DrawingOptions::ghost_opacity for the boxes at which ego and attacker come to rest.
inline constexpr double kRestGhosts = 1.5;

/// Paints the scene of one scenario, without text, into any part of a picture. The caller clips to
/// the viewport's area. The view and the options must outlive it.
class ScenePainter {
 public:
  /// `mark_size`: pixels; lines and marks scale with it.
  ScenePainter(const ScenarioView& view, const DrawingOptions& options, double mark_size,
               PictureKind kind);

  /// Returns the motion of the vehicles of the view.
  const ScenarioMotion& motion() const { return motion_; }
  /// Returns true if the view has a contact.
  bool hasContact() const { return forge::hasContact(view_); }

  /// Returns the direction on the ground, rad from east, that points right in the picture, so that
  /// a straight road fills the width: the ego's axis at t0, or at keyTime() if the picture is then
  /// far less high (at most 80 %); east if both are unknown. Within a quarter turn of east: north
  /// never points down.
  double rightwards() const;
  /// Returns the time at which the trails of the past begin, s on the scene's clock.
  double trailsFrom() const;
  /// Returns the corners (m, map frame) of the boxes of ego and attacker from `from` (s, scene's
  /// clock) to standTime(), every 0.1 s.
  std::vector<Vector2> shownCorners(double from) const;

  /// Paints the map; nothing without a map.
  void paintGround(Canvas& canvas, const Viewport& viewport) const;

  /// Paints trails, lights, all vehicles and the pattern at `time`, ghosts of ego and attacker from
  /// `ghosts_from` to contact (times: s, scene's clock), the star from the contact on, and in a
  /// still the rest positions.
  void paint(Canvas& canvas, const Viewport& viewport, double time, double ghosts_from) const;

 private:
  // The steps of paint(); times in s on the scene's clock.
  void paintLights(Canvas& canvas, const Viewport& viewport, double time) const;
  void paintTrails(Canvas& canvas, const Viewport& viewport) const;
  void paintGhosts(Canvas& canvas, const Viewport& viewport, double from) const;
  void paintRecorded(Canvas& canvas, const Viewport& viewport, double time) const;
  /// Returns the colour of an agent or of a support vehicle.
  const Color& colorOf(const AgentBox& agent) const;
  void paintPassed(Canvas& canvas, const Viewport& viewport) const;
  void paintRest(Canvas& canvas, const Viewport& viewport) const;
  void paintVehicles(Canvas& canvas, const Viewport& viewport, double time) const;
  void paintPattern(Canvas& canvas, const Viewport& viewport) const;

  const ScenarioView& view_;
  const DrawingOptions& options_;
  double mark_size_;
  PictureKind kind_;
  ScenarioMotion motion_;
};

}  // namespace forge
