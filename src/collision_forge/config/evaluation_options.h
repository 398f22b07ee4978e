#pragma once

#include <cstdint>

#include "collision_forge/geometry/oriented_box.h"

namespace forge {

// config/evaluation.yaml, where each number's unit and source stand.

struct CollideOptions {
  BoxSize box;
  double tail = 0.0;
  double held_out_share = 0.0;
};

struct PublishedOptions {
  BoxSize box;
  double min_overlap = 0.0;
  int steps_per_interval = 0;
  int steps_after = 0;
  double similar_heading = 0.0;
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
  PublishedSearchOptions published_search;
  StatisticsOptions statistics;
};

}  // namespace forge
