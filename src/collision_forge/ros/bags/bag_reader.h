#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/ros/bags/bag_file.h"

namespace forge {

/// Reads /tf (map -> base_link), /agents, /lane_map (the last message), /traffic_lights and
/// /ego_vehicle (the last valid size) of the bag at `path` into a scene named after the file
/// (without folder and extension), equal to the scene in the live nodes: agents sorted by id,
/// velocities derived from the positions. Times are header stamps, s; the ego's track holds box
/// centres. The last two topics may be missing; without /ego_vehicle the ego has the size in
/// `options`.
///
/// In a bag with an attack only the recorded frames of agents are read, not the frames between.
/// Drops unusable messages and agents (stamp not after the previous one, non-finite values, no
/// size) and agents rejected by checkScene(); appends one line per kind to `warnings`, if given.
/// Throws BagError with path and topic for a truncated bag, a file that is no bag, a missing topic,
/// a frame other than map and two different poses of the ego at one time, and InputError like
/// checkScene().
Scene readBag(const std::string& path, const DataOptions& options,
              std::vector<std::string>* warnings = nullptr);

/// Like readBag(), but agents are in order of appearance, their velocities come from the bag (only
/// for an agent whose velocities are all zero they are derived), and times are rounded to
/// microseconds as in nuScenes tables.
Scene readBagAsWritten(const std::string& path, const DataOptions& options,
                       std::vector<std::string>* warnings = nullptr);

/// Returns the map of the last message on /lane_map of the bag at `path`; null without a message.
/// Throws BagError like readBag(), and InputError like checkMap().
std::shared_ptr<const LaneMap> readLaneMap(const std::string& path, const InputLimits& limits);

/// Returns request, attack (without alternatives and plans) and ego vehicle (size from
/// /ego_vehicle, else as readBag()) from a bag of `forge inject`; the last messages on /attack and
/// /attack_request count. Times are header stamps, s; the scene is named after the file. `crash`:
/// definition for the fields that the recorded request leaves empty. Throws BagError like
/// readBag(), for a bag without an attack, for one that another version of this package wrote and
/// for an invalid request or attack; InputError like checkTrajectory() and checkPattern().
Scenario readAttack(const std::string& path, const DataOptions& options,
                    const CrashDefinition& crash);

}  // namespace forge
