#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/ros/bags/bag_file.h"

namespace forge {

/// Reads /tf (map -> base_link), /agents and /lane_map of a bag into a scene named after the file,
/// equal to the scene in the live nodes: agents sorted by id, velocities derived. In a bag with an
/// attack only recorded frames of agents are read. Drops unusable messages and agents (stamp not
/// after the previous one, non-finite values, no size) and agents rejected by checkScene(), with
/// one line per kind in `warnings` if given. Throws BagError with path and topic for a truncated
/// bag, a file that is no bag or a missing topic, and InputError like checkScene().
Scene readBag(const std::string& path, const DataOptions& options,
              std::vector<std::string>* warnings = nullptr);

/// Like readBag(), but agents are in order of appearance, velocities are those in the bag (derived
/// only if missing), and times are rounded to microseconds as in nuScenes tables.
Scene readBagAsWritten(const std::string& path, const DataOptions& options,
                       std::vector<std::string>* warnings = nullptr);

/// Returns the map of /lane_map; null without that topic. Throws BagError like readBag(), and
/// InputError like checkMap().
std::shared_ptr<const LaneMap> readLaneMap(const std::string& path, const InputLimits& limits);

/// Returns request and attack, without alternatives, from a bag of `forge inject`. The scene is
/// named after the file. Throws BagError like readBag() and for a bag without an attack, and
/// InputError like checkTrajectory() and checkPattern().
Scenario readAttack(const std::string& path, const DataOptions& options,
                    const CrashDefinition& crash);

}  // namespace forge
