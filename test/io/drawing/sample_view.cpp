#include "io/drawing/sample_view.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace forge {

namespace {

constexpr double kNow = 100.0;
constexpr double kContactTime = 102.04;

/// A vehicle that drives east and is at `at` at contact time; states every 0.5 s in [from, to].
Track makeTrack(const std::string& id, const BoxSize& size, const Vector2& at, double speed,
                double from, double to) {
  Track track;
  track.id = id;
  track.size = size;
  for (double time = from; time <= to; time += 0.5) {
    AgentState state;
    state.time = time;
    state.pose = {at.x() + speed * (time - kContactTime), at.y(), 0.0};
    state.velocity = {speed, 0.0};
    track.states.push_back(state);
  }
  return track;
}

std::shared_ptr<const LaneMap> makeMap() {
  auto map = std::make_shared<LaneMap>();
  map->drivable_area.push_back({{{-200, -4}, {200, -4}, {200, 4}, {-200, 4}}, {}});
  map->walkways.push_back({{{-200, 3}, {200, 3}, {200, 6}, {-200, 6}}, {}});
  Lane lane;
  lane.id = "lane";
  for (double x = -200; x <= 200; x += 2) lane.centerline.push_back({x, 0.0, 0.0});
  lane.polygon = {{-200, -2}, {200, -2}, {200, 2}, {-200, 2}};
  map->lanes.push_back(lane);
  return map;
}

}  // namespace

ScenarioView sampleView() {
  const BoxSize ego_size{4.0, 2.0};
  const BoxSize attacker_size{5.0, 2.0};
  ScenarioView view;
  view.scene_name = "scene-0001";
  view.tta = 2.0;
  view.snapshot.now = kNow;
  view.snapshot.map = makeMap();
  view.snapshot.ego = makeTrack(kEgoId, ego_size, {10, 0}, 5.0, 98.0, kNow);
  view.snapshot.agents = {makeTrack("veh", attacker_size, {5.5, 0}, 10.0, 98.0, kNow),
                          makeTrack("truck", {8.0, 2.5}, {10, 8}, 0.0, 98.0, kNow)};
  view.future.ego = makeTrack(kEgoId, ego_size, {10, 0}, 5.0, kNow, 104.0);
  view.future.agents = {makeTrack("veh", attacker_size, {40, 0}, 10.0, kNow, 104.0),
                        makeTrack("truck", {8.0, 2.5}, {10, 8}, 0.0, kNow, 104.0)};
  view.trajectory.attacker_id = "veh";
  view.trajectory.size = attacker_size;
  for (int i = 0; i <= 40; ++i) {
    TrajectoryPoint point;
    point.time = kNow + 0.1 * i;
    point.pose = {5.5 + 10.0 * (point.time - kContactTime), 0.0, 0.0};
    point.speed = 10.0;
    view.trajectory.points.push_back(point);
  }
  view.pattern.attacker_id = "veh";
  view.pattern.time = 102.0;
  view.pattern.ego = {{9.8, 0.0, 0.0}, ego_size};
  view.pattern.attacker_offset = {-4.5, 0.0, 0.0};
  view.report.contact = true;
  view.report.contact_time = kContactTime;
  view.report.ego_at_contact = {10.0, 0.0, 0.0};
  view.report.attacker_at_contact = {5.5, 0.0, 0.0};
  view.report.type_kept = view.report.on_time = view.report.limits_kept = true;
  view.seconds_after_stand = 0.5;
  return view;
}

ScenarioView sampleCrash() {
  ScenarioView view = sampleView();
  // A plastic impact of equal masses: both continue at 7.475 m/s, and stand after about 1 s.
  SeverityOptions options;
  for (BodyOptions& body : options.bodies) body.mass = body.least_mass = 1000.0;
  options.after_impact = {1.0, 1.0, 0.01, 100.0, 0.0, 7.475};
  const CrashedVehicle ego{AgentClass::kCar,
                           view.future.ego.size,
                           {kContactTime, view.report.ego_at_contact, {5.0, 0.0}}};
  const CrashedVehicle attacker{AgentClass::kCar,
                                view.trajectory.size,
                                {kContactTime, view.report.attacker_at_contact, {9.95, 0.0}}};
  view.crash.emplace(ego, attacker, options);
  return view;
}

DrawingOptions sampleOptions() {
  DrawingOptions options;
  options.png_width = 420;
  options.png_height = 480;
  options.png_font_size = 8.0;
  options.gif_width = 320;
  options.gif_height = 360;
  options.gif_font_size = 6.0;
  options.gif_frames_per_second = 10.0;
  options.gif_contact_hold = 0.7;
  options.seconds_before_now = 2.0;
  options.view_margin = 4.0;
  options.min_extent = 20.0;
  options.close_up_extent = 16.0;
  options.scale_bar = 10.0;
  options.ghost_interval = 1.0;
  options.ghost_opacity = 0.2;
  options.background_color = {1.0, 1.0, 1.0};
  options.drivable_color = {0.8, 0.8, 0.8};
  options.walkway_color = {0.9, 0.8, 0.7};
  options.lane_color = {0.6, 0.6, 0.6};
  options.connector_color = {0.7, 0.7, 0.7};
  options.agent_color = {0.4, 0.6, 0.8};
  options.ego_color = {0.0, 0.0, 1.0};
  options.attacker_color = {1.0, 0.0, 0.0};
  options.recorded_attacker_color = {1.0, 0.5, 0.5};
  options.pattern_ego_color = {0.6, 0.0, 0.8};
  options.pattern_attacker_color = {1.0, 0.6, 0.0};
  options.contact_color = {1.0, 1.0, 0.0};
  options.passed_color = {0.0, 0.6, 0.0};
  options.partial_color = {0.7, 0.5, 0.0};
  options.failed_color = {0.6, 0.0, 0.0};
  return options;
}

std::uint32_t packedColor(const Color& color) {
  const auto byte = [](double share) {
    return static_cast<std::uint32_t>(std::lround(255 * share));
  };
  return (byte(color.red) << 16U) | (byte(color.green) << 8U) | byte(color.blue);
}

std::string temporaryPath(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return testing::TempDir() + "forge_" + std::to_string(getpid()) + "_" + test->name() + "_" + name;
}

bool exists(const std::string& path) { return access(path.c_str(), F_OK) == 0; }

std::string readBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace forge
