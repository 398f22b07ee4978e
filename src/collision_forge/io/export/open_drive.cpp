#include "collision_forge/io/export/open_drive.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "collision_forge/io/export/open_drive_lanes.h"
#include "collision_forge/io/export/open_drive_objects.h"
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
        is_left_(record.lanes.driving_side == DrivingSide::kLeft),
        lanes_(record.lanes),
        objects_(record.lanes, network_) {}

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
    if (const auto limit = commonLimit(road)) addSpeedLimit(type, *limit);
    addCourse(node, road);
    lanes_.addLanes(addElement(node, "lanes"), road);
    objects_.addObjects(node, road);
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
  const LaneWriter lanes_;
  const ObjectWriter objects_;
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
