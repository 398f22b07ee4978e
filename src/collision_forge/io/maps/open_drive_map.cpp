#include "collision_forge/io/maps/open_drive_map.h"

#include <cstdlib>
#include <cstring>
#include <utility>

#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/open_drive_lanes.h"
#include "collision_forge/io/maps/xml_input.h"

namespace forge {
namespace {

using pugi::xml_node;

void checkVersion(const xml_node& header, const std::string& path) {
  const std::string major = header.attribute("revMajor").value();
  if (major == "1") return;
  throw MapError(path + ": <header>: attribute revMajor is \"" + major +
                 "\"; OpenDRIVE 1.4 to 1.8 can be read");
}

/// Returns the pose of the file's origin in the map (ASAM OpenDRIVE 1.8, Sec. 8.5).
Pose2 originIn(const xml_node& header, const std::string& path) {
  const xml_node offset = header.child("offset");
  if (!offset) return {};
  const double yaw = offset.attribute("hdg") ? numberIn(offset, "hdg", path) : 0.0;
  return {numberIn(offset, "x", path), numberIn(offset, "y", path), wrapAngle(yaw)};
}

std::vector<OpenDriveConnection> connectionsOf(const xml_node& junction) {
  std::vector<OpenDriveConnection> connections;
  for (const xml_node& node : junction.children("connection")) {
    OpenDriveConnection connection;
    connection.junction = junction.attribute("id").value();
    connection.incoming = node.attribute("incomingRoad").value();
    const bool is_direct = node.attribute("linkedRoad");
    connection.connecting = node.attribute(is_direct ? "linkedRoad" : "connectingRoad").value();
    connection.at_end = std::strcmp(node.attribute("contactPoint").value(), "end") == 0;
    for (const xml_node& link : node.children("laneLink")) {
      connection.lanes.emplace_back(link.attribute("from").as_int(), link.attribute("to").as_int());
    }
    connections.push_back(std::move(connection));
  }
  return connections;
}

OpenDriveNetwork networkIn(const xml_node& root, const Pose2& origin, const InputLimits& limits,
                           const std::string& path, WarningCounter& warnings) {
  OpenDriveNetwork network;
  network.path = path;
  for (const xml_node& road : root.children("road")) {
    try {
      network.roads.push_back(readOpenDriveRoad(road, origin, limits, path));
    } catch (const MapError& error) {
      warnings.add("roads that cannot be used",
                   std::string(road.attribute("id").value()) + ": " +
                       std::string(error.what()).substr(path.size() + 2));
    }
  }
  for (const xml_node& junction : root.children("junction")) {
    for (OpenDriveConnection& connection : connectionsOf(junction)) {
      network.connections.push_back(std::move(connection));
    }
  }
  return network;
}

}  // namespace

LaneMap readOpenDriveMap(const std::string& path, const DataOptions& options,
                         std::vector<std::string>& warnings) {
  pugi::xml_document document;
  loadXml(path, document);
  const xml_node root = document.document_element();
  const xml_node header = root.child("header");
  checkVersion(header, path);
  WarningCounter counter;
  const OpenDriveNetwork network =
      networkIn(root, originIn(header, path), options.input_limits, path, counter);
  LaneMap map =
      laneMapOf(network, options.conversion.centerline_resolution, options.input_limits, counter);
  for (std::string& line : counter.lines(path)) warnings.push_back(std::move(line));
  return map;
}

}  // namespace forge
