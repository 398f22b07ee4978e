#pragma once

#include <map>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

class Section;

/// Limits of the composition of a data set.
struct BalanceOptions {
  double min_type_share = 0.0;  ///< minimum share 0..1 of the clips for each type
  double max_tta_ratio = 0.0;   ///< within a type: maximum number of clips of one length over the
                                ///< mean number per length
};

/// Shares (0..1) of the scenes in the splits train and val; the rest is the test split.
struct SplitOptions {
  double train_share = 0.0;  ///< share of split "train"
  double val_share = 0.0;    ///< share of split "val"; both sum to 1 at most
};

/// config/study/dataset.yaml, which documents the source of each value.
struct DatasetOptions {
  double begin_stride = 0.0;   ///< s between the begins of clips of one scene
  double min_length = 0.0;     ///< s from begin to impact
  double max_length = 0.0;     ///< s from begin to impact
  double min_ego_speed = 0.0;  ///< m/s at t0; begins with a slower ego are skipped
  AttackerChoice choice = AttackerChoice::kAny;  ///< vehicles that may be the attacker
  std::map<CollisionType, int> attempts;  ///< number of lengths tried per begin, for each type
  double heading_spread = 0.0;            ///< rad to either side of the drawn relative heading
  double time_tolerance = 0.0;            ///< s, largest |contact time - (t0 + TTA)|
  double max_off_road_share = 0.0;  ///< 0..1, largest mean share of the attacker's box off the
                                    ///< drivable area from t0 to contact
  BalanceOptions balance;           ///< balance of types and lengths
  SplitOptions split;               ///< shares of the splits
};

/// Reads the section `dataset`. `time_margin` is SearchOptions::time_margin, the lower limit of
/// `time_tolerance` (s). Throws ConfigError.
void readOptions(Section& section, DatasetOptions& options, double time_margin);

}  // namespace forge
