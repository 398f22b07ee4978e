#include "collision_forge/io/maps/osm_file.h"

#include <GeographicLib/UTMUPS.hpp>
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>

#include "collision_forge/base/config/config_error.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/xml_input.h"

namespace forge {
namespace {

using pugi::xml_node;

bool isDeleted(const xml_node& element) {
  return std::strcmp(element.attribute("action").value(), "delete") == 0 ||
         std::strcmp(element.attribute("visible").value(), "false") == 0;
}

const char* tagText(const xml_node& element, const char* key) {
  return element.find_child_by_attribute("tag", "k", key).attribute("v").value();
}

bool hasLanelets(const xml_node& root) {
  const auto relations = root.children("relation");
  return std::any_of(relations.begin(), relations.end(), [](const xml_node& relation) {
    return std::strcmp(tagText(relation, "type"), "lanelet") == 0;
  });
}

OsmTags tagsIn(const xml_node& element) {
  OsmTags tags;
  for (const xml_node& tag : element.children("tag")) {
    tags[tag.attribute("k").value()] = tag.attribute("v").value();
  }
  return tags;
}

/// Projects latitudes and longitudes to UTM coordinates relative to an origin.
class UtmProjection {
 public:
  explicit UtmProjection(const GeoPoint& origin) {
    bool is_north = true;
    GeographicLib::UTMUPS::Forward(origin.latitude, origin.longitude, zone_, is_north, origin_.x(),
                                   origin_.y());
  }

  /// In the zone of the origin. Throws GeographicLib::GeographicErr for a point too far from it.
  Vector2 project(double latitude, double longitude) const {
    Vector2 place;
    int zone = 0;
    bool is_north = true;
    GeographicLib::UTMUPS::Forward(latitude, longitude, zone, is_north, place.x(), place.y(),
                                   zone_);
    return place - origin_;
  }

 private:
  int zone_ = 0;
  Vector2 origin_;
};

/// Returns the position of a node, nullopt if it has none.
class NodePlaces {
 public:
  NodePlaces(const xml_node& root, const std::string& path, const DataOptions& options) {
    for (const xml_node& node : root.children("node")) {
      if (!isDeleted(node) && local(node)) return;
    }
    const std::string location = std::filesystem::path(path).stem().string();
    const auto origin = options.origins.find(location);
    if (origin == options.origins.end()) {
      throw ConfigError(path +
                        ": the nodes have no tags local_x and local_y; add latitude and longitude "
                        "of the map frame's origin to export.yaml, under origins: " +
                        location + ": [LATITUDE, LONGITUDE]");
    }
    projection_.emplace(origin->second);
  }

  std::optional<Vector2> operator()(const xml_node& node) const {
    if (!projection_) return local(node);
    const auto latitude = finiteNumber(node.attribute("lat").value());
    const auto longitude = finiteNumber(node.attribute("lon").value());
    if (!latitude || !longitude) return std::nullopt;
    try {
      return projection_->project(*latitude, *longitude);
    } catch (const GeographicLib::GeographicErr&) {
      return std::nullopt;
    }
  }

 private:
  static std::optional<Vector2> local(const xml_node& node) {
    const auto x = finiteNumber(tagText(node, "local_x"));
    const auto y = finiteNumber(tagText(node, "local_y"));
    return x && y ? std::optional(Vector2(*x, *y)) : std::nullopt;
  }

  std::optional<UtmProjection> projection_;
};

void addNodes(const xml_node& root, const NodePlaces& places, const InputLimits& limits,
              OsmFile& file, WarningCounter& warnings) {
  for (const xml_node& node : root.children("node")) {
    if (isDeleted(node)) continue;
    const std::string id = node.attribute("id").value();
    const auto place = places(node);
    if (!place) {
      warnings.add("nodes without a usable position", id);
    } else if (!isWithin(*place, limits)) {
      warnings.add("nodes beyond max_coordinate of input_limits.yaml", id);
    } else {
      file.nodes[id] = *place;
    }
  }
}

}  // namespace

const std::string& tagOf(const OsmTags& tags, const std::string& key) {
  static const std::string kNone;
  const auto found = tags.find(key);
  return found == tags.end() ? kNone : found->second;
}

OsmFile readOsmFile(const std::string& path, const DataOptions& options, WarningCounter& warnings) {
  pugi::xml_document document;
  loadXml(path, document);
  const xml_node root = document.document_element();
  if (!hasLanelets(root)) {
    throw MapError(path +
                   ": is an OpenStreetMap file without relations of type lanelet, so it is not "
                   "a Lanelet2 map");
  }
  OsmFile file;
  addNodes(root, NodePlaces(root, path, options), options.input_limits, file, warnings);
  for (const xml_node& way : root.children("way")) {
    if (isDeleted(way)) continue;
    OsmWay& read = file.ways[way.attribute("id").value()];
    for (const xml_node& node : way.children("nd")) {
      read.nodes.emplace_back(node.attribute("ref").value());
    }
    read.tags = tagsIn(way);
  }
  for (const xml_node& relation : root.children("relation")) {
    if (isDeleted(relation)) continue;
    OsmRelation read{relation.attribute("id").value(), {}, tagsIn(relation)};
    for (const xml_node& member : relation.children("member")) {
      if (std::strcmp(member.attribute("type").value(), "way") != 0) continue;
      read.ways.emplace(member.attribute("role").value(), member.attribute("ref").value());
    }
    file.relations.push_back(std::move(read));
  }
  return file;
}

}  // namespace forge
