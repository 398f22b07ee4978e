#include "collision_forge/ros/markers/markers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_forge/base/geometry/simplified_line.h"
#include "collision_forge/ros/markers/crash_words.h"
#include "collision_forge/ros/markers/marker_fill.h"
#include "collision_forge/ros/markers/marker_list.h"
#include "collision_forge/ros/markers/marker_parts.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {

namespace {

using visualization_msgs::MarkerArray;

// Heights above ground, m: what should be seen from above lies higher.
constexpr double kWalkwayHeight = -0.02;
constexpr double kAreaHeight = 0.0;
constexpr double kPaintedHeight = 0.01;
constexpr double kConnectorHeight = 0.02;
constexpr double kLaneHeight = 0.04;
constexpr double kTrailHeight = 0.1;
constexpr double kLightHeight = 0.15;
constexpr double kPatternHeight = 4.7;

constexpr double kLaneWidth = 0.12;     // m, of lines
constexpr double kTrailWidth = 0.25;    // m
constexpr double kPatternWidth = 0.22;  // m
constexpr double kLightDiameter = 1.6;  // m
constexpr double kDrivenWidth = 0.8;    // m
constexpr std::size_t kShownPatterns = 5;
constexpr float kPatternAlpha = 0.5F;  // of the first; each next one has half of it

constexpr double kLineTolerance = 0.03;  // m; too small to be visible
constexpr double kArrowSpacing = 15.0;   // m along a centreline
constexpr double kArrowLength = 1.2;     // m
constexpr double kArrowWidth = 1.0;      // m

constexpr float kTrailAlpha = 0.6F;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Ring>
std::vector<Vector2> positions(const Ring& points) {
  std::vector<Vector2> ring;
  ring.reserve(points.size());
  for (const auto& point : points) ring.emplace_back(point.x, point.y);
  return ring;
}

void appendArrowHead(const Pose2& pose, std::vector<Vector2>& lines) {
  const auto point = [&pose](double forward, double left) {
    return compose(pose, {forward, left, 0.0}).position();
  };
  appendPolyline({point(-kArrowLength / 2, kArrowWidth / 2), point(kArrowLength / 2, 0.0),
                  point(-kArrowLength / 2, -kArrowWidth / 2)},
                 lines);
}

/// An arrow head every kArrowSpacing metres, the first half a spacing in.
void appendArrowHeads(const std::vector<Vector2>& centerline, std::vector<Vector2>& lines) {
  double ahead = kArrowSpacing / 2;  // to the next arrow head
  for (std::size_t i = 1; i < centerline.size(); ++i) {
    const Vector2 step = centerline[i] - centerline[i - 1];
    const double length = step.norm();
    if (!std::isfinite(length)) continue;
    for (; ahead < length; ahead += kArrowSpacing) {
      const Vector2 position = centerline[i - 1] + ahead / length * step;
      appendArrowHead({position.x(), position.y(), std::atan2(step.y(), step.x())}, lines);
    }
    ahead -= length;
  }
}

void addLanes(const collision_forge::LaneMap& map, MarkerList& markers) {
  std::vector<Vector2> lanes;
  std::vector<Vector2> connectors;
  for (const auto& lane : map.lanes) {
    std::vector<Vector2>& lines = lane.is_connector ? connectors : lanes;
    const std::vector<Vector2> centerline = positions(lane.centerline);
    appendPolyline(simplified(centerline, kLineTolerance), lines);
    appendArrowHeads(centerline, lines);
  }
  markers.addLines("connectors", connectors, kLaneWidth, kConnectorHeight, colors::kConnector);
  markers.addLines("lanes", lanes, kLaneWidth, kLaneHeight, colors::kLane);
}

/// Adds road edges as lines and the other features as surfaces.
void addFeatures(const LaneMap& map, MarkerList& markers) {
  std::vector<Vector2> edges;
  std::vector<Vector2> painted;
  for (const MapFeature& feature : map.features) {
    if (isRoadEdge(feature.kind)) {
      appendPolyline(simplified(feature.points, kLineTolerance), edges);
    } else if (!isOpenLine(feature.kind) && feature.kind != FeatureKind::kDriveway) {
      const std::vector<Vector2> triangles = fillTriangles({feature.points, {}});
      painted.insert(painted.end(), triangles.begin(), triangles.end());
    }
  }
  markers.addTriangles("painted", painted, kPaintedHeight, colors::kPainted);
  markers.addLines("road_edges", edges, kLaneWidth, kLaneHeight, colors::kRoadEdge);
}

std::vector<Vector2> trailOf(const std::vector<collision_forge::TrackState>& states) {
  std::vector<Vector2> lines;
  std::vector<Vector2> trail;
  for (const auto& state : states) trail.emplace_back(state.pose.x, state.pose.y);
  appendPolyline(trail, lines);
  return lines;
}

/// Adds the past of an added attacker as a line.
void addPast(const collision_forge::AttackerTrajectory& trajectory, MarkerList& markers) {
  markers.addLines("added_past", trailOf(trajectory.past), kTrailWidth, kTrailHeight,
                   colors::withAlpha(colors::kAdded, kTrailAlpha));
}

/// Where and when it is.
std::vector<TrajectoryPoint> pointsOf(const collision_forge::AttackerTrajectory& trajectory) {
  std::vector<TrajectoryPoint> points;
  for (const auto& point : trajectory.points) {
    points.push_back({point.stamp.toSec(), fromMessage(point.pose)});
  }
  return points;
}

/// Adds a line along the points until `now`; returns the points from then to `end`.
std::vector<TrajectoryPoint> addDriven(const std::vector<TrajectoryPoint>& points, double now,
                                       double end, MarkerList& markers) {
  std::vector<Vector2> path;
  auto point = points.begin();
  for (; point != points.end() && point->time <= std::min(now, end); ++point) {
    path.push_back(point->pose.position());
  }
  std::vector<Vector2> lines;
  appendPolyline(path, lines);
  markers.addLines("driven", lines, kDrivenWidth, kPathHeight, colors::kAttacker);
  return {path.empty() ? point : std::prev(point), points.end()};
}

void addPatternBox(const OrientedBox& box, const std::string& name_space, double height,
                   const colors::MarkerColor& color, MarkerList& markers) {
  std::vector<Vector2> outline;
  appendOutline(box, outline);
  markers.addLines(name_space, outline, kPatternWidth, height, color);
}

void addArea(const char* name_space, const std::vector<Polygon>& polygons, double height,
             const colors::MarkerColor& color, MarkerList& markers) {
  std::vector<Vector2> area;
  for (const Polygon& polygon : polygons) {
    const std::vector<Vector2> triangles = fillTriangles(polygon);
    area.insert(area.end(), triangles.begin(), triangles.end());
  }
  markers.addTriangles(name_space, area, height, color);
}

void addAttack(const collision_forge::Attack& attack, const ros::Time& now, MarkerList& markers) {
  const auto& pattern = attack.pattern;
  const auto& trajectory = attack.trajectory;
  const auto& report = attack.report;
  const OrientedBox pattern_ego{fromMessage(pattern.ego), sizeOf(pattern.ego_size)};
  const OrientedBox pattern_attacker{
      compose(pattern_ego.center, fromMessage(pattern.attacker_offset)), sizeOf(trajectory.size)};
  const double end = report.contact ? report.contact_time.toSec() : kInfinity;
  std::vector<TrajectoryPoint> points = pointsOf(trajectory);
  if (attack.adaptive) points = addDriven(points, now.toSec(), end, markers);
  addPath("attacker", points, end, sizeOf(trajectory.size), colors::kAttacker, markers);
  if (!trajectory.past.empty()) addPast(trajectory, markers);
  addPatternBox(pattern_ego, "pattern_ego", kPatternHeight, colors::kPatternEgo, markers);
  addPatternBox(pattern_attacker, "pattern_attacker", kPatternHeight, colors::kPatternAttacker,
                markers);
  if (!report.contact) return;
  addContact({fromMessage(report.ego_at_contact), pattern_ego.size},
             {fromMessage(report.attacker_at_contact), pattern_attacker.size}, colors::kAttacker,
             markers);
}

OrientedBox boxOf(const collision_forge::Agent& agent) {
  return {fromMessage(agent.pose), sizeOf(agent.size)};
}

double heightOf(const collision_forge::Agent& agent) {
  return agent.size.z > 0 ? agent.size.z : kVehicleHeight;
}

/// Beside the contact; without a contact beside the trajectory's end.
void addWords(const CrashView& view, MarkerList& markers) {
  const collision_forge::Attack& attack = *view.attack;
  const auto& points = attack.trajectory.points;
  if (points.empty()) return;
  const auto& report = attack.report;
  const BoxSize size = sizeOf(attack.trajectory.size);
  const Pose2 end = fromMessage(points.back().pose);
  const OrientedBox place{report.contact ? fromMessage(report.attacker_at_contact) : end, size};
  const ros::Time& now = view.header.stamp;
  addAttackWords(attack, {place, view.words_obstacles},
                 view.attacker ? boxOf(*view.attacker) : place,
                 crashWords(attack, verdictBy(now, attack, &report), now), 1.0, markers);
}

}  // namespace

