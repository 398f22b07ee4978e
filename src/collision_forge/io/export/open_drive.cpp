#include "collision_forge/io/export/open_drive.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "collision_forge/io/export/road_network.h"
#include "collision_forge/io/export/xml.h"

namespace forge {
namespace {

using pugi::xml_node;

constexpr double kMarkWidth = 0.12;          // m, of usual lane marks
constexpr double kSectionChange = 0.4;       // m; a lane's middle is off by half of it in SUMO
constexpr double kShortestSection = 0.05;    // m
constexpr double kFarthestCrosswalk = 20.0;  // m from a reference line

/// Writes one network.
class OpenDriveWriter {
 public:
  OpenDriveWriter(const CrashRecord& record, const ExportOptions& options)
      : record_(record),
        network_(roadNetwork(record.lanes, record.arcs, options.lane_width)),
        origin_(localOrigin(record)),
        is_left_(record.lanes.driving_side == DrivingSide::kLeft) {
    for (const MapFeature& feature : record.lanes.features) {
      if (feature.kind == FeatureKind::kCrosswalk && feature.points.size() > 2) place(feature);
    }
  }

  std::size_t unbundled() const { return network_.unbundled; }

  std::string text() const {
    pugi::xml_document document;
    xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    xml_node root = addElement(document, "OpenDRIVE");
    addHeader(root);
    for (const Road& road : network_.roads) addRoad(root, road);
    for (const Junction& junction : network_.junctions) addJunction(root, junction);
    return xmlText(document);
  }

 private:
  void addHeader(xml_node root) const {
    Eigen::AlignedBox2d box(Vector2(0.0, 0.0));
    for (const Road& road : network_.roads) {
      for (const RoadPiece& piece : road.course.pieces())
        box.extend(piece.start.position() - origin_);
    }
    xml_node header = addElement(root, "header",
                                 {{"revMajor", "1"},
                                  {"revMinor", "6"},
                                  {"name", record_.name},
                                  {"version", "1"},
                                  {"date", xmlDate(record_.scenario.asked.now)},
                                  {"north", xmlNumber(box.max().y())},
                                  {"south", xmlNumber(box.min().y())},
                                  {"east", xmlNumber(box.max().x())},
                                  {"west", xmlNumber(box.min().x())},
                                  {"vendor", "collision_forge"}});
    const std::string projection = "+proj=tmerc +lat_0=" + xmlNumber(record_.origin.latitude) +
                                   " +lon_0=" + xmlNumber(record_.origin.longitude) +
                                   " +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m";
    addElement(header, "geoReference").append_child(pugi::node_cdata).set_value(projection.c_str());
    addElement(
        header, "offset",
        {{"x", xmlNumber(origin_.x())}, {"y", xmlNumber(origin_.y())}, {"z", "0"}, {"hdg", "0"}});
  }

  void addRoad(xml_node root, const Road& road) const {
    xml_node node = addElement(root, "road",
                               {{"name", road.name()},
                                {"length", xmlNumber(road.course.length())},
                                {"id", std::to_string(road.id)},
                                {"junction", std::to_string(road.junction ? road.junction : -1)},
                                {"rule", is_left_ ? "LHT" : "RHT"}});
    xml_node link = addElement(node, "link");
    addJoint(link, "predecessor", road.before);
    addJoint(link, "successor", road.after);
    xml_node type = addElement(node, "type", {{"s", "0"}, {"type", "town"}});
    if (const auto limit = commonLimit(road)) addLimit(type, {}, *limit);
    addCourse(node, road);
    addLanes(addElement(node, "lanes"), road);
    addCrosswalks(node, road);
  }

  /// A crosswalk and its place on the road nearest to its middle.
  struct Crosswalk {
    const MapFeature* feature;
    int road;
    double arc_length;  // m, on the reference line
    double lateral;     // m from the reference line, positive to the left
  };

  void place(const MapFeature& feature) {
    Vector2 middle = Vector2::Zero();
    for (const Vector2& point : feature.points) {
      middle += point / static_cast<double>(feature.points.size());
    }
    std::optional<Crosswalk> nearest;
    for (const Road& road : network_.roads) {
      const double at = road.course.projection(middle, road.course.roughProjection(middle));
      if (!(at >= 0.0 && at <= road.course.length())) continue;
      const double lateral = relativeTo(road.course.poseAt(at), {middle.x(), middle.y(), 0.0}).y;
      if (nearest && std::abs(nearest->lateral) <= std::abs(lateral)) continue;
      nearest = Crosswalk{&feature, road.id, at, lateral};
    }
    if (nearest && std::abs(nearest->lateral) <= kFarthestCrosswalk) {
      crosswalks_.push_back(*nearest);
    }
  }

