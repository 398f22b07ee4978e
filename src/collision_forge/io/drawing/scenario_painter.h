#pragma once

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/figure_layout.h"
#include "collision_forge/io/drawing/label_placer.h"
#include "collision_forge/io/drawing/scene_painter.h"

namespace forge {

/// Paints one scenario at any time, rotated by ScenePainter::rightwards(). The constructor paints
/// the static parts once. The view and the options must outlive it.
class ScenarioPainter {
 public:
  /// `size`: largest size of the picture; it is less high if its map needs less height.
  ScenarioPainter(const ScenarioView& view, const DrawingOptions& options, const FigureSize& size,
                  PictureKind kind = PictureKind::kStill);

  /// Paints all vehicles at `time` (s, scene's clock), and ghosts of ego and attacker from
  /// `ghosts_from` to contact.
  Image paint(double time, double ghosts_from) const;

  /// Pixels.
  int width() const { return background_.width(); }
  int height() const { return background_.height(); }

  /// Returns the mapping from ground to pixels of the map.
  const Viewport& mapViewport() const { return map_viewport_; }
  /// Returns the mapping of the close-up at contact; after the contact it follows the vehicles.
  const Viewport& closeUpViewport() const { return close_up_viewport_; }

 private:
  struct Label {
    PixelRect place;
    Vector2 anchor;
    std::string text;
    Color color;
  };

  /// Returns the viewport of the map in `area`, cropped above and below the paths.
  Viewport fitMap(const PixelRect& area) const;
  void paintBackground();
  void placeLabels();
  Label makeLabel(Canvas& canvas, LabelPlacer& placer, const Vector2& world,
                  const std::string& text, const Color& color) const;
  void paintLabel(Canvas& canvas, const Label& label) const;

  const ScenarioView& view_;
  const DrawingOptions& options_;
  FigureSize size_;
  PictureKind kind_;
  ScenePainter scene_;
  Viewport map_viewport_;
  FigureLayout layout_;
  Viewport close_up_viewport_;
  Image background_;
  std::vector<Label> now_labels_;
  std::vector<Label> contact_labels_;  ///< one; none without a contact
};

}  // namespace forge
