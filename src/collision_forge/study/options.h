#pragma once

#include <cstdint>

#include "collision_forge/data/options.h"
#include "collision_forge/geometry/oriented_box.h"

namespace forge {

// config/evaluation.yaml, where each number's unit and source stand.

struct PublishedOptions {
  BoxSize box;  ///< of CollideOptions
  double min_overlap = 0.0;
  int steps_per_interval = 0;
  int steps_after = 0;
  double similar_heading = 0.0;
};

struct NominalOptions {
  double end_distance = 0.0;
  double side_distance = 0.0;
  double lane_change_ahead = 0.0;
  double lane_change_side = 0.0;
  double lane_change_heading = 0.0;
};

struct PublishedSearchOptions {
  double heading_tolerance = 0.0;
  double latest = 0.0;
  double overlap_margin = 0.0;
  double max_lead = 0.0;
  double max_speed = 0.0;
  int kept = 0;
  int futures = 0;
};

struct StatisticsOptions {
  int resamples = 0;
  double confidence = 0.0;
  std::uint64_t seed = 0;
};

struct EvaluationOptions {
  CollideOptions collide;
  PublishedOptions published;
  NominalOptions nominal;
  PublishedSearchOptions published_search;
  StatisticsOptions statistics;
};

void readOptions(Section& section, EvaluationOptions& options);

}  // namespace forge
