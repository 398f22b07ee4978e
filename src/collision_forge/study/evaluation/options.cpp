#include "collision_forge/study/evaluation/options.h"

#include <algorithm>

#include "collision_forge/base/config/section.h"

namespace forge {

static void readOptions(Section& section, PublishedOptions& options) {
  options.min_overlap = section.share("min_overlap");
  options.steps_per_interval = section.count("steps_per_interval", 1);
  options.steps_after = section.count("steps_after", 1);
  options.similar_heading = section.angle("similar_heading");
}

static void readOptions(Section& section, PublishedSearchOptions& options) {
  options.heading_tolerance = section.angle("heading_tolerance");
  options.latest = section.nonNegative("latest");
  options.overlap_margin = section.nonNegative("overlap_margin");
  options.max_lead = section.nonNegative("max_lead");
  options.max_speed = section.positive("max_speed");
  options.kept = section.count("kept", 1);
  options.futures = section.count("futures", 1);
}

static void readOptions(Section& section, ControlOptions& options) {
  options.impact_speeds = section.numbers("impact_speeds", 0.0, 100.0);
  if (!std::is_sorted(options.impact_speeds.begin(), options.impact_speeds.end())) {
    section.refuse("impact_speeds", "falls");
  }
  options.overlaps = section.risingShares("overlaps");
}

void readOptions(Section& section, EvaluationOptions& options) {
  section.read("collide", options.collide);
  section.read("published", options.published);
  options.published.box = options.collide.box;
  section.read("published_search", options.published_search);
  section.read("controls", options.controls);
}

}  // namespace forge
