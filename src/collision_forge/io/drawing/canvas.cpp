#include "collision_forge/io/drawing/canvas.h"

#include <cairo.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>

namespace forge {

namespace {

constexpr const char* kFontFamily = "DejaVu Sans";

void setColor(cairo_t* context, const Color& color, double opacity) {
  cairo_set_source_rgba(context, color.red, color.green, color.blue, opacity);
}

cairo_surface_t* makeSurface(int width, int height) {
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  const cairo_status_t status = cairo_surface_status(surface);
  if (status != CAIRO_STATUS_SUCCESS) {
    cairo_surface_destroy(surface);
    throw std::runtime_error("cannot create an image of " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels: " + cairo_status_to_string(status));
  }
  return surface;
}

/// Grey antialiasing without hinting: no colour fringes, the same shapes at every position.
void setFontOptions(cairo_t* context) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

/// Drops the last UTF-8 character.
void dropLastCharacter(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) {
    text.pop_back();
  }
  if (!text.empty()) text.pop_back();
}

}  // namespace

void Image::Destroy::operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

Image::Image(int width, int height, const Color& background)
    : surface_(makeSurface(width, height)) {
  Canvas(*this).fillRect({0, 0, static_cast<double>(width), static_cast<double>(height)},
                         background);
}

Image::Image(const Image& other) : surface_(makeSurface(other.width(), other.height())) {
  std::memcpy(cairo_image_surface_get_data(surface_.get()),
              cairo_image_surface_get_data(other.surface_.get()),
              static_cast<std::size_t>(height()) *
                  static_cast<std::size_t>(cairo_image_surface_get_stride(surface_.get())));
  cairo_surface_mark_dirty(surface_.get());
}

int Image::width() const { return cairo_image_surface_get_width(surface_.get()); }

int Image::height() const { return cairo_image_surface_get_height(surface_.get()); }

std::uint32_t Image::pixel(int x, int y) const {
  const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface_.get());
  const std::ptrdiff_t offset = y * stride + x * std::ptrdiff_t{4};
  std::uint32_t value = 0;
  std::memcpy(&value, cairo_image_surface_get_data(surface_.get()) + offset, sizeof(value));
  return value & 0xFFFFFFU;
}

void Image::writePng(std::ostream& stream) const {
  const auto write = [](void* to, const unsigned char* bytes, unsigned int size) {
    static_cast<std::ostream*>(to)->write(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), write, &stream);
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

void Canvas::Destroy::operator()(cairo_t* context) const { cairo_destroy(context); }

Canvas::Canvas(Image& image) : context_(cairo_create(image.surface_.get())) {
  setFontOptions(context_.get());
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_fill_rule(context_.get(), CAIRO_FILL_RULE_EVEN_ODD);
}

void Canvas::tracePath(const std::vector<Vector2>& points, bool closed) {
  for (const Vector2& point : points) cairo_line_to(context_.get(), point.x(), point.y());
  if (closed) cairo_close_path(context_.get());
}

void Canvas::fill(const std::vector<std::vector<Vector2>>& rings, const Color& color,
                  double opacity) {
  cairo_new_path(context_.get());
  for (const std::vector<Vector2>& ring : rings) {
    if (ring.size() < 3) continue;
    cairo_new_sub_path(context_.get());
    tracePath(ring, true);
  }
  setColor(context_.get(), color, opacity);
  cairo_fill(context_.get());
}

void Canvas::fillRect(const PixelRect& rect, const Color& color, double opacity) {
  setColor(context_.get(), color, opacity);
  cairo_rectangle(context_.get(), rect.x, rect.y, rect.width, rect.height);
  cairo_fill(context_.get());
}

void Canvas::fillCircle(const Vector2& center, double radius, const Color& color) {
  constexpr double kFullTurn = 6.283185307179586;
  setColor(context_.get(), color, 1.0);
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), center.x(), center.y(), radius, 0.0, kFullTurn);
  cairo_fill(context_.get());
}

void Canvas::stroke(const std::vector<Vector2>& points, const LineStyle& style) {
  if (points.size() < 2) return;
  setColor(context_.get(), style.color, style.opacity);
  cairo_set_line_width(context_.get(), style.width);
  cairo_set_dash(context_.get(), &style.dash, style.dash > 0 ? 1 : 0, 0.0);
  cairo_new_path(context_.get());
  tracePath(points, style.closed);
  cairo_stroke(context_.get());
}

void Canvas::selectFont(const TextStyle& style) {
  cairo_select_font_face(context_.get(), kFontFamily, CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), style.size);
}

void Canvas::text(const Vector2& position, const std::string& text, const TextStyle& style) {
  double begin = 0.0;
  if (style.align == TextAlign::kCenter) begin = -textWidth(text, style) / 2;
  if (style.align == TextAlign::kRight) begin = -textWidth(text, style);
  selectFont(style);
  setColor(context_.get(), style.color, 1.0);
  if (!style.upwards) {
    cairo_move_to(context_.get(), position.x() + begin, position.y());
    cairo_show_text(context_.get(), text.c_str());
    return;
  }
  cairo_save(context_.get());
  cairo_translate(context_.get(), position.x(), position.y());
  cairo_rotate(context_.get(), -M_PI_2);
  cairo_move_to(context_.get(), begin, 0.0);
  cairo_show_text(context_.get(), text.c_str());
  cairo_restore(context_.get());
}

double Canvas::textWidth(const std::string& text, const TextStyle& style) {
  selectFont(style);
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), text.c_str(), &extents);
  return extents.x_advance;
}

std::string Canvas::fitted(const std::string& text, double width, const TextStyle& style) {
  if (textWidth(text, style) <= width) return text;
  std::string cut = text;
  while (!cut.empty() && textWidth(cut + "…", style) > width) dropLastCharacter(cut);
  return cut + "…";
}

void Canvas::clip(const PixelRect& rect) {
  cairo_save(context_.get());
  cairo_rectangle(context_.get(), rect.x, rect.y, rect.width, rect.height);
  cairo_clip(context_.get());
}

void Canvas::unclip() { cairo_restore(context_.get()); }

}  // namespace forge
