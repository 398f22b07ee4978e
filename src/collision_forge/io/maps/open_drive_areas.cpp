#include "collision_forge/io/maps/open_drive_areas.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace forge {
namespace {

namespace geometry = boost::geometry;
using Ring = std::vector<Vector2>;
using ClosedPolygon = geometry::model::polygon<geometry::model::d2::point_xy<double>>;
using ClosedPolygons = geometry::model::multi_polygon<ClosedPolygon>;

/// A strip and its use.
struct UsedStrip {
  LaneUse use;
  const LaneStrip* strip;
};

void addStrips(const std::vector<OpenDriveLane>& lanes, const std::vector<LaneStrip>& strips,
               std::vector<UsedStrip>& used) {
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    LaneUse use = laneUse(lanes[i].type).value_or(LaneUse::kNothing);
    if (use == LaneUse::kLane) use = LaneUse::kRoad;
    used.push_back({use, &strips[i]});
  }
}

/// Returns false if the union cannot be computed.
bool unite(const Ring& ring, ClosedPolygons& areas) {
  ClosedPolygon polygon;
  for (const Vector2& point : ring) polygon.outer().emplace_back(point.x(), point.y());
  geometry::correct(polygon);
  ClosedPolygons united;
  try {
    geometry::union_(areas, polygon, united);
  } catch (const geometry::exception&) {
    return false;
  }
  areas = std::move(united);
  return true;
}

bool hasArea(const Ring& ring) {
  constexpr double kSmallestArea = 1e-3;  // m^2
  double twice_area = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - ring[0];
    const Vector2 b = ring[(i + 1) % ring.size()] - ring[0];
    twice_area += a.x() * b.y() - b.x() * a.y();
  }
  return ring.size() >= 3 && std::abs(twice_area) > 2.0 * kSmallestArea;
}

}  // namespace

std::optional<LaneUse> laneUse(const std::string& type) {
  static const std::map<std::string, LaneUse> kUses = {
      {"driving", LaneUse::kLane},    {"bidirectional", LaneUse::kLane},
      {"entry", LaneUse::kLane},      {"exit", LaneUse::kLane},
      {"onRamp", LaneUse::kLane},     {"offRamp", LaneUse::kLane},
      {"mwyEntry", LaneUse::kLane},   {"mwyExit", LaneUse::kLane},
      {"slipLane", LaneUse::kLane},   {"connectingRamp", LaneUse::kLane},
      {"HOV", LaneUse::kLane},        {"bus", LaneUse::kLane},
      {"taxi", LaneUse::kLane},       {"shared", LaneUse::kLane},
      {"biking", LaneUse::kRoad},     {"stop", LaneUse::kRoad},
      {"shoulder", LaneUse::kRoad},   {"border", LaneUse::kRoad},
      {"restricted", LaneUse::kRoad}, {"parking", LaneUse::kRoad},
      {"roadWorks", LaneUse::kRoad},  {"tram", LaneUse::kRoad},
      {"special1", LaneUse::kRoad},   {"special2", LaneUse::kRoad},
      {"special3", LaneUse::kRoad},   {"sidewalk", LaneUse::kWalkway},
      {"walking", LaneUse::kWalkway}, {"none", LaneUse::kNothing},
      {"median", LaneUse::kNothing},  {"curb", LaneUse::kNothing},
      {"rail", LaneUse::kNothing},
  };
  const auto found = kUses.find(type);
  return found == kUses.end() ? std::nullopt : std::make_optional(found->second);
}

void addAreas(const OpenDriveSection& section, const SectionStrips& strips, LaneMap& map) {
  std::vector<UsedStrip> used;  // from the left edge of the road to the right
  addStrips(section.left, strips.left, used);
  std::reverse(used.begin(), used.end());
  addStrips(section.right, strips.right, used);
  for (std::size_t first = 0, next = 0; first < used.size(); first = next) {
    while (next < used.size() && used[next].use == used[first].use) ++next;
    if (used[first].use == LaneUse::kNothing) continue;
    Ring ring = used[first].strip->left;
    const Ring& right = used[next - 1].strip->right;
    ring.insert(ring.end(), right.rbegin(), right.rend());
    if (!hasArea(ring)) continue;
    std::vector<Polygon>& areas =
        used[first].use == LaneUse::kRoad ? map.drivable_area : map.walkways;
    areas.push_back({std::move(ring), {}});
  }
}

std::vector<Polygon> gapsBetween(const std::vector<Polygon>& areas) {
  constexpr double kLargestGap = 20.0;  // m^2
  ClosedPolygons united;
  for (const Polygon& area : areas) {
    if (!unite(area.exterior, united)) return {};
  }
  std::vector<Polygon> gaps;
  for (const ClosedPolygon& area : united) {
    for (const auto& inner : area.inners()) {
      Polygon gap;
      for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
        gap.exterior.emplace_back(inner[i].x(), inner[i].y());
      }
      if (hasArea(gap.exterior) && std::abs(geometry::area(inner)) <= kLargestGap) {
        gaps.push_back(std::move(gap));
      }
    }
  }
  return gaps;
}

}  // namespace forge
