#include "collision_forge/io/maps/open_drive_road.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/xml_input.h"

namespace forge {
namespace {

using pugi::xml_node;

constexpr double kShortestPiece = 1e-6;  // m; shorter pieces of a reference line are rounding
constexpr double kMostTurn = 100.0;      // rad in one piece; 16 full circles are damage

std::optional<int> integerIn(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool is(const pugi::xml_attribute& attribute, const char* value) {
  return std::strcmp(attribute.value(), value) == 0;
}

OpenDriveLink linkIn(const xml_node& element) {
  OpenDriveLink link;
  link.id = element.attribute("elementId").value();
  const pugi::xml_attribute type = element.attribute("elementType");
  if (is(type, "junction")) link.to = OpenDriveLink::To::kJunction;
  const pugi::xml_attribute contact = element.attribute("contactPoint");
  // A road that is joined between its ends (attribute elementS) has no contact point.
  if (is(type, "road") && (is(contact, "start") || is(contact, "end"))) {
    link.to = OpenDriveLink::To::kRoad;
    link.at_end = is(contact, "end");
  }
  return link;
}

std::vector<int> lanesIn(const xml_node& link, const char* name) {
  std::vector<int> ids;
  for (const xml_node& element : link.children(name)) {
    const auto id = integerIn(element.attribute("id").value());
    if (id && *id != 0) ids.push_back(*id);
  }
  return ids;
}

LaneDirection directionOf(const xml_node& lane) {
  const pugi::xml_attribute direction = lane.attribute("direction");
  if (is(direction, "reversed")) return LaneDirection::kReversed;
  const bool is_both = is(direction, "both") || is(lane.attribute("type"), "bidirectional");
  return is_both ? LaneDirection::kBoth : LaneDirection::kStandard;
}

/// Reads one road.
class RoadReader {
 public:
  RoadReader(const xml_node& road, const Pose2& origin, const InputLimits& limits,
             const std::string& path)
      : node_(road), origin_(origin), limits_(limits), path_(path) {}

  OpenDriveRoad read() {
    road_.id = node_.attribute("id").value();
    const pugi::xml_attribute junction = node_.attribute("junction");
    if (!is(junction, "-1")) road_.junction = junction.value();
    if (is(node_.attribute("rule"), "LHT")) road_.side = DrivingSide::kLeft;
    road_.before = linkIn(node_.child("link").child("predecessor"));
    road_.after = linkIn(node_.child("link").child("successor"));
    readLine();
    readLanes();
    return std::move(road_);
  }

 private:
  double number(const xml_node& element, const char* attribute) const {
    return numberIn(element, attribute, path_);
  }

  [[noreturn]] void refuse(const xml_node& element, const std::string& problem) const {
    throw MapError(path_ + ": " + describedElement(element) + ": " + problem);
  }

  Cubic cubic(const xml_node& element) const {
    return {number(element, "a"), number(element, "b"), number(element, "c"), number(element, "d")};
  }

  Cubic cubic(const xml_node& element, const std::string& axis) const {
    const auto part = [&](const char* letter) { return number(element, (letter + axis).c_str()); };
    return {part("a"), part("b"), part("c"), part("d")};
  }

  void readLine() {
    std::vector<xml_node> pieces;
    for (const xml_node& piece : node_.child("planView").children("geometry")) {
      if (number(piece, "length") > kShortestPiece) pieces.push_back(piece);
    }
    if (pieces.empty()) throw MapError(path_ + ": the road has no reference line");
    std::stable_sort(pieces.begin(), pieces.end(), [&](const xml_node& a, const xml_node& b) {
      return number(a, "s") < number(b, "s");
    });
    for (const xml_node& piece : pieces) {
      const double length = number(piece, "length");
      road_.line.append(length, shapeOf(piece, length));
      if (!(road_.line.length() <= limits_.max_coordinate)) {
        refuse(piece, "the road is longer than max_coordinate in input_limits.yaml");
      }
    }
  }

  std::variant<Clothoid, CubicCurve> shapeOf(const xml_node& piece, double length) const {
    const Pose2 local{number(piece, "x"), number(piece, "y"), number(piece, "hdg")};
    const Pose2 start = compose(origin_, {local.x, local.y, wrapAngle(local.yaw)});
    if (!isWithin(start, limits_)) {
      refuse(piece, "the position is beyond max_coordinate in input_limits.yaml");
    }
    if (piece.child("line")) return Clothoid(start, length, 0.0, 0.0);
    if (const xml_node arc = piece.child("arc")) {
      const double curvature = checkedCurvature(arc, "curvature", length);
      return Clothoid(start, length, curvature, curvature);
    }
    if (const xml_node spiral = piece.child("spiral")) {
      return Clothoid(start, length, checkedCurvature(spiral, "curvStart", length),
                      checkedCurvature(spiral, "curvEnd", length));
    }
    try {
      return cubicShape(piece, start, length);
    } catch (const std::invalid_argument& error) {
      refuse(piece, error.what());
    }
  }

  CubicCurve cubicShape(const xml_node& piece, const Pose2& start, double length) const {
    if (const xml_node height = piece.child("poly3")) {
      return CubicCurve::ofHeight(start, length, cubic(height));
    }
    const xml_node curve = piece.child("paramPoly3");
    if (!curve) refuse(piece, "has none of line, arc, spiral, poly3 and paramPoly3");
    const double p_end = is(curve.attribute("pRange"), "arcLength") ? length : 1.0;
    return CubicCurve(start, length, cubic(curve, "U"), cubic(curve, "V"), p_end);
  }

  double checkedCurvature(const xml_node& shape, const char* attribute, double length) const {
    const double curvature = number(shape, attribute);
    if (std::abs(curvature) * limits_.min_radius <= 1.0 &&
        std::abs(curvature) * length <= kMostTurn) {
      return curvature;
    }
    refuse(shape, std::string("attribute ") + attribute + " is " +
                      shape.attribute(attribute).value() + ", too much for a road");
  }

  void readLanes() {
    const xml_node lanes = node_.child("lanes");
    for (const xml_node& offset : lanes.children("laneOffset")) {
      road_.lane_offset.add(number(offset, "s"), cubic(offset));
    }
    std::vector<std::pair<double, xml_node>> begins;
    for (const xml_node& section : lanes.children("laneSection")) {
      const double begin = std::max(number(section, "s"), 0.0);
      if (begin < road_.line.length()) begins.emplace_back(begin, section);
    }
    std::stable_sort(begins.begin(), begins.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < begins.size(); ++i) {
      const double end = i + 1 < begins.size() ? begins[i + 1].first : road_.line.length();
      addSection(sectionIn(begins[i].second, begins[i].first, end));
    }
    if (road_.sections.empty()) throw MapError(path_ + ": the road has no lane section");
  }

  /// Adds a section, in parts if it is long.
  void addSection(OpenDriveSection section) {
    while (section.end - section.begin > kLongestSection) {
      OpenDriveSection part = section;
      section.begin = part.end = part.begin + kLongestSection;
      part.continues = true;
      road_.sections.push_back(std::move(part));
    }
    road_.sections.push_back(std::move(section));
  }

  OpenDriveSection sectionIn(const xml_node& node, double begin, double end) const {
    OpenDriveSection section;
    section.begin = begin;
    section.end = end;
    for (const char* const side : {"left", "right"}) {
      for (const xml_node& lane : node.child(side).children("lane")) {
        const auto id = integerIn(lane.attribute("id").value());
        if (!id || *id == 0) refuse(lane, "the id is not an integer other than 0");
        (*id > 0 ? section.left : section.right).push_back(laneIn(lane, *id, begin));
      }
    }
    for (std::vector<OpenDriveLane>* const side : {&section.left, &section.right}) {
      std::sort(side->begin(), side->end(), [](const OpenDriveLane& a, const OpenDriveLane& b) {
        return std::abs(a.id) < std::abs(b.id);
      });
    }
    return section;
  }

  OpenDriveLane laneIn(const xml_node& node, int id, double begin) const {
    OpenDriveLane lane;
    lane.id = id;
    lane.type = node.attribute("type").value();
    lane.direction = directionOf(node);
    lane.predecessors = lanesIn(node.child("link"), "predecessor");
    lane.successors = lanesIn(node.child("link"), "successor");
    lane.is_border = !node.child("width") && node.child("border");
    for (const xml_node& part : node.children(lane.is_border ? "border" : "width")) {
      lane.outline.add(begin + number(part, "sOffset"), cubic(part));
    }
    lane.speed_limit = speedLimit(node.child("speed"));
    if (!lane.speed_limit) lane.speed_limit = speedLimit(typeAt(begin).child("speed"));
    return lane;
  }

  xml_node typeAt(double arc_length) const {
    xml_node last;
    for (const xml_node& type : node_.children("type")) {
      const auto begin = finiteNumber(type.attribute("s").value());
      if (begin && *begin <= arc_length) last = type;
    }
    return last;
  }

  /// Returns nullopt for a speed that is no number ("no limit"), not positive, or beyond the
  /// limits.
  std::optional<double> speedLimit(const xml_node& speed) const {
    constexpr double kKilometreAnHour = 1.0 / 3.6;  // m/s
    constexpr double kMileAnHour = 0.44704;         // m/s
    auto limit = finiteNumber(speed.attribute("max").value());
    if (!limit) return std::nullopt;
    const pugi::xml_attribute unit = speed.attribute("unit");
    if (is(unit, "km/h")) *limit *= kKilometreAnHour;
    if (is(unit, "mph")) *limit *= kMileAnHour;
    if (!(*limit > 0.0 && *limit <= limits_.max_speed)) return std::nullopt;
    return limit;
  }

  const xml_node node_;
  const Pose2 origin_;
  const InputLimits& limits_;
  const std::string& path_;
  OpenDriveRoad road_;
};

}  // namespace

OpenDriveRoad readOpenDriveRoad(const xml_node& road, const Pose2& origin,
                                const InputLimits& limits, const std::string& path) {
  return RoadReader(road, origin, limits, path).read();
}

}  // namespace forge
