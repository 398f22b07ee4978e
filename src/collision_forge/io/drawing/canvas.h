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
  double width = 1.0;
  double opacity = 1.0;
  double dash = 0.0;  ///< length of dashes and gaps; 0 draws a solid line
  bool closed = false;
};

enum class TextAlign { kLeft, kCenter, kRight };

struct TextStyle {
  Color color;
  double size = 0.0;  ///< pixels
  bool bold = false;
  TextAlign align = TextAlign::kLeft;
};

/// An opaque picture, row by row from the top. A copy is a copy of the pixels.
class Image {
 public:
  Image(int width, int height, const Color& background);
  Image(const Image& other);
  Image(Image&&) = default;
  Image& operator=(const Image&) = delete;
  Image& operator=(Image&&) = default;

  int width() const;
  int height() const;
  /// 0x00RRGGBB.
  std::uint32_t pixel(int x, int y) const;

  /// To a binary stream, which alone tells of a write that fails.
  void writePng(std::ostream& stream) const;

 private:
  friend class Canvas;
  struct Destroy {
    void operator()(cairo_surface_t* surface) const;
  };
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

/// Draws on an image, which must outlive it. Coordinates in pixels, y down.
class Canvas {
 public:
  explicit Canvas(Image& image);

  /// Even-odd: a ring within a ring is a hole.
  void fill(const std::vector<std::vector<Vector2>>& rings, const Color& color, double opacity = 1);
  void fillRect(const PixelRect& rect, const Color& color, double opacity = 1);
  void fillCircle(const Vector2& center, double radius, const Color& color);
  /// Fewer than two points draw nothing.
  void stroke(const std::vector<Vector2>& points, const LineStyle& style);

  /// `position` is on the baseline, at the left end, middle or right end of the text (UTF-8).
  void text(const Vector2& position, const std::string& text, const TextStyle& style);
  double textWidth(const std::string& text, const TextStyle& style);
  /// `text`, cut and ended with an ellipsis when wider than `width`.
  std::string fitted(const std::string& text, double width, const TextStyle& style);

  /// Puts another image with its left upper corner at `position`.
  void image(const Vector2& position, const Image& image);

  /// Nothing is drawn outside `rect` until the next call of unclip().
  void clip(const PixelRect& rect);
  void unclip();

 private:
  struct Destroy {
    void operator()(cairo_t* context) const;
  };
  void tracePath(const std::vector<Vector2>& points, bool closed);
  void selectFont(const TextStyle& style);

  std::unique_ptr<cairo_t, Destroy> context_;
};

/// The line around the pixels at the edge of a rectangle of whole pixels.
std::vector<Vector2> edgeOf(const PixelRect& rect);

}  // namespace forge
