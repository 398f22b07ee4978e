#include "collision_forge/io/drawing/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {
void readOptions(Section& section, DrawingOptions& options) {
  constexpr int kMinPixels = 64;
  constexpr int kMaxPixels = 8192;
  options.png_width = section.count("png_width", kMinPixels, kMaxPixels);
  options.png_height = section.count("png_height", kMinPixels, kMaxPixels);
  options.gif_width = section.count("gif_width", kMinPixels, kMaxPixels);
  options.gif_height = section.count("gif_height", kMinPixels, kMaxPixels);
  options.gif_frames_per_second = section.positive("gif_frames_per_second");
  options.seconds_before_now = section.nonNegative("seconds_before_now");
  options.ego_color = section.color<Color>("ego_color");
  options.attacker_color = section.color<Color>("attacker_color");
}

}  // namespace forge
