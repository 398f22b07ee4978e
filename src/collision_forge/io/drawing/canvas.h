#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/viewport.h"

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace forge {

/// How a line is drawn; `width` and `dash` in pixels.
struct LineStyle {
  Color color;
  double width = 1.0;    ///< pixels
  double opacity = 1.0;  ///< 0..1
  double dash = 0.0;     ///< length of dashes and of gaps, pixels; 0 draws a solid line
  bool closed = false;   ///< true: the last point is joined to the first
};

/// Which end of a text is at its position.
enum class TextAlign { kLeft, kCenter, kRight };

/// How a text is drawn.
struct TextStyle {
  Color color;
  double size = 0.0;  ///< font size, pixels
  bool bold = false;
  TextAlign align = TextAlign::kLeft;
  bool upwards = false;  ///< true: the text reads from the bottom to the top
};

/// An opaque RGB image. Copying copies the pixels. The constructor throws std::runtime_error if
/// cairo cannot make an image of that size.
class Image {
 public:
  /// `width` and `height` in pixels.
  Image(int width, int height, const Color& background);
  /// Copies the pixels.
  Image(const Image& other);
  Image(Image&&) = default;
  Image& operator=(const Image&) = delete;
  Image& operator=(Image&&) = default;

  int width() const;   ///< pixels
  int height() const;  ///< pixels
  /// Returns a pixel as 0x00RRGGBB; (0, 0) is the upper left one. Not checked: the pixel must be in
  /// the image.
  std::uint32_t pixel(int x, int y) const;

  /// Writes a PNG to a binary stream. Failed writes are reported by the stream's state alone;
  /// throws std::runtime_error for an error of cairo.
  void writePng(std::ostream& stream) const;

 private:
  friend class Canvas;
  /// Destroys the surface of cairo.
  struct Destroy {
    void operator()(cairo_surface_t* surface) const;
  };
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

/// Draws on an image, which must outlive the canvas. Coordinates in pixels, y down; opacity 0..1.
class Canvas {
 public:
  /// Draws on `image`, which must outlive the canvas.
  explicit Canvas(Image& image);

  /// Fills rings by the even-odd rule: a ring within a ring is a hole. A ring of fewer than three
  /// points is left out.
  void fill(const std::vector<std::vector<Vector2>>& rings, const Color& color, double opacity = 1);
  /// Fills a rectangle.
  void fillRect(const PixelRect& rect, const Color& color, double opacity = 1);
  /// Fills a circle; `radius` in pixels.
  void fillCircle(const Vector2& center, double radius, const Color& color);
  /// Draws a line; nothing for fewer than two points.
  void stroke(const std::vector<Vector2>& points, const LineStyle& style);

  /// Draws UTF-8 text. `position`: on the baseline, at the text's beginning, middle or end
  /// according to `style.align`.
  void text(const Vector2& position, const std::string& text, const TextStyle& style);
  /// Returns the width of a text, pixels.
  double textWidth(const std::string& text, const TextStyle& style);
  /// Returns `text`, cut and ended with an ellipsis if it is wider than `width` pixels; the
  /// ellipsis alone if nothing else fits.
  std::string fitted(const std::string& text, double width, const TextStyle& style);

  /// Restricts drawing to `rect` until unclip(). Calls do not nest.
  void clip(const PixelRect& rect);
  /// Ends the restriction of clip(), which must have been called.
  void unclip();

 private:
  /// Destroys the context of cairo.
  struct Destroy {
    void operator()(cairo_t* context) const;
  };
  /// Adds lines through `points` to cairo's path, and back to the first point if `closed`.
  void tracePath(const std::vector<Vector2>& points, bool closed);
  /// Sets font face and size for the next text.
  void selectFont(const TextStyle& style);

  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace forge
