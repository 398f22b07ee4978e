#include "collision_forge/io/drawing/draw_clouds.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/io/drawing/animation.h"

namespace forge {
namespace {

constexpr double kBehind = 15.0;  // m of the ground that are shown behind base_link
constexpr double kAhead = 45.0;   // m
constexpr double kAside = 10.0;   // m to either side
constexpr float kGround = 0.3F;   // m; lower points are pale
constexpr double kPoint = 2.0;    // pixels

struct EarlierPoint {
  bool operator()(const Eigen::Vector3f& a, const Eigen::Vector3f& b) const {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  }
};
using PointSet = std::set<Eigen::Vector3f, EarlierPoint>;

/// Paints one cloud below a line of text.
class CloudPanel {
 public:
  CloudPanel(Canvas& canvas, double top, const DrawingOptions& options)
      : canvas_(canvas),
        options_(options),
        top_(top),
        text_height_(2.0 * options.gif_font_size),
        view_({0.0, top + text_height_, static_cast<double>(options.gif_width),
               heightOf(options) - text_height_},
              {(kAhead - kBehind) / 2.0, 0.0}, pixelsPerMetre(options)) {}

  static double pixelsPerMetre(const DrawingOptions& options) {
    return options.gif_width / (kAhead + kBehind);
  }
  /// Returns the height of text and cloud, pixels.
  static double heightOf(const DrawingOptions& options) {
    return std::ceil(2.0 * options.gif_font_size + 2.0 * kAside * pixelsPerMetre(options));
  }

  void paint(const std::string& words, const std::vector<Eigen::Vector3f>& points,
             const PointSet* recorded, const OrientedBox& ego) {
    canvas_.text({6.0, top_ + 0.7 * text_height_}, words,
                 {options_.text_color, options_.gif_font_size, true, TextAlign::kLeft, false});
    canvas_.clip(view_.area());
    std::vector<Vector2> ring;
    for (const Vector2& corner : corners(ego)) ring.push_back(view_.toPixel(corner));
    canvas_.fill({ring}, options_.ego_color);
    for (const bool is_new : {false, true}) {
      for (const Eigen::Vector3f& point : points) {
        if ((recorded && recorded->count(point) == 0) == is_new) paintPoint(point, is_new);
      }
    }
    canvas_.unclip();
  }

 private:
  void paintPoint(const Eigen::Vector3f& point, bool is_new) {
    const Vector2 pixel = view_.toPixel(point.head<2>().cast<double>());
    const Color& color = is_new                ? options_.attacker_color
                         : point.z() < kGround ? options_.lane_color
                                               : options_.text_color;
    canvas_.fillRect({pixel.x() - kPoint / 2.0, pixel.y() - kPoint / 2.0, kPoint, kPoint}, color);
  }

  Canvas& canvas_;
  const DrawingOptions& options_;
  double top_;
  double text_height_;
  Viewport view_;
};

Image paintPair(const CloudPair& pair, const OrientedBox& ego, const DrawingOptions& options) {
  const double height = CloudPanel::heightOf(options);
  Image image(options.gif_width, static_cast<int>(2.0 * height), options.background_color);
  Canvas canvas(image);
  const PointSet recorded(pair.recorded.begin(), pair.recorded.end());
  CloudPanel(canvas, 0.0, options).paint("lidar as recorded", pair.recorded, nullptr, ego);
  CloudPanel(canvas, height, options)
      .paint("lidar with the attacker", pair.attacked, &recorded, ego);
  return image;
}

}  // namespace

void drawCloudsGif(const std::string& path, const std::vector<CloudPair>& pairs,
                   const OrientedBox& ego, const DrawingOptions& options) {
  std::vector<AnimationFrame> frames;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double seconds =
        i + 1 < pairs.size() ? pairs[i + 1].time - pairs[i].time : options.gif_contact_hold;
    frames.push_back({pairs[i].time, static_cast<int>(std::lround(100.0 * seconds))});
  }
  AsideFile file(path);
  writeAnimation(file.stream(), frames, [&](double time) {
    const auto pair = std::lower_bound(
        pairs.begin(), pairs.end(), time,
        [](const CloudPair& element, double wanted) { return element.time < wanted; });
    return paintPair(*pair, ego, options);
  });
  file.commit();
}

}  // namespace forge
