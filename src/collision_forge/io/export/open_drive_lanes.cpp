#include "collision_forge/io/export/open_drive_lanes.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "collision_forge/io/export/xml.h"

namespace forge {

/// A lane section, m along the road.
struct LaneWriter::Section {
  double begin;
  double end;
  bool is_first;
  bool is_last;
};

namespace {

using pugi::xml_node;

constexpr double kMarkWidth = 0.12;        // m, of usual lane marks
constexpr double kMostDrift = 0.2;         // m
constexpr double kDriftStep = 2.0;         // m, least length of a section for drift: own choice
constexpr double kShortestSection = 0.05;  // m
constexpr double kLeastGap = 0.1;          // m before a sidewalk; narrower ones are left out

void addPolynomial(xml_node parent, const char* name, const char* at, double begin, double value,
                   double slope) {
  addElement(parent, name,
             {{at, xmlNumber(begin)},
              {"a", xmlNumber(value)},
              {"b", xmlNumber(slope)},
              {"c", "0"},
              {"d", "0"}});
}

/// Adds the piecewise linear function with these values at the knots, ascending arc lengths,
/// between two arc lengths and relative to the first.
void addLinear(xml_node parent, const char* name, const char* at, const std::vector<double>& knots,
               const std::vector<double>& values, double begin, double end) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const bool is_last = i + 1 == knots.size();
    if (knots[i] >= end || (!is_last && knots[i + 1] <= begin)) continue;
    const double slope = is_last ? 0.0 : (values[i + 1] - values[i]) / (knots[i + 1] - knots[i]);
    const double from = std::max(begin, knots[i]);
    addPolynomial(parent, name, at, from - begin, values[i] + slope * (from - knots[i]), slope);
  }
}

/// Returns how far the middles of a road's lanes move away from the centre or towards it between
/// two arc lengths: the largest distance, m.
double driftBetween(const Road& road, double from, double to) {
  double largest = 0.0;
  for (const auto* lanes : {&road.left, &road.right}) {
    double inner = 0.0;  // change of the widths between the centre and the lane
    for (const RoadLane& lane : *lanes) {
      const double change = road.valueAt(lane.width, to) - road.valueAt(lane.width, from);
      largest = std::max(largest, std::abs(inner + 0.5 * change));
      inner += change;
    }
  }
  return largest;
}

/// Returns the arc lengths at which lane sections begin: where lanes begin or end within the road,
/// and where widths have changed so far that readers that take a section's first widths for all of
/// it (SUMO) would shift lanes by more than kMostDrift.
std::vector<double> sectionsOf(const Road& road) {
  std::set<double> begins = {0.0};
  const double length = road.course.length();
  const auto add = [&](double at) {
    if (at > kShortestSection && at < length - kShortestSection) begins.insert(at);
  };
  double first = 0.0;
  for (double at = kDriftStep; at < length - kDriftStep; at += kDriftStep) {
    if (driftBetween(road, first, at) <= kMostDrift) continue;
    first = at;
    add(first);
  }
  for (const auto* lanes : {&road.left, &road.right}) {
    for (const RoadLane& lane : *lanes) {
      if (lane.lane.empty()) continue;
      add(lane.from);
      add(lane.to);
    }
  }
  std::vector<double> apart;
  for (const double begin : begins) {
    if (apart.empty() || begin > apart.back() + kShortestSection) apart.push_back(begin);
  }
  return apart;
}

xml_node addLaneNode(xml_node side, int id, const char* type) {
  return addElement(side, "lane", {{"id", std::to_string(id)}, {"type", type}, {"level", "false"}});
}

}  // namespace

std::optional<double> commonLimit(const Road& road) {
  std::set<std::optional<double>> limits;
  for (const auto* lanes : {&road.left, &road.right}) {
    for (const RoadLane& lane : *lanes) {
      if (!lane.lane.empty()) limits.insert(lane.speed_limit);
    }
  }
  return limits.size() == 1 ? *limits.begin() : std::nullopt;
}

void addSpeedLimit(xml_node parent, double limit, std::optional<double> place) {
  xml_node speed = addElement(parent, "speed");
  if (place) speed.append_attribute("sOffset") = xmlNumber(*place).c_str();
  speed.append_attribute("max") = xmlNumber(limit).c_str();
  speed.append_attribute("unit") = "m/s";
}

LaneWriter::LaneWriter(const LaneMap& map) : lines_(map), sidewalks_(map) {}

