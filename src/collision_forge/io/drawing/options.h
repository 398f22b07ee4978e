#pragma once

namespace forge {

class Section;

/// Shares of red, green and blue, each in [0, 1].
struct Color {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
};

/// config/drawing.yaml, where each number's unit stands.
struct DrawingOptions {
  int png_width = 0;
  int png_height = 0;
  double png_font_size = 0.0;

  int gif_width = 0;
  int gif_height = 0;
  double gif_font_size = 0.0;
  double gif_frames_per_second = 0.0;
  double gif_contact_hold = 0.0;

  double seconds_before_now = 0.0;
  double view_margin = 0.0;
  double min_extent = 0.0;
  double close_up_extent = 0.0;
  double scale_bar = 0.0;
  double ghost_interval = 0.0;
  double ghost_opacity = 0.0;

  Color background_color;
  Color text_color;
  Color muted_text_color;
  Color drivable_color;
  Color walkway_color;
  Color lane_color;
  Color connector_color;
  Color agent_color;
  Color ego_color;
  Color attacker_color;
  Color recorded_attacker_color;
  Color pattern_ego_color;
  Color pattern_attacker_color;
  Color contact_color;
  Color passed_color;
  Color partial_color;
  Color failed_color;
};

void readOptions(Section& section, DrawingOptions& options);

}  // namespace forge
