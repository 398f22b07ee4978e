#include "collision_forge/planner_test/report/compact_motion.h"

#include <cmath>

namespace forge {
namespace {

constexpr double kMillisecond = 1e-3;  // s
constexpr double kCentimetre = 1e-2;   // m; also per second for speeds and accelerations
constexpr double kMilliradian = 1e-3;  // rad

/// Returns one number per element.
template <typename Element, typename Get>
std::vector<double> listOf(const std::vector<Element>& elements, const Get& get) {
  std::vector<double> values;
  values.reserve(elements.size());
  for (const Element& element : elements) values.push_back(get(element));
  return values;
}

/// Writes times and poses of states or points.
template <typename Element>
void writePoses(JsonLineWriter& writer, const std::vector<Element>& elements, double origin) {
  const auto write = [&](const char* key, double unit, const auto& get) {
    writer.numbers(key, differences(listOf(elements, get), unit));
  };
  write("t", kMillisecond, [&](const Element& element) { return element.time - origin; });
  write("x", kCentimetre, [](const Element& element) { return element.pose.x; });
  write("y", kCentimetre, [](const Element& element) { return element.pose.y; });
  write("yaw", kMilliradian, [](const Element& element) { return element.pose.yaw; });
}

}  // namespace

std::vector<double> differences(const std::vector<double>& values, double unit) {
  std::vector<double> steps;
  steps.reserve(values.size());
  double before = 0.0;
  for (const double value : values) {
    const double whole = std::round(value / unit);
    steps.push_back(whole - before);
    before = whole;
  }
  return steps;
}

void writePlaces(JsonLineWriter& writer, const std::vector<Vector2>& places) {
  const auto x = listOf(places, [](const Vector2& place) { return place.x(); });
  const auto y = listOf(places, [](const Vector2& place) { return place.y(); });
  writer.numbers("x", differences(x, kCentimetre));
  writer.numbers("y", differences(y, kCentimetre));
}

void writeStates(JsonLineWriter& writer, const char* key, const std::vector<AgentState>& states,
                 double origin) {
  writer.beginObject(key);
  writePoses(writer, states, origin);
  writer.endObject();
}

void writeTrajectory(JsonLineWriter& writer, const char* key,
                     const std::vector<TrajectoryPoint>& points, double origin) {
  writer.beginObject(key);
  writePoses(writer, points, origin);
  const auto v = listOf(points, [](const TrajectoryPoint& point) { return point.speed; });
  const auto a = listOf(points, [](const TrajectoryPoint& point) { return point.acceleration; });
  writer.numbers("v", differences(v, kCentimetre));
  writer.numbers("a", differences(a, kCentimetre));
  writer.endObject();
}

}  // namespace forge
