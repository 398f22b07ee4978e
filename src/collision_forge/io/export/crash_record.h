#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/geometry/arc_path.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/export/options.h"
#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {

/// The course of lanes as their map has it, by their ids; empty where a map tells points alone.
using LaneArcs = std::unordered_map<std::string, std::vector<ArcPath>>;

/// One crash as other tools are told it: how everybody moves, on one clock that begins at 0 s, on
/// the lanes around. Global map frame, metres, radians. Poses are the middles of boxes.
///
/// Up to the contact ego and others are as recorded, and the attacker drives its attack. After it
/// ego and attacker move as of PostCrashMotion, with boxes that overlap by 5 mm.
struct CrashRecord {
  std::string name;   ///< of the files; a plain word, "scene-0061_17"
  Scenario scenario;  ///< what was asked for and answered; its times are on the scene's clock
  double step = 0.0;  ///< s between states
  double now = 0.0;   ///< s, when the attack begins; a multiple of `step`
  std::optional<double> contact;  ///< s, of the attacker with the recorded ego; empty: none
  Track ego;                      ///< a state every step from 0 s to the end; its id is kEgoId
  Track attacker;                 ///< the same, from its first state on
  /// Those near, in the order of their ids, who move or stand; states at those steps at which they
  /// were seen.
  std::vector<Track> others;
  LaneMap lanes;  ///< those near, with the links among them
  LaneArcs arcs;  ///< of these
  GeoPoint origin;

  double end() const { return ego.states.back().time; }  ///< s
};

/// Runs of states without a gap: a track that was out of sight for a time has several.
std::vector<std::vector<AgentState>> seenStretches(const Track& track, double step);

/// What a record is made of beside the scenario.
struct RecordContext {
  const IndexedScene& indexed;
  const LaneArcs& arcs;
  const ExportOptions& options;
  const VerificationOptions& verification;
};

/// The record of an attack; `line` is its number in its file, from 1. `history`: s before now.
/// Throws std::runtime_error for a scene whose name is no plain word, and for one in which the ego
/// is not there at now.
CrashRecord crashRecord(const Scenario& scenario, std::size_t line, double history,
                        const RecordContext& context);

}  // namespace forge
