#include "collision_forge/io/logs/nuscenes_map_layers.h"

#include <cmath>
#include <optional>
#include <unordered_set>
#include <utility>

#include "collision_forge/io/logs/nuscenes_json.h"
#include "collision_forge/io/logs/nuscenes_map_document.h"

namespace forge {
namespace {

using Ring = std::vector<Vector2>;

constexpr double kSmallestArea = 1e-6;  // square metres

double signedArea(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - ring[0];
    const Vector2 b = ring[(i + 1) % ring.size()] - ring[0];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * twice;
}

/// Converts a file's layers to NuScenesMapLayers.
class LayerReader {
 public:
  LayerReader(const std::string& path, const InputLimits& limits, WarningCounter& warnings)
      : path_(path), document_(path), limits_(limits), warnings_(warnings) {}

  NuScenesMapLayers read() {
    readPolygons();
    readLanes("lane", false);
    readLanes("lane_connector", true);
    readAreas();
    readConnectivity();
    readArclines();
    return std::move(layers_);
  }

 private:
  using Nodes = std::unordered_map<std::string, Vector2>;

  Nodes readNodes() const {
    Nodes nodes;
    for (const MapRow& row : document_.rows("node")) {
      nodes[row.token] = {document_.number(row, "x"), document_.number(row, "y")};
    }
    return nodes;
  }

  /// Returns an open ring without repeated nodes; empty if the nodes do not enclose an area.
  Ring ringOf(const Nodes& nodes, const std::vector<std::string>& tokens) const {
    Ring ring;
    for (const std::string& token : tokens) {
      const auto node = nodes.find(token);
      if (node == nodes.end() || !isWithin(node->second, limits_)) return {};
      if (ring.empty() || ring.back() != node->second) ring.push_back(node->second);
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3 || std::abs(signedArea(ring)) < kSmallestArea) return {};
    return ring;
  }

  void readPolygons() {
    const Nodes nodes = readNodes();
    for (const MapRow& row : document_.rows("polygon")) {
      Polygon polygon;
      polygon.exterior = ringOf(nodes, document_.texts(row, "exterior_node_tokens"));
      const MapRow holes{document_.field(row, "holes"), row.layer, row.token};
      for (const MapRow& hole : document_.elements(holes, "holes")) {
        Ring ring = ringOf(nodes, document_.texts(hole, "node_tokens"));
        if (ring.empty()) {
          warnings_.add("degenerate holes of polygons", row.token);
        } else {
          polygon.holes.push_back(std::move(ring));
        }
      }
      if (polygon.exterior.empty()) {
        warnings_.add("degenerate polygons", row.token);
      } else {
        layers_.polygons[row.token] = std::move(polygon);
      }
    }
  }

  void readLanes(const char* layer, bool is_connector) {
    for (const MapRow& row : document_.rows(layer)) {
      if (!lane_tokens_.insert(row.token).second) {
        throw NuScenesError(path_ + ": " + layer + ": token " + row.token +
                            ": field token is a duplicate");
      }
      const auto polygon = row.value.FindMember("polygon_token");
      const bool has_polygon = polygon != row.value.MemberEnd() && !polygon->value.IsNull();
      layers_.lanes.push_back(
          {row.token, has_polygon ? document_.text(row, "polygon_token") : "", is_connector});
    }
  }

  void readAreas() {
    for (const MapRow& row : document_.rows("drivable_area")) {
      const std::vector<std::string> polygons = document_.texts(row, "polygon_tokens");
      layers_.drivable_area.insert(layers_.drivable_area.end(), polygons.begin(), polygons.end());
    }
    for (const MapRow& row : document_.rows("walkway")) {
      layers_.walkways.push_back(document_.text(row, "polygon_token"));
    }
    for (const MapRow& row : document_.rows("road_segment")) {
      if (!document_.flag(row, "is_intersection")) continue;
      layers_.intersections.push_back(document_.text(row, "polygon_token"));
    }
  }

  void readConnectivity() {
    for (const MapRow& entry : document_.entries("connectivity")) {
      layers_.connectivity.push_back(
          {entry.token, document_.texts(entry, "incoming"), document_.texts(entry, "outgoing")});
    }
  }

  /// Returns nullopt for an arc beyond the limits, of unknown shape or of negative length.
  std::optional<ArcPath> arcOf(const MapRow& row) const {
    const std::vector<double> start = document_.numbers(row, "start_pose", 3);
    const std::vector<double> lengths = document_.numbers(row, "segment_length", 3);
    const std::string shape = document_.text(row, "shape");
    ArcPath path;
    path.start = {start[0], start[1], start[2]};
    path.radius = document_.number(row, "radius");
    const bool has_radius = std::isfinite(path.radius) && path.radius >= limits_.min_radius;
    const bool has_shape =
        shape.size() == path.shape.size() && shape.find_first_not_of("LSR") == std::string::npos;
    if (!isWithin(path.start, limits_) || !has_radius || !has_shape) return std::nullopt;
    for (std::size_t i = 0; i < path.shape.size(); ++i) {
      if (!(lengths[i] >= 0.0 && lengths[i] <= limits_.max_coordinate)) return std::nullopt;
      path.shape[i] = shape[i];
      path.segment_length[i] = lengths[i];
    }
    return path;
  }

  /// One unusable arc drops the lane's whole line: a part of it would end where no lane ends.
  void readArclines() {
    for (const MapRow& entry : document_.entries("arcline_path_3")) {
      std::vector<ArcPath> paths;
      bool is_usable = true;
      for (const MapRow& row : document_.elements(entry, "arcs")) {
        const std::optional<ArcPath> path = arcOf(row);
        is_usable = is_usable && path.has_value();
        if (path && path->length() > 0.0) paths.push_back(*path);
      }
      if (!is_usable) {
        warnings_.add("unusable arclines (number out of range, or unknown shape)", entry.token);
      } else if (!paths.empty()) {
        layers_.arclines[entry.token] = std::move(paths);
      }
    }
  }

  std::string path_;
  NuScenesMapDocument document_;
  const InputLimits& limits_;
  WarningCounter& warnings_;
  std::unordered_set<std::string> lane_tokens_;
  NuScenesMapLayers layers_;
};

}  // namespace

void WarningCounter::add(const std::string& kind, const std::string& token) {
  Cases& cases = cases_[kind];
  if (cases.count++ == 0) cases.first = token;
}

std::vector<std::string> WarningCounter::lines(const std::string& path) const {
  std::vector<std::string> lines;
  for (const auto& [kind, cases] : cases_) {
    std::string line = path + ": " + std::to_string(cases.count);
    line.append(" ").append(kind).append(" (first: ").append(cases.first).append(")");
    lines.push_back(std::move(line));
  }
  return lines;
}

NuScenesMapLayers readNuScenesMapLayers(const std::string& path, const InputLimits& limits,
                                        WarningCounter& warnings) {
  return LayerReader(path, limits, warnings).read();
}

}  // namespace forge
