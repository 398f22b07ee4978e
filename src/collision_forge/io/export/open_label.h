#pragma once

#include <memory>
#include <set>
#include <string>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// Returns a writer of scenario tags in ASAM OpenLABEL 1.0.0 (chapter 8; openlabel_json_schema
/// 1.0.0): NAME.openlabel.json.
///
/// - Ontology "0", ASAM's openlabel_ontology_scenario_tags: asamTags(), and SubjectVehicleSpeed
/// with
///   the ego's speed at t0 (km/h). `boundary_list` names the tags that were looked for, so the
///   absence of one of them says that it does not apply.
/// - Ontology "1", collision_forge_names.ttl beside the files: a tag per entry of
///   ExportPlan::catalogue that the attack is an instance of, and the cell that was requested.
std::unique_ptr<CrashWriter> makeOpenLabelWriter(const ExportPlan& plan);

/// Returns the tags of a record: classes of the road users in it, behaviour of the attacker from
/// its manoeuvre and its turn, behaviour of the ego, and the place of the contact (intersection,
/// pedestrian crossing, side of the road on which traffic drives).
std::set<std::string> asamTags(const CrashRecord& record);

}  // namespace forge
