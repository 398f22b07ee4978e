#include "collision_forge/io/export/open_drive.h"

#include <Eigen/Geometry>
#include <cmath>

#include "collision_forge/io/export/road_network.h"
#include "collision_forge/io/export/xml.h"

namespace forge {
namespace {

using pugi::xml_node;

/// Writes one network.
class OpenDriveWriter {
 public:
  OpenDriveWriter(const CrashRecord& record, const ExportOptions& options)
      : record_(record),
        network_(roadNetwork(record.lanes, record.arcs, options.lane_width)),
        origin_(localOrigin(record)),
        is_left_(record.lanes.driving_side == DrivingSide::kLeft) {}

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
  std::string laneId() const { return is_left_ ? "1" : "-1"; }

  void addHeader(xml_node root) const {
    Eigen::AlignedBox2d box(Vector2(0.0, 0.0));
    for (const Road& road : network_.roads) {
      for (const RoadPiece& piece : road.course) box.extend(piece.start.position() - origin_);
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
                                   " +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs";
    addElement(header, "geoReference").append_child(pugi::node_cdata).set_value(projection.c_str());
    addElement(
        header, "offset",
        {{"x", xmlNumber(origin_.x())}, {"y", xmlNumber(origin_.y())}, {"z", "0"}, {"hdg", "0"}});
  }

  void addRoad(xml_node root, const Road& road) const {
    xml_node node = addElement(root, "road",
                               {{"name", road.lane},
                                {"length", xmlNumber(road.length())},
                                {"id", std::to_string(road.id)},
                                {"junction", std::to_string(road.junction ? road.junction : -1)},
                                {"rule", is_left_ ? "LHT" : "RHT"}});
    xml_node link = addElement(node, "link");
    addJoint(link, "predecessor", road.before, "end");
    addJoint(link, "successor", road.after, "start");
    xml_node type = addElement(node, "type", {{"s", "0"}, {"type", "town"}});
    if (road.speed_limit) {
      addElement(type, "speed", {{"max", xmlNumber(*road.speed_limit)}, {"unit", "m/s"}});
    }
    addCourse(node, road);
    addLane(node, road);
  }

  static void addJoint(xml_node link, const char* name, const RoadJoint& joint,
                       const char* contact) {
    if (joint.to == RoadJoint::To::kNothing) return;
    const bool is_road = joint.to == RoadJoint::To::kRoad;
    xml_node node = addElement(
        link, name,
        {{"elementType", is_road ? "road" : "junction"}, {"elementId", std::to_string(joint.id)}});
    if (is_road) node.append_attribute("contactPoint") = contact;
  }

  void addCourse(xml_node road_node, const Road& road) const {
    xml_node plan = addElement(road_node, "planView");
    double begin = 0.0;
    for (const RoadPiece& piece : road.course) {
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

  /// The reference line is the centre of the only lane.
  void addLane(xml_node road_node, const Road& road) const {
    xml_node lanes = addElement(road_node, "lanes");
    const auto addPolynomial = [](xml_node parent, const char* name, const char* at, double value) {
      addElement(parent, name,
                 {{at, "0"}, {"a", xmlNumber(value)}, {"b", "0"}, {"c", "0"}, {"d", "0"}});
    };
    addPolynomial(lanes, "laneOffset", "s", (is_left_ ? -0.5 : 0.5) * road.width);
    xml_node section = addElement(lanes, "laneSection", {{"s", "0"}});
    xml_node left = is_left_ ? addElement(section, "left") : xml_node();
    addElement(addElement(section, "center"), "lane",
               {{"id", "0"}, {"type", "none"}, {"level", "false"}});
    xml_node lane = addElement(is_left_ ? left : addElement(section, "right"), "lane",
                               {{"id", laneId()}, {"type", "driving"}, {"level", "false"}});
    xml_node link = addElement(lane, "link");
    if (road.before.to == RoadJoint::To::kRoad) addElement(link, "predecessor", {{"id", laneId()}});
    if (road.after.to == RoadJoint::To::kRoad) addElement(link, "successor", {{"id", laneId()}});
    addPolynomial(lane, "width", "sOffset", road.width);
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
      addElement(connection, "laneLink", {{"from", laneId()}, {"to", laneId()}});
    }
  }

  const CrashRecord& record_;
  const RoadNetwork network_;
  const Vector2 origin_;
  const bool is_left_;
};

}  // namespace

Vector2 localOrigin(const CrashRecord& record) {
  const Vector2 begin = record.ego.states.front().pose.position();
  return {std::round(begin.x()), std::round(begin.y())};
}

std::string openDriveText(const CrashRecord& record, const ExportOptions& options) {
  return OpenDriveWriter(record, options).text();
}

}  // namespace forge
