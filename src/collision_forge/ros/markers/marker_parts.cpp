#include "collision_forge/ros/markers/marker_parts.h"

#include <collision_forge/Agent.h>

#include <algorithm>

#include "collision_forge/base/geometry/touch_point.h"
#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/ros/markers/label_places.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

constexpr double kGhostWidth = 0.1;      // m
constexpr double kGhostInterval = 0.5;   // s
constexpr double kTimeTolerance = 1e-6;  // s
constexpr float kGhostAlpha = 0.16F;
constexpr double kIdLetterHeight = 1.0;  // m, at letterScale() 1
constexpr double kEgoWay = 40.0;  // m of the ego's path before the contact that texts do not cover
// Text with the length and height of most texts of an attack.
constexpr char kMostWords[] = "contact not as requested:\n\n";

/// Returns the boxes of an attack that its text must not cover.
std::vector<OrientedBox> obstaclesOf(const collision_forge::Attack& attack,
                                     std::vector<OrientedBox> obstacles) {
  const auto& report = attack.report;
  const BoxSize size = sizeOf(attack.trajectory.size);
  for (std::size_t i = 0; i < attack.trajectory.points.size(); ++i) {
    const auto& point = attack.trajectory.points[i];
    if (report.contact && point.stamp > report.contact_time) break;
    obstacles.push_back({fromMessage(point.pose), size});
  }
  if (!report.contact) return obstacles;
  const Pose2 ego = fromMessage(report.ego_at_contact);
  obstacles.push_back({compose(ego, {-kEgoWay / 2, 0.0, 0.0}),
                       {kEgoWay + attack.pattern.ego_size.x, attack.pattern.ego_size.y}});
  return obstacles;
}

}  // namespace

BoxSize sizeOf(const geometry_msgs::Vector3& size) { return {size.x, size.y}; }

bool canAttackClass(std::uint8_t agent_class) {
  return agent_class <= collision_forge::Agent::STATIC_OBJECT &&
         isMotorVehicle(static_cast<AgentClass>(agent_class));
}

bool isSupport(const std::string& id, const collision_forge::Attack& attack) {
  return std::any_of(attack.supports.begin(), attack.supports.end(),
                     [&](const auto& support) { return support.motion.attacker_id == id; });
}

void addId(const std::string& id, const OrientedBox& framed, const OrientedBox& shown, double scale,
           std::vector<OrientedBox>& obstacles, MarkerList& markers) {
  const std::string text = shortId(id);
  const BoxSize size = textSize(text, scale * kIdLetterHeight);
  const LabelSide side = freestSide(framed, size, obstacles);
  if (side.covered > 0) return;
  const Vector2 place = placeBeside(shown, size, side);
  markers.addText("ids", text, place, scale * kIdLetterHeight, kTextHeight, colors::kText);
  obstacles.push_back({{place.x(), place.y(), 0.0}, size});
}

void addWords(const std::string& name_space, const std::string& words, const Vector2& middle,
              double letter_height, MarkerList& markers) {
  markers.addSlab(name_space + "_plate",
                  {{middle.x(), middle.y(), 0.0}, textSize(words, letter_height)}, kPlateHeight,
                  colors::kPlate);
  markers.addText(name_space, words, middle, letter_height, kTextHeight, colors::kText);
}

OrientedBox wordsBox(const collision_forge::Attack& attack, const WordsPlace& place, double scale) {
  const LabelSide side = freestSide(place.box, textSize(kMostWords, kWordsLetterHeight),
                                    obstaclesOf(attack, place.obstacles), kFarRings);
  const BoxSize size = textSize(kMostWords, scale * kWordsLetterHeight);
  const Vector2 middle = placeBeside(place.box, size, side);
  return {{middle.x(), middle.y(), 0.0}, size};
}

void addAttackWords(const collision_forge::Attack& attack, const WordsPlace& place,
                    const OrientedBox& attacker, const std::string& words, double scale,
                    MarkerList& markers) {
  const OrientedBox box = wordsBox(attack, place, scale);
  const Vector2 middle = box.center.position();
  addWords("words", words, middle, scale * kWordsLetterHeight, markers);
  const std::string id = shortId(attack.trajectory.attacker_id);
  const BoxSize size = textSize(id, scale * kIdLetterHeight);
  const bool is_above = middle.y() > place.box.center.y;
  const Vector2 id_middle = placeBeside(attacker, size, {{0.0, is_above ? -1.0 : 1.0}});
  if (overlaps({{id_middle.x(), id_middle.y(), 0.0}, size}, box)) return;
  markers.addText("ids", id, id_middle, scale * kIdLetterHeight, kTextHeight, colors::kText);
}

void addPath(const std::string& name, const std::vector<TrajectoryPoint>& points, double end,
             const BoxSize& size, const colors::MarkerColor& color, MarkerList& markers) {
  std::vector<Vector2> path;
  std::vector<Vector2> outlines;
  double next_ghost = 0.0;  // s from the first point
  for (const TrajectoryPoint& point : points) {
    if (point.time > end) break;
    const OrientedBox box{point.pose, size};
    path.push_back(box.center.position());
    if (point.time - points.front().time < next_ghost - kTimeTolerance) continue;
    next_ghost += kGhostInterval;
    appendOutline(box, outlines);
    markers.addSlab(name + "_ghosts", box, kGhostHeight, colors::withAlpha(color, kGhostAlpha));
  }
  std::vector<Vector2> lines;
  appendPolyline(path, lines);
  markers.addLines(name + "_path", lines, kPathWidth, kPathHeight, color);
  markers.addLines(name + "_ghost_outlines", outlines, kGhostWidth, kOutlineHeight, color);
}

Vector2 addContact(const OrientedBox& ego, const OrientedBox& other,
                   const colors::MarkerColor& other_color, MarkerList& markers) {
  markers.addSlab("contact_boxes", ego, kContactBoxHeight,
                  colors::withAlpha(colors::kEgo, kContactAlpha));
  markers.addSlab("contact_boxes", other, kContactBoxHeight,
                  colors::withAlpha(other_color, kContactAlpha));
  const Vector2 point = touchPoint(ego, other);
  markers.addDisc("contact", point, kContactDiameter, kContactHeight, colors::kContact);
  return point;
}

}  // namespace forge
