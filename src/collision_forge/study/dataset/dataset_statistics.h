#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// What the statistics of a data set know of a clip that was kept.
struct DatasetClip {
  std::string split;
  std::string scene;
  std::string location;  ///< name of the map
  CollisionType type = CollisionType::kRearEnd;
  int length = 0;                 ///< frames from begin to impact
  double relative_heading = 0.0;  ///< rad, attacker's to ego's at first contact
  double off_road_share = 0.0;    ///< [0, 1]
};

/// What became of the clips that were tried of a type.
struct Attempts {
  std::size_t tried = 0;
  std::size_t valid = 0;  ///< before balancing
};

/// "group,value,train,val,test,all,share": rows of types, times to accident (from now), locations
/// and scenes (how many), ending each; share is that of all clips, empty for scenes.
std::string datasetCsv(const std::vector<DatasetClip>& clips);

/// The same as tables in Markdown, and of every type: clips tried, valid, kept, and of the kept
/// ones mean |relative heading| in degrees and mean share off the road in percent.
std::string datasetMarkdown(const std::vector<DatasetClip>& clips,
                            const std::map<CollisionType, Attempts>& attempts);

}  // namespace forge
