#include "collision_forge/ros/marker_parts.h"

#include <collision_forge/Agent.h>

#include <cstdio>

#include "collision_forge/geometry/touch_point.h"
#include "collision_forge/ros/label_places.h"
#include "collision_forge/scene/short_id.h"

namespace forge {
namespace {

constexpr double kGhostWidth = 0.1;      // m
constexpr double kGhostInterval = 0.5;   // s
constexpr double kTimeTolerance = 1e-6;  // s
constexpr float kGhostAlpha = 0.16F;
constexpr double kReportLetterHeight = 2.2;  // m
constexpr double kWordsLetterHeight = 1.5;   // m
constexpr double kIdLetterHeight = 1.0;      // m

}  // namespace

std::string formatted(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

BoxSize sizeOf(const geometry_msgs::Vector3& size) { return {size.x, size.y}; }

bool canAttackClass(std::uint8_t agent_class) {
  return agent_class <= collision_forge::Agent::STATIC_OBJECT &&
         canAttack(static_cast<AgentClass>(agent_class));
}

void addId(const std::string& id, const OrientedBox& box, const std::vector<OrientedBox>& boxes,
           MarkerList& markers) {
  const std::string shown = shortId(id);
  const auto place = placeBeside(box, textSize(shown, kIdLetterHeight), boxes);
  if (!place) return;
  markers.addText("ids", shown, *place, kIdLetterHeight, kTextHeight, colors::kText);
}

void addWordsBeside(const OrientedBox& box, const std::string& words,
                    std::vector<OrientedBox>& boxes, MarkerList& markers) {
  const BoxSize size = textSize(words, kWordsLetterHeight);
  std::vector<OrientedBox> all = boxes;
  all.push_back(box);
  const auto free = placeBeside(box, size, all);
  const Vector2 place = free ? *free : *placeBeside(box, size, {box});
  markers.addText("words", words, place, kWordsLetterHeight, kTextHeight, colors::kText);
  boxes.push_back({{place.x(), place.y(), 0.0}, size});
}

void addWay(const std::string& name, const std::vector<TrajectoryPoint>& points, double end,
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
  markers.addSlab("contact_boxes", ego, kPathHeight,
                  colors::withAlpha(colors::kEgo, kContactAlpha));
  markers.addSlab("contact_boxes", other, kPathHeight,
                  colors::withAlpha(other_color, kContactAlpha));
  const Vector2 point = touchPoint(ego, other);
  markers.addDisc("contact", point, kContactDiameter, kContactHeight, colors::kContact);
  return point;
}

void addReport(const std::string& text, const Vector2& place, const Vector2& direction,
               MarkerList& markers) {
  const Vector2 margin(15.0, 11.0);  // m, for half the text and the boxes
  markers.addText("report", text, place + direction.normalized().cwiseProduct(margin),
                  kReportLetterHeight, kTextHeight, colors::kText);
}

}  // namespace forge
