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
///   with the ego's speed at t0 (km/h, to 0.1). `boundary_list` names the tags that are looked for:
///   if one of them is absent, it does not apply.
/// - Ontology "1", collision_forge_names.ttl beside the files, which finish() writes: a tag per
///   entry of ExportPlan::catalogue that the attack is an instance of, and the cell that was
///   requested (SceneRequest::name, unless ""). An attack is an instance of an entry that can be
///   generated (CatalogueEntry::missing is ""), sets no `from_side`, has the type and `turning` of
///   the attack's request, and agrees with the attack in every set one of attacker class, manoeuvre
///   and ego side; the ranges of the entry do not count.
std::unique_ptr<CrashWriter> makeOpenLabelWriter(const ExportPlan& plan);

/// Returns the names of ASAM's tags that apply to a record: classes of the road users in it (the
/// ego is a car), behaviour of the attacker from its manoeuvre and its turn, behaviour of the ego,
/// and the place of the contact (intersection, pedestrian crossing), which is the attacker's box
/// centre, and the driving side. A vehicle turns if its heading changes by more than 0.6 rad from
/// t0 to the contact (without one, to the end of the record). SubjectVehicleSpeed is not among
/// them.
std::set<std::string> asamTags(const CrashRecord& record);

}  // namespace forge
