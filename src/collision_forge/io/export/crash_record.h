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
/// trajectory. After it, ego and attacker move by PostCrashMotion; at the first step from the
/// contact on, their boxes overlap by at least 5 mm.
struct CrashRecord {
  std::string name;               ///< base name of the files, as "scene-0061_17"
  Scenario scenario;              ///< request and result; times on the scene's clock
  double step = 0.0;              ///< s between states
  double now = 0.0;               ///< t0, s; a multiple of `step`
  std::optional<double> contact;  ///< s, contact time with the recorded ego; empty: none
  Track ego;                      ///< a state every step from 0 s to the end; its id is kEgoId
  Track attacker;                 ///< a state every step from its first state on
  /// Other agents within ExportOptions::radius, sorted by id; states at the steps at which they
  /// were in sight.
  std::vector<Track> other_agents;
  LaneMap lanes;                     ///< map within the radius, with the links among the lanes
  std::vector<TrafficLight> lights;  ///< of `lanes`, times on the record's clock
  LaneArcs arcs;                     ///< arcs of `lanes`
  GeoPoint origin;                   ///< of the map frame

  double end() const { return ego.states.back().time; }  ///< s, end of the record
};

/// Splits a track's states into stretches without a gap; `step` in s.
std::vector<std::vector<AgentState>> splitAtGaps(const Track& track, double step);

/// Inputs of crashRecord() beside the scenario.
struct RecordContext {
  const IndexedScene& indexed;
  const LaneArcs& arcs;
  const ExportOptions& options;
  const VerificationOptions& verification;
};

/// Builds the record of an attack. `line`: number of the attack in its file, from 1; `history`: s
/// before t0. Throws std::runtime_error if the scene's name has characters other than letters,
/// digits, '-', '_' and '.', and if the ego is missing at t0 or for a time after it.
CrashRecord crashRecord(const Scenario& scenario, std::size_t line, double history,
                        const RecordContext& context);

}  // namespace forge