  void addCrosswalks(xml_node road_node, const Road& road) const {
    for (std::size_t i = 0; i < crosswalks_.size(); ++i) {
      const Crosswalk& crosswalk = crosswalks_[i];
      if (crosswalk.road != road.id) continue;
      xml_node objects = road_node.child("objects");
      if (!objects) objects = addElement(road_node, "objects");
      xml_node object = addElement(objects, "object",
                                   {{"type", "crosswalk"},
                                    {"id", std::to_string(i + 1)},
                                    {"s", xmlNumber(crosswalk.arc_length)},
                                    {"t", xmlNumber(crosswalk.lateral)},
                                    {"zOffset", "0"},
                                    {"hdg", "0"},
                                    {"orientation", "none"}});
      xml_node outline = addElement(addElement(object, "outlines"), "outline",
                                    {{"id", "0"}, {"outer", "true"}, {"closed", "true"}});
      const Pose2 middle =
          compose(road.course.poseAt(crosswalk.arc_length), {0.0, crosswalk.lateral, 0.0});
      for (const Vector2& point : crosswalk.feature->points) {
        const Pose2 corner = relativeTo(middle, {point.x(), point.y(), 0.0});
        addElement(
            outline, "cornerLocal",
            {{"u", xmlNumber(corner.x)}, {"v", xmlNumber(corner.y)}, {"z", "0"}, {"height", "0"}});
      }
    }
  }

  static void addJoint(xml_node link, const char* name, const RoadJoint& joint) {
    if (joint.to == RoadJoint::To::kNothing) return;
    const bool is_road = joint.to == RoadJoint::To::kRoad;
    xml_node node = addElement(
        link, name,
        {{"elementType", is_road ? "road" : "junction"}, {"elementId", std::to_string(joint.id)}});
    if (is_road) node.append_attribute("contactPoint") = joint.at_end ? "end" : "start";
  }

  void addCourse(xml_node road_node, const Road& road) const {
    xml_node plan = addElement(road_node, "planView");
    double begin = 0.0;
    for (const RoadPiece& piece : road.course.pieces()) {
      const Vector2 start = piece.start.position() - origin_;
      xml_node geometry = addElement(plan, "geometry",
                                     {{"s", xmlNumber(begin)},
                                      {"x", xmlNumber(start.x())},
                                      {"y", xmlNumber(start.y())},
                                      {"hdg", xmlNumber(piece.start.yaw)},
                                      {"length", xmlNumber(piece.length)}});
      if (piece.curvature == 0.0) {
        addElement(geometry, "line");
      } else {
        addElement(geometry, "arc", {{"curvature", xmlNumber(piece.curvature)}});
      }
      begin += piece.length;
    }
  }

  static void addPolynomial(xml_node parent, const char* name, const char* at, double begin,
                            double value, double slope) {
    addElement(parent, name,
               {{at, xmlNumber(begin)},
                {"a", xmlNumber(value)},
                {"b", xmlNumber(slope)},
                {"c", "0"},
                {"d", "0"}});
  }

  /// Adds the piecewise linear function with these values at the knots of a road, between two arc
  /// lengths and relative to the first.
  static void addLinear(xml_node parent, const char* name, const char* at, const Road& road,
                        const std::vector<double>& values, double begin, double end) {
    for (std::size_t i = 0; i < road.knots.size(); ++i) {
      const bool is_last = i + 1 == road.knots.size();
      if (road.knots[i] >= end || (!is_last && road.knots[i + 1] <= begin)) continue;
      const double slope =
          is_last ? 0.0 : (values[i + 1] - values[i]) / (road.knots[i + 1] - road.knots[i]);
      const double from = std::max(begin, road.knots[i]);
      addPolynomial(parent, name, at, from - begin, values[i] + slope * (from - road.knots[i]),
                    slope);
    }
  }

