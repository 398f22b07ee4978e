#include "collision_forge/ros/markers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/marker_fill.h"
#include "collision_forge/ros/marker_list.h"
#include "collision_forge/ros/marker_parts.h"

namespace forge {

namespace {

using visualization_msgs::MarkerArray;

// Heights above ground, m: what should be seen from above lies higher.
constexpr double kWalkwayHeight = -0.02;
constexpr double kAreaHeight = 0.0;
constexpr double kConnectorHeight = 0.02;
constexpr double kLaneHeight = 0.04;
constexpr double kTrailHeight = 0.1;
constexpr double kVehicleHeight = 1.5;  // of a box whose height is unknown
constexpr double kPatternHeight = 4.7;

constexpr double kLaneWidth = 0.12;     // m, of lines
constexpr double kTrailWidth = 0.25;    // m
constexpr double kPatternWidth = 0.22;  // m
constexpr double kDrivenWidth = 0.8;    // m
constexpr std::size_t kShownPatterns = 5;
constexpr float kPatternAlpha = 0.5F;  // of the first; each next one has half of it

constexpr double kArrowSpacing = 15.0;  // m along a centreline
constexpr double kArrowLength = 1.2;    // m
constexpr double kArrowWidth = 1.0;     // m

constexpr float kTrailAlpha = 0.6F;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kIdLetterHeight = 1.6;  // m

BoxSize sizeOf(const geometry_msgs::Vector3& size) { return {size.x, size.y}; }

template <typename Ring>
std::vector<Vector2> positions(const Ring& points) {
  std::vector<Vector2> ring;
  ring.reserve(points.size());
  for (const auto& point : points) ring.emplace_back(point.x, point.y);
  return ring;
}

/// The start of an id above its box, for RViz that looks along -z with y up. Long ids (nuScenes: 32
/// letters) would hide the scene.
void addId(const std::string& id, const OrientedBox& box, MarkerList& markers) {
  double top = box.center.y;
  for (const Vector2& corner : corners(box)) top = std::max(top, corner.y());
  markers.addText("ids", id.substr(0, kIdLetters), {box.center.x, top + 0.6 * kIdLetterHeight},
                  kIdLetterHeight, kTextHeight, colors::kText);
}

bool canAttackClass(std::uint8_t agent_class) {
  return agent_class <= collision_forge::Agent::STATIC_OBJECT &&
         canAttack(static_cast<AgentClass>(agent_class));
}

Polygon polygonOf(const collision_forge::PolygonWithHoles& message) {
  Polygon polygon{positions(message.exterior.points), {}};
  for (const auto& hole : message.holes) polygon.holes.push_back(positions(hole.points));
  return polygon;
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
    appendPolyline(centerline, lines);
    appendArrowHeads(centerline, lines);
  }
  markers.addLines("connectors", connectors, kLaneWidth, kConnectorHeight, colors::kConnector);
  markers.addLines("lanes", lanes, kLaneWidth, kLaneHeight, colors::kLane);
}

std::vector<Vector2> trailOf(const std::vector<collision_forge::TrackState>& states) {
  std::vector<Vector2> lines;
  std::vector<Vector2> trail;
  for (const auto& state : states) trail.emplace_back(state.pose.x, state.pose.y);
  appendPolyline(trail, lines);
  return lines;
}

void addTrack(const std::string& name_space, const collision_forge::AgentTrack& track,
              const ros::Time& now, const colors::MarkerColor& color, MarkerList& markers) {
  markers.addLines(name_space + "_trail", trailOf(track.states), kTrailWidth, kTrailHeight,
                   colors::withAlpha(color, kTrailAlpha));
  if (track.states.empty() || track.states.back().stamp < now) return;
  const OrientedBox box{fromMessage(track.states.back().pose), sizeOf(track.size)};
  markers.addBox(name_space, box, kVehicleHeight, color);
  if (!canAttackClass(track.agent_class) || track.id == kEgoId) return;
  addId(track.id, box, markers);
}

/// The way that an attacker came that nobody recorded, and where it is now.
void addPast(const collision_forge::AttackerTrajectory& trajectory, MarkerList& markers) {
  markers.addLines("added_past", trailOf(trajectory.past), kTrailWidth, kTrailHeight,
                   colors::withAlpha(colors::kAdded, kTrailAlpha));
  const OrientedBox box{fromMessage(trajectory.past.back().pose), sizeOf(trajectory.size)};
  markers.addBox("added", box, kVehicleHeight, colors::kAdded);
  addId("added", box, markers);
}

std::string reportText(const collision_forge::Attack& attack) {
  const collision_forge::CollisionReport& report = attack.report;
  std::string text = attack.pattern.collision_type;
  if (attack.trajectory.added) text += ", added vehicle";
  if (attack.adaptive) text += "\n" + attack.phase + ": " + attack.decision;
  if (!report.contact) return text + ": no contact";
  text += formatted("\ncontact in %.2f s", (report.contact_time - report.header.stamp).toSec());
  text += formatted("\nheading %+.0f deg", report.relative_heading * 180 / M_PI);
  text += "\n" + report.attacker_side + " to ego's " + report.ego_side;
  text += formatted("\nimpact %.1f m/s", report.impact_speed);
  text += formatted(", overlap %.0f %%", 100 * report.overlap);
  if (!report.manoeuvre.empty()) {
    text += "\n" + report.manoeuvre +
            formatted(" from %.1f s on", (report.manoeuvre_begin - report.header.stamp).toSec());
  }
  if (!report.unbelievable.empty()) text += "\nNOT BELIEVABLE: " + report.unbelievable;
  return report.verified ? text : text + "\nNOT VERIFIED";
}

/// Where a text hides neither vehicle's way to the contact: ahead of both.
Vector2 aheadOf(const Pose2& ego, const Pose2& attacker) {
  const Vector2 ahead = ego.heading() + attacker.heading();
  return ahead.norm() < 0.5 ? Vector2(-ego.heading().y(), ego.heading().x()) : ahead;
}

/// Where and when it is.
std::vector<TrajectoryPoint> pointsOf(const collision_forge::AttackerTrajectory& trajectory) {
  std::vector<TrajectoryPoint> points;
  for (const auto& point : trajectory.points) {
    points.push_back({point.stamp.toSec(), fromMessage(point.pose)});
  }
  return points;
}

/// What was driven until `now`, as a line; returns what is to be driven then, to `end`.
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

void addPatternBox(const OrientedBox& box, const std::string& name_space,
                   const colors::MarkerColor& color, MarkerList& markers) {
  std::vector<Vector2> outline;
  appendOutline(box, outline);
  markers.addLines(name_space, outline, kPatternWidth, kPatternHeight, color);
}

void addArea(const char* name_space, const std::vector<collision_forge::PolygonWithHoles>& polygons,
             double height, const colors::MarkerColor& color, MarkerList& markers) {
  std::vector<Vector2> area;
  for (const auto& polygon : polygons) {
    const std::vector<Vector2> triangles = fillTriangles(polygonOf(polygon));
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
  addWay("attacker", points, end, sizeOf(trajectory.size), colors::kAttacker, markers);
  if (!trajectory.past.empty()) addPast(trajectory, markers);
  addPatternBox(pattern_ego, "pattern_ego", colors::kPatternEgo, markers);
  addPatternBox(pattern_attacker, "pattern_attacker", colors::kPatternAttacker, markers);
  Vector2 place = (pattern_ego.center.position() + pattern_attacker.center.position()) / 2;
  OrientedBox ego = pattern_ego;
  OrientedBox attacker = pattern_attacker;
  if (report.contact) {
    ego.center = fromMessage(report.ego_at_contact);
    attacker.center = fromMessage(report.attacker_at_contact);
    place = addContact(ego, attacker, colors::kAttacker, markers);
  }
  addReport(reportText(attack), place, aheadOf(ego.center, attacker.center), markers);
}

OrientedBox boxOf(const collision_forge::Agent& agent) {
  return {fromMessage(agent.pose), sizeOf(agent.size)};
}

double heightOf(const collision_forge::Agent& agent) {
  return agent.size.z > 0 ? agent.size.z : kVehicleHeight;
}

}  // namespace

MarkerArray mapMarkers(const collision_forge::LaneMap& map) {
  MarkerList markers(map.header);
  addArea("drivable_area", map.drivable_area, kAreaHeight, colors::kDrivableArea, markers);
  addArea("walkways", map.walkways, kWalkwayHeight, colors::kWalkway, markers);
  addLanes(map, markers);
  return markers.take();
}

MarkerArray sceneMarkers(const collision_forge::SceneSnapshot& scene) {
  MarkerList markers(scene.header);
  for (const auto& agent : scene.agents) {
    addTrack("agents", agent, scene.header.stamp, colors::agentColor(agent.agent_class), markers);
  }
  addTrack("ego", scene.ego, scene.header.stamp, colors::kEgo, markers);
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
    markers.addSlab("predicted_ego", ego, kGhostHeight,
                    colors::withAlpha(colors::kPatternEgo, alpha));
    markers.addSlab("predicted_attacker", other, kGhostHeight,
                    colors::withAlpha(colors::kPatternAttacker, alpha));
    alpha *= 0.5F;
  }
  return markers.take();
}

