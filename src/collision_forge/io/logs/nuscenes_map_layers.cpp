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

  /// Calls `read` with each row; a row that cannot be used costs that row alone.
  template <typename Read>
  void eachRow(const std::vector<MapRow>& rows, const Read& read) {
    for (const MapRow& row : rows) {
      try {
        read(row);
      } catch (const NuScenesError& error) {
        const std::string place = path_ + ": " + row.layer + ": token ";
        warnings_.add(std::string("rows of ") + row.layer + " that cannot be used",
                      std::string(error.what()).substr(place.size()));
      }
    }
  }

  Nodes readNodes() {
    Nodes nodes;
    eachRow(document_.rows("node"), [&](const MapRow& row) {
      nodes[document_.text(row, "token")] = {document_.number(row, "x"),
                                             document_.number(row, "y")};
    });
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
    eachRow(document_.rows("polygon"), [&](const MapRow& row) {
      const std::string token = document_.text(row, "token");
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
        layers_.polygons[token] = std::move(polygon);
      }
    });
  }

  void readLanes(const char* layer, bool is_connector) {
    eachRow(document_.rows(layer), [&](const MapRow& row) {
      const std::string token = document_.text(row, "token");
      if (!lane_tokens_.insert(token).second) {
        throw NuScenesError(path_ + ": " + layer + ": token " + token +
                            ": field token is a duplicate");
      }
      const auto polygon = row.value.FindMember("polygon_token");
      const bool has_polygon = polygon != row.value.MemberEnd() && !polygon->value.IsNull();
      layers_.lanes.push_back(
          {token, has_polygon ? document_.text(row, "polygon_token") : "", is_connector});
    });
  }

  void readAreas() {
    eachRow(document_.rows("drivable_area"), [&](const MapRow& row) {
      const MapRow polygons{document_.field(row, "polygon_tokens"), row.layer, row.token};
      for (const MapRow& polygon : document_.elements(polygons, "polygon_tokens")) {
        // An area has hundreds of polygons: a token that is none costs one of them.
        const bool is_token = polygon.value.IsString();
        layers_.drivable_area.emplace_back(is_token ? polygon.value.GetString() : "");
      }
    });
    if (document_.has("carpark_area")) {
      eachRow(document_.rows("carpark_area"), [&](const MapRow& row) {
        layers_.drivable_area.push_back(document_.text(row, "polygon_token"));
      });
    }
    eachRow(document_.rows("walkway"), [&](const MapRow& row) {
      layers_.walkways.push_back(document_.text(row, "polygon_token"));
    });
    eachRow(document_.rows("road_segment"), [&](const MapRow& row) {
      if (!document_.flag(row, "is_intersection")) return;
      layers_.intersections.push_back(document_.text(row, "polygon_token"));
    });
  }

  void readConnectivity() {
    eachRow(document_.entries("connectivity"), [&](const MapRow& entry) {
      layers_.connectivity.push_back(
          {entry.token, document_.texts(entry, "incoming"), document_.texts(entry, "outgoing")});
    });
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
    eachRow(document_.entries("arcline_path_3"), [&](const MapRow& entry) {
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
    });
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
