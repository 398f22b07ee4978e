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
  /// Writes the header. `width` and `height` in pixels. `palette`: at most 255 colours (not
  /// checked); the last of GIF's 256 means "unchanged". The palette and the binary stream must
  /// outlive the writer.
  GifWriter(std::ostream& stream, int width, int height, const ColorPalette& palette);

  /// Adds a frame that is shown for `delay` hundredths of a second. `image` must have the GIF's
  /// size (not checked).
  void addFrame(const Image& image, int delay);

  /// Ends the file. Must be called once, after the last frame; no call may follow. Without it, the
  /// destructor ends the file and ignores errors of giflib.
  void close();

 private:
  /// Closes the file of giflib.
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

  /// Throws std::runtime_error unless `result`, of a function of giflib, is GIF_OK.
  void check(int result) const;
  /// Writes the delay (hundredths of a second) of the next frame.
  void writeControl(int delay);
  /// Writes the part of a frame in `region`; `indices`: palette index of each pixel, row by row.
  void writeRegion(const std::vector<std::uint8_t>& indices, const Region& region);
  /// Returns the smallest region that holds all differences to `previous_`: one pixel if there are
  /// none.
  Region changedRegion(const std::vector<std::uint8_t>& indices) const;

  int width_;
  int height_;
  const ColorPalette& palette_;
  std::unique_ptr<GifFileType, Close> file_;
  std::vector<std::uint8_t> previous_;  ///< palette indices of the last frame, empty at first
};

}  // namespace forge
