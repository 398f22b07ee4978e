#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Constants of the evaluation protocol of arXiv 2510.12206, as published.
struct PublishedOptions {
  BoxSize box = CollideOptions().box;    ///< m, of all vehicles
  double min_overlap = 0.02;             ///< intersection over union above which two boxes collide
  int steps_per_interval = 5;            ///< steps between two frames
  int steps_after = 20;                  ///< steps from the last frame on, that frame included
  double similar_heading = 0.174532925;  ///< rad (10 degrees), heading error of similar crashes
};

/// Options of the attack search with the objective of the published protocol, without vehicle
/// limits; tuned for the rates in docs/results.md.
struct PublishedSearchOptions {
  double heading_tolerance = 0.12;  ///< rad about the data set's heading, below `similar_heading`
  double latest = 1.0;           ///< s, latest contact after t0 + TTA; any earlier one is allowed
  double overlap_margin = 0.15;  ///< m, as SearchOptions::overlap_margin, to exceed `min_overlap`
  double max_lead = 1.0;    ///< s, maximum straight motion before the contact, in half of the draws
  double max_speed = 40.0;  ///< m/s, of candidates
  int kept = 80;            ///< number of best attacks that are scored by the protocol itself
  int futures = 32;         ///< number of predicted ego futures for that score
};

/// config/study/evaluation.yaml, section controls: the limits of the bands to request, ascending;
/// each pair of successive numbers is a band.
struct ControlOptions {
  std::vector<double> impact_speeds;  ///< m/s
  std::vector<double> overlaps;       ///< share 0..1 of the ego's hit side
};

/// The options of evaluations; only `controls` is read from a file.
struct EvaluationOptions {
  CollideOptions collide;
  PublishedOptions published;
  PublishedSearchOptions published_search;
  ControlOptions controls;
};

/// The configuration of the product with the options of evaluations.
struct StudyOptions : Config {
  EvaluationOptions evaluation;
};

/// Reads the section `evaluation` of evaluation.yaml. Throws ConfigError.
void readOptions(Section& section, EvaluationOptions& options);

}  // namespace forge
