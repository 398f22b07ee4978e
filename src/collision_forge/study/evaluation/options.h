#pragma once

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Constants of the evaluation protocol of arXiv 2510.12206, as published.
struct PublishedOptions {
  BoxSize box = CollideOptions().box;  ///< m, of all vehicles
  double min_overlap = 0.02;   ///< intersection over union, 0..1, above which two boxes collide
  int steps_per_interval = 5;  ///< steps of the protocol per interval between two frames
  int steps_after = 20;        ///< steps from the last frame on, that frame included
  /// rad (10 degrees); a hit with a smaller heading error is similar.
  double similar_heading = 0.174532925;
};

/// The constants of evaluations; not read from files.
struct EvaluationOptions {
  CollideOptions collide;  ///< sizes and offsets for reading COLLIDE clips
  PublishedOptions published;
};

/// Config with the options of evaluations.
struct StudyOptions : Config {
  EvaluationOptions evaluation;
};

}  // namespace forge