MarkerArray attackMarkers(const collision_forge::Attack& attack, const ros::Time& now) {
  MarkerList markers(attack.header);
  addAttack(attack, now, markers);
  return markers.take();
}

MarkerArray crashMarkers(const CrashView& view) {
  MarkerList markers(view.header);
  if (view.attack) addAttack(*view.attack, view.header.stamp, markers);
  if (view.ego) markers.addBox("ego", *view.ego, kVehicleHeight, colors::kEgo);
  if (view.attacker) {
    markers.addBox("attacker", boxOf(*view.attacker), heightOf(*view.attacker), colors::kAttacker);
  }
  return markers.take();
}

MarkerArray annotationMarkers(const collision_forge::AgentArray& agents,
                              const std::string& attacker_id) {
  MarkerList markers(agents.header);
  for (const auto& agent : agents.agents) {
    const OrientedBox box = boxOf(agent);
    const bool attacks = !attacker_id.empty() && agent.id == attacker_id;
    markers.addBox("agents", box, heightOf(agent),
                   attacks ? colors::kAttacker : colors::agentColor(agent.agent_class));
    addId(agent.id, box, markers);
  }
  return markers.take();
}

MarkerArray noMarkers(const std_msgs::Header& header) { return MarkerList(header).take(); }

}  // namespace forge
