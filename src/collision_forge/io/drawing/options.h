#pragma once

namespace forge {

class Section;

/// Shares of red, green and blue, each in [0, 1].
struct Color {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
};

/// Size and look of pictures (config/drawing.yaml). Fields with an initial value other than 0 are
/// fixed: the file does not set them.
struct DrawingOptions {
  int png_width = 0;            ///< pixels
  int png_height = 0;           ///< pixels, at most
  double png_font_size = 14.0;  ///< pixels; lines and marks scale with it

  int gif_width = 0;                   ///< pixels
  int gif_height = 0;                  ///< pixels, at most
  double gif_font_size = 10.5;         ///< pixels
  double gif_frames_per_second = 0.0;  ///< 1/s
  double gif_contact_hold = 1.0;       ///< s, extra display time of the frame at contact

  /// s before t0 at which animations and the trails of both vehicles start.
  double seconds_before_now = 0.0;
  double view_margin = 8.0;  ///< m, least ground shown around both paths
  double min_extent = 45.0;  ///< m, least ground shown along the shorter side of the uncropped map
  double close_up_extent = 16.0;  ///< m, side of the ground in the close-up of the contact
  double scale_bar = 10.0;        ///< m, least length of the scale bar
  /// s between the translucent boxes ("ghosts") of ego and attacker from t0 to contact.
  double ghost_interval = 1.0;
  double ghost_opacity = 0.22;  ///< 0 invisible, 1 solid; doubled for the boxes at t0

  Color background_color{1.0, 1.0, 1.0};
  Color text_color{0.13, 0.15, 0.18};
  Color muted_text_color{0.42, 0.45, 0.50};  ///< details, names of values in the report
  Color drivable_color{0.90, 0.91, 0.92};
  Color walkway_color{0.95, 0.92, 0.87};
  Color road_edge_color{0.55, 0.57, 0.60};  ///< road edges and medians
  Color painted_color{0.96, 0.96, 0.97};    ///< crosswalks and speed bumps
  Color lane_color{0.68, 0.71, 0.74};       ///< centrelines and their arrow heads
  Color connector_color{0.81, 0.83, 0.85};  ///< paths through junctions
  Color red_light_color{0.84, 0.10, 0.10};
  Color yellow_light_color{0.95, 0.75, 0.05};
  Color green_light_color{0.10, 0.62, 0.25};
  Color agent_color{0.56, 0.63, 0.70};    ///< other agents
  Color support_color{0.15, 0.17, 0.20};  ///< vehicles that hide the attacker or queue ahead of it
  Color ego_color;
  Color attacker_color;
  Color recorded_attacker_color{0.90, 0.45, 0.45};  ///< the attacker's recorded motion
  Color pattern_ego_color{0.52, 0.20, 0.68};        ///< outline of the ego in the pattern
  Color pattern_attacker_color{0.98, 0.58, 0.10};   ///< outline of the attacker in the pattern
  Color contact_color{1.0, 0.87, 0.12};             ///< star at the point of contact
  Color passed_color{0.10, 0.52, 0.25};             ///< Verdict::kWanted, conditions that hold
  Color partial_color{0.80, 0.47, 0.05};            ///< Verdict::kPartial
  Color failed_color{0.78, 0.12, 0.12};             ///< Verdict::kUnwanted, conditions that fail
};

/// Reads the sizes, `gif_frames_per_second`, `seconds_before_now` and the colours of ego and
/// attacker from their section. Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, DrawingOptions& options);

}  // namespace forge