MarkerArray mapMarkers(const collision_forge::LaneMap& map) {
  MarkerList markers(map.header);
  const LaneMap areas = fromMessage(map);
  addArea("drivable_area", areas.drivable_area, kAreaHeight, colors::kDrivableArea, markers);
  addArea("walkways", areas.walkways, kWalkwayHeight, colors::kWalkway, markers);
  addFeatures(areas, markers);
  addLanes(map, markers);
  return markers.take();
}

MarkerArray lightMarkers(const collision_forge::TrafficLightArray& lights) {
  MarkerList markers(lights.header);
  for (const auto& light : lights.lights) {
    markers.addDisc("traffic_lights", {light.stop_point.x, light.stop_point.y}, kLightDiameter,
                    kLightHeight, colors::lightColor(light.color));
  }
  return markers.take();
}

MarkerArray patternMarkers(const collision_forge::PredictedPatterns& predicted,
                           const collision_forge::SceneSnapshot& scene) {
  MarkerList markers(predicted.header);
  float alpha = kPatternAlpha;
  for (std::size_t i = 0; i < std::min(kShownPatterns, predicted.patterns.size()); ++i) {
    const collision_forge::CollisionPattern& pattern = predicted.patterns[i];
    const auto attacker =
        std::find_if(scene.agents.begin(), scene.agents.end(),
                     [&](const auto& agent) { return agent.id == pattern.attacker_id; });
    if (attacker == scene.agents.end()) continue;
    const OrientedBox ego{fromMessage(pattern.ego), sizeOf(pattern.ego_size)};
    const OrientedBox other{compose(ego.center, fromMessage(pattern.attacker_offset)),
                            sizeOf(attacker->size)};
    addPatternBox(ego, "predicted_ego", kGhostHeight, colors::withAlpha(colors::kPatternEgo, alpha),
                  markers);
    addPatternBox(other, "predicted_attacker", kGhostHeight,
                  colors::withAlpha(colors::kPatternAttacker, alpha), markers);
    alpha *= 0.5F;
  }
  return markers.take();
}

