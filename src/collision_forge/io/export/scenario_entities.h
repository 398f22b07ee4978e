#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// An entity of an OpenSCENARIO file: a stretch of a track without a gap.
struct ScenarioEntity {
  std::string name;              ///< unique in the file, as "other_3_2"
  const Track* track = nullptr;  ///< of the record
  std::vector<AgentState> states;
  double axle_to_middle = 0.0;  ///< m, from the entity's origin forward to the box centre
};

/// Returns the entities of a record: "ego", "attacker", and "other_1" and so on, one per stretch in
/// sight; stretches of one state have no motion and are left out. The origin of a vehicle is the
/// middle of its rear axle, or the box centre with `plan.for_carla`. The entities refer to tracks
/// of `record`, which must outlive them.
std::vector<ScenarioEntity> scenarioEntities(const CrashRecord& record, const ExportPlan& plan);

/// Adds the element `ScenarioObject` of an entity of `record`.
void addScenarioObject(pugi::xml_node entities, const ScenarioEntity& entity,
                       const CrashRecord& record, const ExportPlan& plan);

/// Returns `text`, with "_" before a leading '$', which readers take for a parameter.
std::string literal(const std::string& text);

}  // namespace forge
