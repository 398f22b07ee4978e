#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/ros/bags/bag_file.h"

namespace forge {

/// Reads /tf (map -> base_link), /agents and /lane_map of a bag into a scene named after the file;
/// as in live use: agents are sorted by id, and velocities derived. Of a
/// bag with an attack only the recorded frames of agents are read, no frames in between. Messages
/// that cannot be used (a stamp that is not after the one before, an agent that is not a number or
/// has no size) are left out, as checkScene() leaves out agents, and `warnings`, if given, gets a
/// line for each kind. Throws BagError naming path and topic for a bag that is truncated, no bag or
/// without one of the three, and InputError as checkScene().
Scene readBag(const std::string& path, const DataOptions& options,
              std::vector<std::string>* warnings = nullptr);

/// Like readBag(), but with agents in the order they appear, with the bag's velocities, derived
/// where it has none, and with times rounded to microseconds, as tables of nuScenes have them.
Scene readBagAsWritten(const std::string& path, const DataOptions& options,
                       std::vector<std::string>* warnings = nullptr);

/// Returns the map of /lane_map, null without that topic. Throws BagError as above, and InputError
/// as checkMap().
std::shared_ptr<const LaneMap> readLaneMap(const std::string& path, const InputLimits& limits);

/// Returns request and attack (without alternatives) of a bag of forge inject.
/// The scene is named after the file. Throws BagError as above, and for a bag without an attack,
/// and InputError as checkTrajectory() and checkPattern().
Scenario readAttack(const std::string& path, const DataOptions& options,
                    const CrashDefinition& crash);

}  // namespace forge
