#include "collision_forge/attack/network/options.h"

#include <stdexcept>

#include "collision_forge/base/config/section.h"
#include "collision_forge/base/geometry/enum_words.h"

namespace forge {
namespace {

constexpr EnumWord<EgoHead> kHeadWords[] = {
    {EgoHead::kRegionProposal, "region_proposal"},
    {EgoHead::kTargetPoints, "target_points"},
    {EgoHead::kRegression, "regression"},
};

int countOf(Section& section, const char* key, int min = 1) {
  return section.count(key, min, kMaxFeatureCount);
}

double lengthOf(Section& section, const char* key) {
  return section.within(key, kMinFeatureNumber, kMaxFeatureLength);
}

}  // namespace

const char* toString(EgoHead head) { return wordOf(kHeadWords, head); }

EgoHead egoHeadFromString(const std::string& name) {
  if (const auto head = valueOf(kHeadWords, name)) return *head;
  throw std::invalid_argument("head = " + name +
                              " is none of region_proposal, target_points, regression");
}

void readOptions(Section& section, EncodingOptions& options) {
  options.lane_radius = lengthOf(section, "lane_radius");
  options.max_lanes = countOf(section, "max_lanes");
  options.lane_points = countOf(section, "lane_points", kMinPolylinePoints);
  options.lane_point_spacing = lengthOf(section, "lane_point_spacing");
}

void readOptions(Section& section, PatternFeatureOptions& options, int history_frames) {
  options.head = section.choice<EgoHead>("head", {{"region_proposal", EgoHead::kRegionProposal},
                                                  {"target_points", EgoHead::kTargetPoints},
                                                  {"regression", EgoHead::kRegression}});
  options.history_frames = history_frames;
  options.agent_frames = section.count("agent_frames", 1, options.history_frames);
  options.max_agents = countOf(section, "max_agents");
  readOptions(section, options.encoding);
  options.max_ways = countOf(section, "max_ways");
  options.way_anchors = countOf(section, "way_anchors", kMinWayAnchors);
  options.spacing_floor = lengthOf(section, "spacing_floor");
  options.spacing_rate = lengthOf(section, "spacing_rate");
  options.spacing_exponent =
      section.within("spacing_exponent", kMinFeatureNumber, kMaxSpacingExponent);
  options.target_lanes = countOf(section, "target_lanes");
  options.target_points = countOf(section, "target_points", kMinPolylinePoints);
  options.target_spacing = lengthOf(section, "target_spacing");
}

void readOptions(Section& section, PatternNetworkOptions& options) {
  options.hidden = section.count("hidden", 1, kMaxLayerWidth);
  options.scene = section.count("scene", 1, kMaxLayerWidth);
  options.anchor = section.count("anchor", 1, kMaxLayerWidth);
}

}  // namespace forge
