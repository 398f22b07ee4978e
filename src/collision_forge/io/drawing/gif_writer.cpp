#include "collision_forge/io/drawing/gif_writer.h"

#include <gif_lib.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace forge {

namespace {

constexpr int kColors = 256;
constexpr std::uint8_t kUnchanged = 255;

[[noreturn]] void fail(int error) {
  const char* reason = GifErrorString(error);
  throw std::runtime_error(reason == nullptr ? "unknown error of giflib" : reason);
}

int writeBytes(GifFileType* file, const GifByteType* bytes, int size) {
  static_cast<std::ostream*>(file->UserData)->write(reinterpret_cast<const char*>(bytes), size);
  return size;
}

GifFileType* openFile(std::ostream& stream) {
  int error = 0;
  GifFileType* file = EGifOpen(&stream, writeBytes, &error);
  if (file == nullptr) fail(error);
  return file;
}

}  // namespace

void GifWriter::Close::operator()(GifFileType* file) const { EGifCloseFile(file, nullptr); }

GifWriter::GifWriter(std::ostream& stream, int width, int height, const ColorPalette& palette)
    : width_(width), height_(height), palette_(palette), file_(openFile(stream)) {
  EGifSetGifVersion(file_.get(), true);
  std::vector<GifColorType> colors(kColors, GifColorType{0, 0, 0});
  for (std::size_t i = 0; i < palette.colors().size(); ++i) {
    const std::uint32_t color = palette.colors()[i];
    colors[i] = {static_cast<GifByteType>(color >> 16U), static_cast<GifByteType>(color >> 8U),
                 static_cast<GifByteType>(color)};
  }
  const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(
      GifMakeMapObject(kColors, colors.data()), &GifFreeMapObject);
  check(EGifPutScreenDesc(file_.get(), width, height, 8, 0, map.get()));

  constexpr char kLoopExtension[] = "NETSCAPE2.0";
  constexpr GifByteType kLoopForever[] = {1, 0, 0};
  check(EGifPutExtensionLeader(file_.get(), APPLICATION_EXT_FUNC_CODE));
  check(EGifPutExtensionBlock(file_.get(), sizeof(kLoopExtension) - 1, kLoopExtension));
  check(EGifPutExtensionBlock(file_.get(), sizeof(kLoopForever), kLoopForever));
  check(EGifPutExtensionTrailer(file_.get()));
}

void GifWriter::addFrame(const Image& image, int delay) {
  std::vector<std::uint8_t> indices;
  indices.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) indices.push_back(palette_.indexOf(image.pixel(x, y)));
  }
  writeControl(delay);
  writeRegion(indices, changedRegion(indices));
  previous_ = std::move(indices);
}

void GifWriter::close() {
  int error = 0;
  if (EGifCloseFile(file_.release(), &error) != GIF_OK) fail(error);
}

void GifWriter::check(int result) const {
  if (result != GIF_OK) fail(file_->Error);
}

void GifWriter::writeControl(int delay) {
  GraphicsControlBlock control;
  control.DisposalMode = DISPOSE_DO_NOT;
  control.UserInputFlag = false;
  control.DelayTime = delay;
  control.TransparentColor = previous_.empty() ? NO_TRANSPARENT_COLOR : int{kUnchanged};
  GifByteType bytes[4];
  const std::size_t size = EGifGCBToExtension(&control, bytes);
  check(EGifPutExtension(file_.get(), GRAPHICS_EXT_FUNC_CODE, static_cast<int>(size), bytes));
}

GifWriter::Region GifWriter::changedRegion(const std::vector<std::uint8_t>& indices) const {
  if (previous_.empty()) return {0, 0, width_, height_};
  int left = width_;
  int right = -1;
  int top = height_;
  int bottom = -1;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(x);
      if (indices[at] == previous_[at]) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  // A frame cannot be empty: an unchanged picture rewrites one pixel.
  if (right < 0) return {0, 0, 1, 1};
  return {left, top, right - left + 1, bottom - top + 1};
}

void GifWriter::writeRegion(const std::vector<std::uint8_t>& indices, const Region& region) {
  check(EGifPutImageDesc(file_.get(), region.left, region.top, region.width, region.height, false,
                         nullptr));
  std::vector<GifByteType> line(static_cast<std::size_t>(region.width));
  for (int y = region.top; y < region.top + region.height; ++y) {
    const auto start = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(region.left);
    for (std::size_t x = 0; x < line.size(); ++x) {
      const bool same = !previous_.empty() && indices[start + x] == previous_[start + x];
      line[x] = same ? kUnchanged : indices[start + x];
    }
    check(EGifPutLine(file_.get(), line.data(), region.width));
  }
}

}  // namespace forge
