#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/io/drawing/canvas.h"

namespace forge {

/// Counts the colours of images, at 6 bits per channel.
class ColorHistogram {
 public:
  ColorHistogram();
  /// Counts every pixel of an image.
  void add(const Image& image);

 private:
  friend class ColorPalette;
  /// The pixels of one colour of 6 bits per channel.
  struct Bin {
    std::uint64_t count = 0;  ///< pixels
    std::uint64_t red = 0;    ///< sums over the bin's pixels, channels 0 to 255
    std::uint64_t green = 0;
    std::uint64_t blue = 0;
  };
  /// One per colour of 6 bits per channel: red, green, blue.
  std::vector<Bin> bins_;
};

/// Reduces a histogram to few colours: median cut in the manner of Wu 1991, which always splits the
/// group with the greatest squared error at its mean. Deterministic.
class ColorPalette {
 public:
  /// Makes at most `max_colors` (1 to 256) colours; none if the histogram is empty.
  ColorPalette(const ColorHistogram& histogram, int max_colors);

  /// Returns the colours, each 0x00RRGGBB.
  const std::vector<std::uint32_t>& colors() const { return colors_; }
  /// Returns the index in colors() of the palette colour for 0x00RRGGBB; meaningful only for
  /// colours that were counted in the histogram.
  std::uint8_t indexOf(std::uint32_t color) const;

 private:
  std::vector<std::uint32_t> colors_;
  std::vector<std::uint8_t> index_of_bin_;  ///< index in `colors_`, by bin of the histogram
};

}  // namespace forge
