#include "collision_forge/io/drawing/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {
namespace {

void readDrawingSizes(Section& section, DrawingOptions& options) {
  constexpr int kMinPixels = 64;
  constexpr int kMaxPixels = 8192;
  options.png_width = section.count("png_width", kMinPixels, kMaxPixels);
  options.png_height = section.count("png_height", kMinPixels, kMaxPixels);
  options.png_font_size = section.positive("png_font_size");
  options.gif_width = section.count("gif_width", kMinPixels, kMaxPixels);
  options.gif_height = section.count("gif_height", kMinPixels, kMaxPixels);
  options.gif_font_size = section.positive("gif_font_size");
  options.gif_frames_per_second = section.positive("gif_frames_per_second");
  options.gif_contact_hold = section.nonNegative("gif_contact_hold");
  options.seconds_before_now = section.nonNegative("seconds_before_now");
  options.view_margin = section.nonNegative("view_margin");
  options.min_extent = section.positive("min_extent");
  options.close_up_extent = section.positive("close_up_extent");
  options.scale_bar = section.positive("scale_bar");
  options.ghost_interval = section.positive("ghost_interval");
  options.ghost_opacity = section.share("ghost_opacity");
}

void readColors(Section& section, DrawingOptions& options) {
  options.background_color = section.color<Color>("background_color");
  options.text_color = section.color<Color>("text_color");
  options.muted_text_color = section.color<Color>("muted_text_color");
  options.drivable_color = section.color<Color>("drivable_color");
  options.walkway_color = section.color<Color>("walkway_color");
  options.lane_color = section.color<Color>("lane_color");
  options.connector_color = section.color<Color>("connector_color");
  options.agent_color = section.color<Color>("agent_color");
  options.ego_color = section.color<Color>("ego_color");
  options.attacker_color = section.color<Color>("attacker_color");
  options.recorded_attacker_color = section.color<Color>("recorded_attacker_color");
  options.pattern_ego_color = section.color<Color>("pattern_ego_color");
  options.pattern_attacker_color = section.color<Color>("pattern_attacker_color");
  options.contact_color = section.color<Color>("contact_color");
  options.passed_color = section.color<Color>("passed_color");
  options.partial_color = section.color<Color>("partial_color");
  options.failed_color = section.color<Color>("failed_color");
}

}  // namespace

void readOptions(Section& section, DrawingOptions& options) {
  readDrawingSizes(section, options);
  readColors(section, options);
}

}  // namespace forge
