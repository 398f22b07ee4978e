#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision_forge/base/geometry/arc_path.h"
#include "collision_forge/base/geometry/polygon.h"
#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Counts the cases of each kind of defect and keeps the first token of each.
class WarningCounter {
 public:
  /// Adds a case; `kind` is a plural noun phrase, as "degenerate polygons".
  void add(const std::string& kind, const std::string& token);
  /// Returns one line per kind, sorted by kind, as "PATH: 12 lanes without a usable arcline (first:
  /// TOKEN)". `path`: the file's, for the lines.
  std::vector<std::string> lines(const std::string& path) const;

 private:
  struct Cases {
    int count = 0;      ///< number of cases
    std::string first;  ///< token of the first case
  };
  std::map<std::string, Cases> cases_;  ///< by kind
};

/// The layers of a map expansion file from which a LaneMap is built, as in the file: map frame,
/// metres. Tokens may refer to rows that do not exist.
struct NuScenesMapLayers {
  struct Lane {
    std::string token;          ///< id of the lane
    std::string polygon_token;  ///< "" if the row has none
    bool is_connector = false;
  };
  /// Links of one lane.
  struct Links {
    std::string lane;                   ///< token of the lane or connector
    std::vector<std::string> incoming;  ///< tokens of predecessors
    std::vector<std::string> outgoing;  ///< tokens of successors
  };

  std::vector<Lane> lanes;                            ///< lanes, then connectors
  std::unordered_map<std::string, Polygon> polygons;  ///< usable ones only, by token
  /// polygon tokens, also of the layer carpark_area, if there is one; "": an unusable one
  std::vector<std::string> drivable_area;
  std::vector<std::string> walkways;       ///< polygon tokens
  std::vector<std::string> intersections;  ///< polygon tokens of road segments
  std::vector<Links> connectivity;         ///< in the file's order
  /// Usable ones only, by token of the lane; each is a centreline in driving direction.
  std::unordered_map<std::string, std::vector<ArcPath>> arclines;
};

/// Reads the layers of the file `path`; adds defects to `warnings`. Throws NuScenesError as
/// readNuScenesMap().
NuScenesMapLayers readNuScenesMapLayers(const std::string& path, const InputLimits& limits,
                                        WarningCounter& warnings);

}  // namespace forge