  /// Returns the arc lengths at which lane sections begin: where lanes begin or end within the
  /// road, and where a width has changed so far that readers that take a section's first width for
  /// all of it (SUMO) would shift lanes.
  static std::vector<double> sectionsOf(const Road& road) {
    std::set<double> begins = {0.0};
    const double length = road.course.length();
    const auto add = [&](double at) {
      if (at > kShortestSection && at < length - kShortestSection) begins.insert(at);
    };
    std::size_t first = 0;
    for (std::size_t i = 1; i < road.knots.size(); ++i) {
      double change = 0.0;
      for (const auto* lanes : {&road.left, &road.right}) {
        for (const RoadLane& lane : *lanes) {
          change = std::max(change, std::abs(lane.width[i] - lane.width[first]));
        }
      }
      if (change <= kSectionChange) continue;
      add(road.knots[i]);
      first = i;
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

  void addLanes(xml_node lanes, const Road& road) const {
    const double length = road.course.length();
    addLinear(lanes, "laneOffset", "s", road, road.offset, 0.0, length);
    const std::vector<double> begins = sectionsOf(road);
    for (std::size_t i = 0; i < begins.size(); ++i) {
      const bool is_last = i + 1 == begins.size();
      const Section section{begins[i], is_last ? length : begins[i + 1], i == 0, is_last};
      xml_node node = addElement(lanes, "laneSection", {{"s", xmlNumber(section.begin)}});
      if (!road.left.empty()) {
        xml_node left = addElement(node, "left");
        for (auto lane = road.left.rbegin(); lane != road.left.rend(); ++lane) {
          addLane(left, road, *lane, section);
        }
      }
      xml_node centre = addElement(addElement(node, "center"), "lane",
                                   {{"id", "0"}, {"type", "none"}, {"level", "false"}});
      if (road.junction == 0) addMark(centre, "solid");
      if (road.right.empty()) continue;
      xml_node right = addElement(node, "right");
      for (const RoadLane& lane : road.right) addLane(right, road, lane, section);
    }
  }

  struct Section {
    double begin;  // m
    double end;
    bool is_first;
    bool is_last;
  };

  static bool isDrivenIn(const RoadLane& lane, const Section& section) {
    const double middle = 0.5 * (section.begin + section.end);
    return !lane.lane.empty() && lane.from <= middle && middle <= lane.to;
  }

  static void addLane(xml_node side, const Road& road, const RoadLane& lane,
                      const Section& section) {
    const bool is_driven = isDrivenIn(lane, section);
    xml_node node = addElement(side, "lane",
                               {{"id", std::to_string(lane.id)},
                                {"type", is_driven ? "driving" : "none"},
                                {"level", "false"}});
    xml_node link = addElement(node, "link");
    const auto addLink = [&](const char* name, bool is_outer, const std::optional<int>& outer) {
      const std::optional<int> id = is_outer ? outer : lane.id;
      if (id && !lane.lane.empty()) addElement(link, name, {{"id", std::to_string(*id)}});
    };
    addLink("predecessor", section.is_first, lane.before);
    addLink("successor", section.is_last, lane.after);
    addLinear(node, "width", "sOffset", road, lane.width, section.begin, section.end);
    if (road.junction == 0 && !lane.lane.empty()) {
      const std::vector<RoadLane>& lanes = lane.id < 0 ? road.right : road.left;
      const bool is_outermost = &lane == &lanes.back();
      addMark(node, is_outermost ? "solid" : "broken");
    }
    if (is_driven && lane.speed_limit && !commonLimit(road)) {
      addLimit(node, {{"sOffset", "0"}}, *lane.speed_limit);
    }
  }

  /// Returns the speed limit that all lanes of a road have.
  static std::optional<double> commonLimit(const Road& road) {
    std::set<std::optional<double>> limits;
    for (const auto* lanes : {&road.left, &road.right}) {
      for (const RoadLane& lane : *lanes) {
        if (!lane.lane.empty()) limits.insert(lane.speed_limit);
      }
    }
    return limits.size() == 1 ? *limits.begin() : std::nullopt;
  }

  static void addLimit(xml_node parent,
                       std::initializer_list<std::pair<const char*, std::string>> place,
                       double limit) {
    xml_node speed = addElement(parent, "speed", place);
    speed.append_attribute("max") = xmlNumber(limit).c_str();
    speed.append_attribute("unit") = "m/s";
  }

  static void addMark(xml_node lane, const char* type) {
    addElement(lane, "roadMark",
               {{"sOffset", "0"},
                {"type", type},
                {"weight", "standard"},
                {"color", "standard"},
                {"width", xmlNumber(kMarkWidth)}});
  }

  void addJunction(xml_node root, const Junction& junction) const {
    xml_node node = addElement(root, "junction",
                               {{"id", std::to_string(junction.id)},
                                {"name", "junction " + std::to_string(junction.id)},
                                {"type", "default"}});
    int number = 0;
    for (const Junction::Connection& one : junction.connections) {
      xml_node connection = addElement(node, "connection",
                                       {{"id", std::to_string(number++)},
                                        {"incomingRoad", std::to_string(one.incoming)},
                                        {"connectingRoad", std::to_string(one.connecting)},
                                        {"contactPoint", "start"}});
      addElement(connection, "laneLink",
                 {{"from", std::to_string(one.from)}, {"to", std::to_string(one.to)}});
    }
  }

  const CrashRecord& record_;
  const RoadNetwork network_;
  const Vector2 origin_;
  const bool is_left_;
  std::vector<Crosswalk> crosswalks_;
};

}  // namespace

Vector2 localOrigin(const CrashRecord& record) {
  const Vector2 begin = record.ego.states.front().pose.position();
  return {std::round(begin.x()), std::round(begin.y())};
}

OpenDriveFile openDriveFile(const CrashRecord& record, const ExportOptions& options) {
  const OpenDriveWriter writer(record, options);
  return {writer.text(), writer.unbundled()};
}

}  // namespace forge
