#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// The protocol of arXiv 2510.12206, as published.
struct PublishedOptions {
  BoxSize box = CollideOptions().box;
  double min_overlap = 0.02;   ///< shared over joint area above which two boxes collide
  int steps_per_interval = 5;  ///< that the interval between two frames is cut into
  int steps_after = 20;        ///< of the same length after the last frame, that frame included
  double similar_heading = 0.174532925;  ///< rad (10 degrees); below it a crash is similar
};

/// The attack search on what the published protocol counts, limits off; chosen by the rates of
/// docs/results.md.
struct PublishedSearchOptions {
  double heading_tolerance = 0.12;  ///< rad about the set's heading, less than `similar_heading`
  double latest = 1.0;              ///< s after the time asked for; contact may come at any before
  double overlap_margin = 0.15;     ///< m, as of SearchOptions, for `min_overlap`
  double max_lead = 1.0;    ///< s straight on before the contact, at most, in half the draws
  double max_speed = 40.0;  ///< m/s of what is tried
  int kept = 80;            ///< best attacks that are judged by the protocol itself ...
  int futures = 32;         ///< ... in as many of the ego's futures
};

/// config/study/evaluation.yaml, section controls: the ends of the bands that are asked for,
/// rising. Each number but the last begins a band.
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
