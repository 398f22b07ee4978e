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
  /// Returns one line per kind, as "PATH: 12 lanes without a usable arcline (first: TOKEN)".
  std::vector<std::string> lines(const std::string& path) const;

 private:
  struct Cases {
    int count = 0;
    std::string first;
  };
  std::map<std::string, Cases> cases_;
};

/// The layers of a map expansion file from which a LaneMap is built, as in the file.
struct NuScenesMapLayers {
  struct Lane {
    std::string token;
    std::string polygon_token;  ///< "" if the row has none
    bool is_connector = false;
  };
  struct Links {
    std::string lane;
    std::vector<std::string> incoming;
    std::vector<std::string> outgoing;
  };

  std::vector<Lane> lanes;                            ///< lanes, then connectors
  std::unordered_map<std::string, Polygon> polygons;  ///< usable ones only
  std::vector<std::string> drivable_area;             ///< polygon tokens
  std::vector<std::string> walkways;                  ///< polygon tokens
  std::vector<std::string> intersections;             ///< polygon tokens of road segments
  std::vector<Links> connectivity;                    ///< in the file's order
  std::unordered_map<std::string, std::vector<ArcPath>> arclines;  ///< usable ones only
};

/// Reads the layers of a file; adds defects to `warnings`. Throws NuScenesError as
/// readNuScenesMap().
NuScenesMapLayers readNuScenesMapLayers(const std::string& path, const InputLimits& limits,
                                        WarningCounter& warnings);

}  // namespace forge
