#include "collision_forge/ros/markers/crash_scene.h"

#include <cmath>
#include <utility>

#include "collision_forge/base/geometry/touch_point.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/ros/markers/crash_words.h"
#include "collision_forge/ros/markers/marker_list.h"
#include "collision_forge/ros/markers/marker_parts.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

constexpr double kLineWidth = 0.15;         // m
constexpr double kLineHeight = 0.03;        // m above ground, of lane lines and road edges
constexpr double kWayHeight = 0.1;          // m
constexpr double kTouchHeight = 0.8;        // m
constexpr double kLabelLetterHeight = 0.7;  // m
constexpr double kTitleLetterHeight = 1.0;  // m, of ego and attacker
constexpr double kWordsLetterHeight = 1.2;  // m
constexpr double kWordsHeight = 9.0;        // m
constexpr colors::MarkerColor kAreaEdge{0.42F, 0.45F, 0.49F};

geometry_msgs::Point pointAt(const Vector2& place, double height) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  point.z = height;
  return point;
}

/// Two points a line.
void addLines(const std::vector<Vector2>& ends, double thickness, double height,
              const colors::MarkerColor& color, SceneEntity& entity) {
  LinePrimitive lines{thickness, {}, color};
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    if (!ends[i].allFinite() || !ends[i + 1].allFinite()) continue;
    lines.points.push_back(pointAt(ends[i], height));
    lines.points.push_back(pointAt(ends[i + 1], height));
  }
  if (!lines.points.empty()) entity.lines.push_back(std::move(lines));
}

void addText(const std::string& text, const Vector2& place, double height, double letter_height,
             SceneEntity& entity) {
  entity.texts.push_back({pointAt(place, height), letter_height, colors::kText, text});
}

template <typename Points>
std::vector<Vector2> placesIn(const Points& points) {
  std::vector<Vector2> places;
  for (const auto& point : points) places.emplace_back(point.x, point.y);
  return places;
}

void appendRing(std::vector<Vector2> ring, std::vector<Vector2>& ends) {
  if (!ring.empty()) ring.push_back(ring.front());
  appendPolyline(ring, ends);
}

SceneEntity areaEntity(const collision_forge::LaneMap& map) {
  std::vector<Vector2> ends;
  for (const Polygon& polygon : fromMessage(map).drivable_area) {
    appendRing(polygon.exterior, ends);
    for (const std::vector<Vector2>& hole : polygon.holes) appendRing(hole, ends);
  }
  SceneEntity entity;
  entity.id = "drivable_area";
  addLines(ends, kLineWidth, kLineHeight, kAreaEdge, entity);
  return entity;
}

SceneEntity lanesEntity(const collision_forge::LaneMap& map, bool connectors) {
  std::vector<Vector2> ends;
  for (const auto& lane : map.lanes) {
    if (lane.is_connector == connectors) appendPolyline(placesIn(lane.centerline), ends);
  }
  SceneEntity entity;
  entity.id = connectors ? "connectors" : "lanes";
  addLines(ends, kLineWidth, kLineHeight, connectors ? colors::kConnector : colors::kLane, entity);
  return entity;
}

bool isDrawable(const OrientedBox& box) {
  return box.center.isFinite() && std::isfinite(box.size.length * box.size.width) &&
         box.size.length > 0.0 && box.size.width > 0.0;
}

/// Appearance of a box.
struct BoxLook {
  double height = kVehicleHeight;  ///< m
  colors::MarkerColor color;
  std::string label;
  double letter_height = kLabelLetterHeight;
};

SceneEntity boxEntity(const std::string& id, const OrientedBox& box, const BoxLook& look) {
  SceneEntity entity;
  entity.id = id;
  SolidPrimitive cube{toPoseMessage(box.center), toMessage(box.size), look.color};
  cube.pose.position.z = look.height / 2;
  cube.size.z = look.height;
  entity.cubes.push_back(cube);
  if (!look.label.empty()) {
    const double above = look.height + look.letter_height;
    addText(look.label, box.center.position(), above, look.letter_height, entity);
  }
  return entity;
}

std::string className(std::uint8_t agent_class) {
  constexpr std::uint8_t kOther = collision_forge::Agent::STATIC_OBJECT;
  const bool is_known = agent_class <= collision_forge::Agent::SCOOTER;
  return toString(static_cast<AgentClass>(is_known ? agent_class : kOther));
}

