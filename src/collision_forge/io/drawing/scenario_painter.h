#pragma once

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/figure_layout.h"
#include "collision_forge/io/drawing/label_placer.h"
#include "collision_forge/io/drawing/scene_painter.h"

namespace forge {

/// Paints whole pictures of one scenario at any time, rotated by ScenePainter::rightwards(). The
/// constructor paints the static parts once. The view and the options must outlive it.
class ScenarioPainter {
 public:
  /// `size`: largest size of the picture; it is less high if its map needs less height.
  /// checkDrawable() must accept the view. Throws std::invalid_argument if the picture is too small
  /// for its font (layoutFigure()).
  ScenarioPainter(const ScenarioView& view, const DrawingOptions& options, const FigureSize& size,
                  PictureKind kind = PictureKind::kStill);

  /// Returns the picture of all vehicles at `time` (s, scene's clock), with ghosts of ego and
  /// attacker from `ghosts_from` (s, scene's clock) to contact. Labels of t0 are shown if
  /// `ghosts_from` is not after t0, the contact's label from the contact on.
  Image paint(double time, double ghosts_from) const;

  /// Returns the width of the picture, pixels.
  int width() const { return background_.width(); }
  /// Returns the height of the picture, pixels: at most the height of `size`.
  int height() const { return background_.height(); }

  /// Returns the mapping from ground to pixels of the map.
  const Viewport& mapViewport() const { return map_viewport_; }
  /// Returns the mapping of the close-up at contact; after the contact it follows the vehicles.
  const Viewport& closeUpViewport() const { return close_up_viewport_; }

 private:
  struct Label {
    PixelRect place;  ///< pixels
    Vector2 anchor;   ///< pixel of the named point
    std::string text;
    Color color;
  };

  /// Returns the viewport of the map in `area`, cropped above and below the paths.
  Viewport fitMap(const PixelRect& area) const;
  /// Paints ground, header, legend and report into `background_`.
  void paintBackground();
  /// Fills `now_labels_` and `contact_labels_`.
  void placeLabels();
  /// Returns a label for the point `world` (m, map frame), at a place of `placer`.
  Label makeLabel(Canvas& canvas, LabelPlacer& placer, const Vector2& world,
                  const std::string& text, const Color& color) const;
  /// Paints a label and the line to its anchor.
  void paintLabel(Canvas& canvas, const Label& label) const;

  const ScenarioView& view_;
  const DrawingOptions& options_;
  FigureSize size_;
  PictureKind kind_;
  ScenePainter scene_;
  Viewport map_viewport_;
  FigureLayout layout_;
  Viewport close_up_viewport_;
  Image background_;                   ///< the parts that all pictures share
  std::vector<Label> now_labels_;      ///< ego and attacker at t0, where known
  std::vector<Label> contact_labels_;  ///< one; none without a contact
};

}  // namespace forge
