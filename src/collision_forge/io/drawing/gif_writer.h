#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <vector>

#include "collision_forge/io/drawing/color_palette.h"

struct GifFileType;

namespace forge {

/// Writes an animated GIF that loops forever. A frame stores only the rectangle that differs from
/// the frame before. Failed writes are reported by the stream's state alone; errors of giflib throw
/// std::runtime_error.
class GifWriter {
 public:
  /// `palette`: at most 255 colours; the last of GIF's 256 means "unchanged". The palette and the
  /// binary stream must outlive the writer.
  GifWriter(std::ostream& stream, int width, int height, const ColorPalette& palette);

  /// Adds a frame that is shown for `delay` hundredths of a second. `image` must have the GIF's
  /// size.
  void addFrame(const Image& image, int delay);

  /// Ends the file.
  void close();

 private:
  struct Close {
    void operator()(GifFileType* file) const;
  };
  /// Part of the picture, in whole pixels.
  struct Region {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
  };

  void check(int result) const;
  void writeControl(int delay);
  void writeRegion(const std::vector<std::uint8_t>& indices, const Region& region);
  Region changedRegion(const std::vector<std::uint8_t>& indices) const;

  int width_;
  int height_;
  const ColorPalette& palette_;
  std::unique_ptr<GifFileType, Close> file_;
  std::vector<std::uint8_t> previous_;  ///< palette indices of the last frame, empty at first
};

}  // namespace forge
