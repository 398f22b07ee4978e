#include "collision_forge/io/drawing/animation.h"

#include <optional>
#include <stdexcept>

#include "collision_forge/io/drawing/gif_writer.h"

namespace forge {
namespace {

constexpr int kPaletteColors = 255;

}  // namespace

void writeAnimation(std::ostream& stream, const std::vector<AnimationFrame>& frames,
                    const std::function<Image(double time)>& paint,
                    const PictureProgress& on_progress) {
  if (frames.empty()) throw std::invalid_argument("animation has no frames");
  std::size_t painted = 0;
  const auto count = [&] {
    ++painted;
    if (on_progress) on_progress(painted, 2 * frames.size());
  };
  ColorHistogram histogram;
  for (const AnimationFrame& frame : frames) {
    histogram.add(paint(frame.time));
    count();
  }
  const ColorPalette palette(histogram, kPaletteColors);
  std::optional<GifWriter> writer;
  for (const AnimationFrame& frame : frames) {
    const Image image = paint(frame.time);
    if (!writer) writer.emplace(stream, image.width(), image.height(), palette);
    writer->addFrame(image, frame.delay);
    count();
  }
  writer->close();
}

}  // namespace forge
