#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/io/drawing/canvas.h"

namespace forge {

/// Counts the colours of pictures, in 6 bits a channel.
class ColorHistogram {
 public:
  ColorHistogram();
  void add(const Image& image);

 private:
  friend class ColorPalette;
  struct Bin {
    std::uint64_t count = 0;
    std::uint64_t red = 0;  ///< sums over the bin's pixels
    std::uint64_t green = 0;
    std::uint64_t blue = 0;
  };
  std::vector<Bin> bins_;
};

/// The colours that stand for a histogram's: median cut in the manner of Wu 1991, which always
/// splits the group of colours with the greatest squared error at its mean. Deterministic.
class ColorPalette {
 public:
  /// At most `max_colors` (1 to 256) colours.
  ColorPalette(const ColorHistogram& histogram, int max_colors);

  /// 0x00RRGGBB each.
  const std::vector<std::uint32_t>& colors() const { return colors_; }
  /// Index of the colour that stands for 0x00RRGGBB; only colours of the histogram have a good one.
  std::uint8_t indexOf(std::uint32_t color) const;

 private:
  std::vector<std::uint32_t> colors_;
  std::vector<std::uint8_t> index_of_bin_;
};

}  // namespace forge
