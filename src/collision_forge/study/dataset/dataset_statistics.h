#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// The properties of a kept clip that enter the statistics of a data set.
struct DatasetClip {
  std::string split;     ///< one of splitNames()
  std::string scene;     ///< name of the scene
  std::string location;  ///< name of the map
  CollisionType type = CollisionType::kRearEnd;
  int length = 0;                 ///< Attempt::length(), frame intervals from begin to impact
  double relative_heading = 0.0;  ///< rad (-pi, pi], attacker's yaw minus ego's at contact
  double off_road_share = 0.0;    ///< 0..1, mean share of the attacker's box off the drivable area
};

/// Counts of the attempts for one type.
struct Attempts {
  std::size_t tried = 0;  ///< requests tried
  std::size_t valid = 0;  ///< requests for which a clip was found, before balancing
};

/// Returns the text of statistics.csv, "group,value,train,val,test,all,share", with the numbers of
/// clips in each split and in all: one row per type (group "type", in the order of CollisionType),
/// then per TTA (group "tta", s from t0 to the impact, ascending), then per location (group
/// "location", in alphabetical order), and a last row "all,scenes" with the numbers of scenes.
/// Values without a clip have no row. `share` is the share of all clips, 0..1, empty for scenes.
/// Each line ends with "\n".
std::string datasetCsv(const std::vector<DatasetClip>& clips);

/// Returns the text of statistics.md: the tables of datasetCsv(), and for each type of
/// `attempts` the clips tried, valid and kept, and the mean |relative heading| (degrees) and
/// off-road share (%) of the kept ones (0 if none is kept).
std::string datasetMarkdown(const std::vector<DatasetClip>& clips,
                            const std::map<CollisionType, Attempts>& attempts);

}  // namespace forge
