#include "collision_forge/scene/options.h"

#include "collision_forge/config/section.h"

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
}

static void readOptions(Section& section, TypeDefinition& definition) {
  definition.min_heading = section.angle("min_heading");
  definition.max_heading = section.angle("max_heading", definition.min_heading);
  definition.nominal_heading =
      section.within("nominal_heading", definition.min_heading, definition.max_heading);
  definition.min_approach = section.angle("min_approach");
  definition.max_approach = section.angle("max_approach", definition.min_approach);
}

void readOptions(Section& section, CrashDefinition& crash, double time_margin) {
  crash.rules = section.choice<TypeRules>(
      "rules", {{"full", TypeRules::kFull}, {"angle", TypeRules::kAngle}});
  crash.time_tolerance = section.atLeast("time_tolerance", time_margin);
  crash.min_confidence = section.share("min_confidence");
  crash.limits = section.choice<LimitSet>(
      "limits", {{"drivable", LimitSet::kDrivable}, {"strict", LimitSet::kStrict}});
  crash.believable = section.choice<bool>("believable", {{"true", true}, {"false", false}});
  Section types = section.section("types");
  for (const CollisionType type : kCollisionTypes) types.read(toString(type), crash.types[type]);
  types.finish();
}

}  // namespace forge
