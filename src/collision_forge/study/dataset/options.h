#pragma once

#include <map>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

class Section;

/// How many clips of every kind a data set may have.
struct BalanceOptions {
  double min_type_share = 0.0;
  double max_tta_ratio = 0.0;
};

/// Shares of the scenes; what is left is the test split.
struct SplitOptions {
  double train_share = 0.0;
  double val_share = 0.0;
};

/// config/study/dataset.yaml, where the unit and source of each of its keys stand.
struct DatasetOptions {
  double begin_stride = 0.0;
  double min_length = 0.0;
  double max_length = 0.0;
  double min_ego_speed = 0.0;
  AttackerChoice choice = AttackerChoice::kAny;
  std::map<CollisionType, int> attempts;
  double heading_spread = 0.0;
  double time_tolerance = 0.0;
  double max_off_road_share = 0.0;
  BalanceOptions balance;
  SplitOptions split;
  int sheet_columns = 4;  ///< pictures side by side on the sheet of a type: as many as can be seen
  int sheet_rows = 3;
};

/// `time_margin` is that of SearchOptions, which attacks keep to the ends of every time tolerance.
void readOptions(Section& section, DatasetOptions& options, double time_margin);

}  // namespace forge
