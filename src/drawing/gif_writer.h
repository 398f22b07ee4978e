#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "drawing/color_palette.h"

struct GifFileType;

namespace forge {

/// Writes an animated GIF that loops forever. A frame stores only the rectangle that differs from
/// the one before. Every function throws std::runtime_error naming `path` when writing fails.
class GifWriter {
 public:
  /// `palette` has at most 255 colours and must outlive the writer: the last of GIF's 256 stands
  /// for "as before".
  GifWriter(const std::string& path, int width, int height, const ColorPalette& palette);

  /// Shows `image` for `delay` hundredths of a second.
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

  std::string path_;
  int width_;
  int height_;
  const ColorPalette& palette_;
  std::ofstream stream_;
  std::unique_ptr<GifFileType, Close> file_;
  std::vector<std::uint8_t> previous_;  ///< indices of the frame before, empty at first
};

}  // namespace forge