/// Cones and barriers, which are many, have no labels.
BoxLook lookOf(const collision_forge::Agent& agent, bool attacks, bool helps) {
  BoxLook look{kVehicleHeight, colors::agentColor(agent.agent_class), "", kLabelLetterHeight};
  if (agent.size.z > 0.0 && std::isfinite(agent.size.z)) look.height = agent.size.z;
  if (attacks) {
    look.color = colors::kAttacker;
    look.label = "attacker";
    look.letter_height = kTitleLetterHeight;
  } else if (agent.agent_class != collision_forge::Agent::STATIC_OBJECT) {
    if (helps) look.color = colors::kSupport;
    look.label = className(agent.agent_class) + " " + shortId(agent.id);
  }
  return look;
}

SceneEntity agentEntity(const collision_forge::Agent& agent, const OrientedBox& box,
                        const CrashView& view) {
  const bool helps = view.attack && isSupport(agent.id, *view.attack);
  SceneEntity entity =
      boxEntity("agent " + agent.id, box, lookOf(agent, &agent == view.attacker, helps));
  const double speed = std::hypot(agent.velocity.x, agent.velocity.y);
  entity.metadata = {{"id", agent.id},
                     {"class", className(agent.agent_class)},
                     {"speed", formatted("%.1f m/s", speed)}};
  return entity;
}

void addContact(const collision_forge::Attack& attack, SceneEntity& entity) {
  const auto& report = attack.report;
  const OrientedBox ego{fromMessage(report.ego_at_contact), sizeOf(attack.pattern.ego_size)};
  const OrientedBox attacker{fromMessage(report.attacker_at_contact),
                             sizeOf(attack.trajectory.size)};
  for (const auto& [box, color] : {std::pair{ego, colors::kEgo}, {attacker, colors::kAttacker}}) {
    std::vector<Vector2> outline;
    appendOutline(box, outline);
    addLines(outline, kLineWidth, kWayHeight, color, entity);
  }
  if (!isDrawable(ego) || !isDrawable(attacker)) return;
  SolidPrimitive touch;
  touch.pose.position = pointAt(touchPoint(ego, attacker), kTouchHeight);
  touch.pose.orientation.w = 1.0;
  touch.size.x = touch.size.y = touch.size.z = kContactDiameter;
  touch.color = colors::kContact;
  entity.spheres.push_back(touch);
}

SceneEntity attackEntity(const collision_forge::Attack& attack, const ros::Time& now) {
  SceneEntity entity;
  entity.id = "attack";
  const auto& report = attack.report;
  std::vector<Vector2> way;
  for (const auto& point : attack.trajectory.points) {
    if (report.contact && point.stamp > report.contact_time) break;
    way.emplace_back(point.pose.position.x, point.pose.position.y);
  }
  std::vector<Vector2> ends;
  appendPolyline(way, ends);
  addLines(ends, kPathWidth, kWayHeight, colors::kAttacker, entity);
  if (report.contact) addContact(attack, entity);
  if (way.empty() || !way.back().allFinite()) return entity;
  addText(crashWords(attack, verdictBy(now, attack, &report), now), way.back(), kWordsHeight,
          kWordsLetterHeight, entity);
  return entity;
}

}  // namespace

SceneUpdate mapScene(const collision_forge::LaneMap& map) {
  return {map.header.stamp,
          map.header.frame_id,
          {areaEntity(map), lanesEntity(map, false), lanesEntity(map, true)}};
}

SceneUpdate crashScene(const CrashView& view, const collision_forge::AgentArray& agents) {
  SceneUpdate update{view.header.stamp, view.header.frame_id, {}};
  if (view.ego && isDrawable(*view.ego)) {
    update.entities.push_back(
        boxEntity(kEgoId, *view.ego, {kVehicleHeight, colors::kEgo, kEgoId, kTitleLetterHeight}));
  }
  for (const auto& agent : agents.agents) {
    const OrientedBox box{fromMessage(agent.pose), sizeOf(agent.size)};
    if (isDrawable(box)) update.entities.push_back(agentEntity(agent, box, view));
  }
  if (view.attack) update.entities.push_back(attackEntity(*view.attack, view.header.stamp));
  return update;
}

}  // namespace forge