MarkerArray attackMarkers(const collision_forge::Attack& attack, const ros::Time& now) {
  MarkerList markers(attack.header);
  addAttack(attack, now, markers);
  return markers.take();
}

MarkerArray pastAttackMarkers(const collision_forge::Attack& attack,
                              const collision_forge::CollisionReport& verdict) {
  MarkerList markers(attack.header);
  const double end = verdict.contact ? verdict.contact_time.toSec() : kInfinity;
  std::vector<Vector2> lines;
  std::vector<Vector2> path;
  for (const TrajectoryPoint& point : pointsOf(attack.trajectory)) {
    if (point.time <= end) path.push_back(point.pose.position());
  }
  appendPolyline(path, lines);
  markers.addLines("attacker_path", lines, kPathWidth, kPathHeight, colors::kAttacker);
  return markers.take();
}

MarkerArray crashMarkers(const CrashView& view) {
  MarkerList markers(view.header);
  if (view.attack) addAttack(*view.attack, view.header.stamp, markers);
  if (view.ego) markers.addBox("ego", *view.ego, kVehicleHeight, colors::kEgo);
  if (view.attacker) {
    markers.addBox("attacker", boxOf(*view.attacker), heightOf(*view.attacker), colors::kAttacker);
  }
  if (view.attack) addWords(view, markers);
  return markers.take();
}

MarkerArray annotationMarkers(const collision_forge::AgentArray& agents,
                              const std::string& attacker_id,
                              const std::vector<std::string>& supports) {
  MarkerList markers(agents.header);
  std::vector<OrientedBox> boxes;
  for (const auto& agent : agents.agents) boxes.push_back(boxOf(agent));
  std::vector<OrientedBox> obstacles = boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const collision_forge::Agent& agent = agents.agents[i];
    const bool attacks = !attacker_id.empty() && agent.id == attacker_id;
    const bool helps = std::count(supports.begin(), supports.end(), agent.id) > 0;
    markers.addBox("agents", boxes[i], heightOf(agent),
                   attacks ? colors::kAttacker
                   : helps ? colors::kSupport
                           : colors::agentColor(agent.agent_class));
    if (canAttackClass(agent.agent_class)) {
      addId(agent.id, boxes[i], boxes[i], 1.0, obstacles, markers);
    }
  }
  return markers.take();
}

MarkerArray noMarkers(const std_msgs::Header& header) { return MarkerList(header).take(); }

}  // namespace forge
