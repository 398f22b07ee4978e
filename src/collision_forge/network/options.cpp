#include "collision_forge/network/options.h"

#include <stdexcept>

#include "collision_forge/config/section.h"

namespace forge {

const char* toString(EgoHead head) {
  switch (head) {
    case EgoHead::kRegionProposal:
      return "region_proposal";
    case EgoHead::kTargetPoints:
      return "target_points";
    case EgoHead::kRegression:
      return "regression";
  }
  return "unknown";
}

EgoHead egoHeadFromString(const std::string& name) {
  for (const EgoHead head :
       {EgoHead::kRegionProposal, EgoHead::kTargetPoints, EgoHead::kRegression}) {
    if (name == toString(head)) return head;
  }
  throw std::invalid_argument("head = " + name +
                              " is none of region_proposal, target_points, regression");
}

void readOptions(Section& section, EncodingOptions& options) {
  options.lane_radius = section.positive("lane_radius");
  options.max_lanes = section.count("max_lanes", 1);
  options.lane_points = section.count("lane_points", 2);
  options.lane_point_spacing = section.positive("lane_point_spacing");
}

void readOptions(Section& section, PatternFeatureOptions& options, int history_frames) {
  options.head = section.choice<EgoHead>("head", {{"region_proposal", EgoHead::kRegionProposal},
                                                  {"target_points", EgoHead::kTargetPoints},
                                                  {"regression", EgoHead::kRegression}});
  options.history_frames = history_frames;
  options.agent_frames = section.count("agent_frames", 1, options.history_frames);
  options.max_agents = section.count("max_agents", 1);
  readOptions(section, options.encoding);
  options.max_ways = section.count("max_ways", 1);
  options.way_anchors = section.count("way_anchors", 3);
  options.spacing_floor = section.positive("spacing_floor");
  options.spacing_rate = section.positive("spacing_rate");
  options.spacing_exponent = section.positive("spacing_exponent");
  options.target_lanes = section.count("target_lanes", 1);
  options.target_points = section.count("target_points", 2);
  options.target_spacing = section.positive("target_spacing");
}

void readOptions(Section& section, PatternNetworkOptions& options) {
  options.hidden = section.count("hidden", 1);
  options.scene = section.count("scene", 1);
  options.anchor = section.count("anchor", 1);
}

}  // namespace forge