void LaneWriter::addLanes(xml_node lanes, const Road& road) const {
  const double length = road.course.length();
  addLinear(lanes, "laneOffset", "s", road.knots, road.offset, 0.0, length);
  const Sidewalk left = sidewalks_.along(road, 1), right = sidewalks_.along(road, -1);
  const std::vector<double> begins = sectionsOf(road);
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const bool is_last = i + 1 == begins.size();
    const Section section{begins[i], is_last ? length : begins[i + 1], i == 0, is_last};
    xml_node node = addElement(lanes, "laneSection", {{"s", xmlNumber(section.begin)}});
    addSide(node, road, 1, left, section);
    xml_node centre = addLaneNode(addElement(node, "center"), 0, "none");
    addMarks(centre, road, 0, false, section);
    addSide(node, road, -1, right, section);
  }
}

void LaneWriter::addSide(xml_node section_node, const Road& road, int side,
                         const Sidewalk& sidewalk, const Section& section) const {
  const std::vector<RoadLane>& lanes = side < 0 ? road.right : road.left;
  if (lanes.empty()) return;
  xml_node node = addElement(section_node, side < 0 ? "right" : "left");
  for (const RoadLane& lane : lanes) addLane(node, road, lane, section);
  int id = lanes.back().id;
  const auto addStrip = [&](const char* type, const std::vector<double>& width) {
    xml_node strip = addLaneNode(node, id += side, type);
    xml_node link = addElement(strip, "link");
    if (!section.is_first) addElement(link, "predecessor", {{"id", std::to_string(id)}});
    if (!section.is_last) addElement(link, "successor", {{"id", std::to_string(id)}});
    addLinear(strip, "width", "sOffset", sidewalk.at, width, section.begin, section.end);
  };
  if (!sidewalk.at.empty()) {
    const double gap = *std::max_element(sidewalk.gap.begin(), sidewalk.gap.end());
    if (gap > kLeastGap) addStrip(sidewalk.is_gap_drivable ? "shoulder" : "none", sidewalk.gap);
    addStrip("sidewalk", sidewalk.width);
  }
  if (side < 0) return;
  // In a file, lanes are listed from left to right.
  for (xml_node lane = node.first_child().next_sibling(); lane;) {
    const xml_node next = lane.next_sibling();
    node.prepend_move(lane);
    lane = next;
  }
}

void LaneWriter::addLane(xml_node side, const Road& road, const RoadLane& lane,
                         const Section& section) const {
  const double middle = 0.5 * (section.begin + section.end);
  const bool is_driven = !lane.lane.empty() && lane.from <= middle && middle <= lane.to;
  const char* const type = !is_driven ? "none" : lane.is_for_bikes ? "biking" : "driving";
  xml_node node = addLaneNode(side, lane.id, type);
  xml_node link = addElement(node, "link");
  const auto addLink = [&](const char* name, bool is_outer, const std::optional<int>& outer) {
    const std::optional<int> id = is_outer ? outer : lane.id;
    if (id && !lane.lane.empty()) addElement(link, name, {{"id", std::to_string(*id)}});
  };
  addLink("predecessor", section.is_first, lane.before);
  addLink("successor", section.is_last, lane.after);
  addLinear(node, "width", "sOffset", road.knots, lane.width, section.begin, section.end);
  if (!lane.lane.empty()) {
    const std::vector<RoadLane>& lanes = lane.id < 0 ? road.right : road.left;
    addMarks(node, road, lane.id, &lane != &lanes.back(), section);
  }
  if (is_driven && lane.speed_limit && !commonLimit(road)) {
    addSpeedLimit(node, *lane.speed_limit, 0.0);
  }
}

void LaneWriter::addMarks(xml_node lane, const Road& road, int id, bool is_broken,
                          const Section& section) const {
  if (road.junction != 0) return;
  const auto border = [&](double at) { return road.borderAt(id, at); };
  for (const LaneMark& mark : lines_.marksAlong(road.course, border, section.begin, section.end)) {
    const bool is_drawn_broken = mark.line ? isBrokenLine(*mark.line) : is_broken;
    const char* const color = !mark.line                 ? "standard"
                              : isYellowLine(*mark.line) ? "yellow"
                                                         : "white";
    addElement(lane, "roadMark",
               {{"sOffset", xmlNumber(mark.from - section.begin)},
                {"type", is_drawn_broken ? "broken" : "solid"},
                {"weight", "standard"},
                {"color", color},
                {"width", xmlNumber(kMarkWidth)}});
  }
}

}  // namespace forge
