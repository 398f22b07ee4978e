#include "collision_forge/base/scene/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

void readOptions(Section& section, EgoVehicle& vehicle) {
  vehicle.size = {section.positive("length"), section.positive("width")};
  const double half_length = 0.5 * vehicle.size.length;
  vehicle.center_offset = section.within("center_offset", -half_length, half_length);
}

void readOptions(Section& section, LiveOptions& live) {
  live.max_scene_age = section.positive("max_scene_age");
  live.kept_for = section.nonNegative("kept_for");
  live.wait_for = section.nonNegative("wait_for");
  live.answer_within = section.positive("answer_within");
}

void readOptions(Section& section, InputLimits& limits) {
  limits.max_coordinate = section.positive("max_coordinate");
  limits.max_speed = section.positive("max_speed");
  limits.max_agents = section.count("max_agents", 1);
  limits.max_lanes = section.count("max_lanes", 1);
  limits.max_map_points = section.count("max_map_points", 1);
}

static void readOptions(Section& section, TypeDefinition& definition) {
  definition.min_heading = section.angle("min_heading");
  definition.max_heading = section.angle("max_heading", definition.min_heading);
  definition.nominal_heading =
      section.within("nominal_heading", definition.min_heading, definition.max_heading);
  if (!section.has("min_approach")) return;
  definition.min_approach = section.angle("min_approach");
  definition.max_approach = section.angle("max_approach", definition.min_approach);
}

void readOptions(Section& section, CrashDefinition& crash, double time_margin) {
  crash.rules = section.choice<TypeRules>(
      "rules", {{"full", TypeRules::kFull}, {"angle", TypeRules::kAngle}});
  crash.time_tolerance = section.within("time_tolerance", time_margin, kMaxTimeTolerance);
  crash.min_confidence = section.share("min_confidence");
  crash.limits = section.choice<LimitSet>(
      "limits", {{"drivable", LimitSet::kDrivable}, {"strict", LimitSet::kStrict}});
  crash.believable = section.choice<bool>("believable", {{"true", true}, {"false", false}});
  Section types = section.section("types");
  for (const CollisionType type : kAllCollisionTypes) types.read(toString(type), crash.types[type]);
  types.read("ltap_ego_turns", crash.ltap_ego_turns);
  types.finish();
}

}  // namespace forge
