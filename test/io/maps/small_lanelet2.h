#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Writes small Lanelet2 maps as OpenStreetMap files, with ids from 1 in the order of the calls.
class SmallLanelet2 {
 public:
  /// `local`: nodes have local_x and local_y in m, as Autoware writes; else lat and lon in degrees.
  explicit SmallLanelet2(bool local = true) : local_(local) {}

  std::string node(const Vector2& place) {
    const std::string id = next();
    const std::string x = std::to_string(place.x());
    const std::string y = std::to_string(place.y());
    text_ += "<node id='" + id + "' ";
    text_ += local_ ? "lat='0' lon='0'>" + tag("local_x", x) + tag("local_y", y) + tag("ele", "7")
                    : "lat='" + x + "' lon='" + y + "'>";
    text_ += "</node>\n";
    return id;
  }

  std::string way(const std::vector<std::string>& nodes, const std::string& tags = "") {
    const std::string id = next();
    text_ += "<way id='" + id + "'>";
    for (const std::string& node : nodes) text_ += "<nd ref='" + node + "'/>";
    text_ += tags + "</way>\n";
    return id;
  }

  /// A way through new nodes.
  std::string line(const std::vector<Vector2>& places, const std::string& tags = "") {
    std::vector<std::string> nodes;
    for (const Vector2& place : places) nodes.push_back(node(place));
    return way(nodes, tags);
  }

  std::string relation(const std::string& members, const std::string& tags) {
    const std::string id = next();
    text_ += "<relation id='" + id + "'>" + members + tags + "</relation>\n";
    return id;
  }

  std::string lanelet(const std::string& left, const std::string& right,
                      const std::string& subtype = "road", const std::string& tags = "") {
    return relation(member("left", left) + member("right", right),
                    tag("type", "lanelet") + tag("subtype", subtype) + tags);
  }

  static std::string tag(const std::string& key, const std::string& value) {
    return "<tag k='" + key + "' v='" + value + "'/>";
  }

  static std::string member(const std::string& role, const std::string& way) {
    return "<member type='way' role='" + role + "' ref='" + way + "'/>";
  }

  std::string text() const {
    return "<?xml version='1.0'?>\n<osm version='0.6' generator='test'>\n" + text_ + "</osm>\n";
  }

 private:
  std::string next() { return std::to_string(++last_); }

  bool local_;
  int last_ = 0;
  std::string text_;
};

}  // namespace forge
