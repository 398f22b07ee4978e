#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/export/options.h"
#include "collision_forge/io/export/road_course.h"
#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {

/// One crash for export: the motion of all vehicles on one clock that starts at 0 s, and the lanes
/// around. Global map frame, metres, radians. Poses are box centres.
///
/// Until contact the ego and the other agents are as recorded and the attacker follows its
/// trajectory. Support vehicles are among the other agents. After the contact, ego and attacker
/// move by PostCrashMotion; at the first step from the contact on, their boxes overlap by at least
/// 5 mm.
struct CrashRecord {
  std::string name;   ///< base name of the files: SCENE_LINE, as "scene-0061_17"
  Scenario scenario;  ///< request and result; times on the scene's clock
  double step = 0.0;  ///< s between states
  double now = 0.0;   ///< t0, s on the record's clock; a multiple of `step`
  /// s on the record's clock, contact time with the recorded ego; empty: no contact.
  std::optional<double> contact;
  Track ego;  ///< a state every step from 0 s to the end; its id is kEgoId
  /// A state every step from its first state after the last gap in its past; up to t0 its past,
  /// then its trajectory.
  Track attacker;
  /// Other agents that come within ExportOptions::radius of the ego's or the attacker's path,
  /// sorted by id; states at the steps at which they were in sight.
  std::vector<Track> other_agents;
  LaneMap lanes;  ///< map within the radius of both paths, and the lanes before and after each
                  ///< connector there; with the links among the lanes
  std::vector<TrafficLight> lights;  ///< lights of `lanes`, times on the record's clock
  LaneArcs arcs;                     ///< arcs of `lanes`; empty if the map has points only
  GeoPoint origin;                   ///< of the map frame; 0, 0 if unknown

  double end() const { return ego.states.back().time; }  ///< s, end of the record
};

/// Splits a track's states into stretches without a gap: a gap is an interval of more than 1.5
/// steps (`step` in s). Returns no stretch for a track without states.
std::vector<std::vector<AgentState>> splitAtGaps(const Track& track, double step);

/// Inputs of crashRecord() beside the scenario. The references must be valid during the call.
struct RecordContext {
  const IndexedScene& indexed;   ///< the recording of the scenario and its map
  const LaneArcs& arcs;          ///< arcs of the whole map, by lane id
  const ExportOptions& options;  ///< step, tail, radius and origins
  /// `overlap_tolerance` of the contact; `severity` for the motion after it.
  const VerificationOptions& verification;
};

/// Builds the record of an attack, from `history` s before t0 (or the ego's first state, if later;
/// rounded down to whole steps) to the first step not before ExportOptions::tail s after contact.
/// Without contact, the record ends at the last step within both the attacker's trajectory and the
/// ego's track. `line`: number of the attack in its file, from 1. `scenario` must have an attack.
/// Throws std::runtime_error if the scene's name has characters other than letters, digits, '-',
/// '_' and '.' or starts with '.', and if the ego is missing at t0 or at a step of the record.
CrashRecord crashRecord(const Scenario& scenario, std::size_t line, double history,
                        const RecordContext& context);

}  // namespace forge
