#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

// config/evaluation.yaml, where each number's unit and source stand.

struct PublishedOptions {
  BoxSize box;  ///< of CollideOptions
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

/// The ends of the bands that are asked for, rising: each number but the last begins a band.
struct ControlOptions {
  std::vector<double> impact_speeds;
  std::vector<double> overlaps;
};

struct EvaluationOptions {
  CollideOptions collide;
  PublishedOptions published;
  PublishedSearchOptions published_search;
  ControlOptions controls;
};

/// What attacks are made by and judged by in a study.
struct StudyOptions : Config {
  EvaluationOptions evaluation;
};

void readOptions(Section& section, EvaluationOptions& options);

}  // namespace forge
