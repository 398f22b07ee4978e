#include "collision_forge/io/drawing/animation.h"

#include <optional>
#include <stdexcept>

#include "collision_forge/io/drawing/gif_writer.h"

namespace forge {
namespace {

constexpr int kPaletteColors = 255;

}  // namespace

void writeAnimation(std::ostream& stream, const std::vector<AnimationFrame>& frames,
                    const std::function<Image(double time)>& paint) {
  if (frames.empty()) throw std::invalid_argument("animation has no frames");
  ColorHistogram histogram;
  for (const AnimationFrame& frame : frames) histogram.add(paint(frame.time));
  const ColorPalette palette(histogram, kPaletteColors);
  std::optional<GifWriter> writer;
  for (const AnimationFrame& frame : frames) {
    const Image image = paint(frame.time);
    if (!writer) writer.emplace(stream, image.width(), image.height(), palette);
    writer->addFrame(image, frame.delay);
  }
  writer->close();
}

}  // namespace forge
