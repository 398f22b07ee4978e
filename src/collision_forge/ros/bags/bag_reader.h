#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/ros/bags/bag_file.h"

namespace forge {

/// Reads /tf (map -> base_link), /agents, /lane_map and, if present, /ego_vehicle of a bag into a
/// scene named after the file, equal to the scene in the live nodes: times are header stamps (s),
/// agents are sorted by id, velocities are derived. Leaves out the interpolated frames of a bag
/// with an attack (names::kInBetween). Drops unusable messages and agents (stamp not after the
/// previous one, non-finite values, no size) and agents rejected by checkScene(), with one line per
/// kind in `warnings` if given. Throws BagError with path and topic for a truncated bag, a file
/// that is no bag, a missing topic or two poses of the ego at one time that are kSamePlace apart,
/// and InputError like checkScene().
Scene readBag(const std::string& path, const DataOptions& options,
              std::vector<std::string>* warnings = nullptr);

/// Like readBag(), but agents are in order of appearance, their velocities are read from the bag
/// (derived for an agent whose velocities are all 0), and times are rounded to microseconds as in
/// nuScenes tables.
Scene readBagAsWritten(const std::string& path, const DataOptions& options,
                       std::vector<std::string>* warnings = nullptr);

/// Returns the last message of /lane_map; null without that topic. Throws BagError like readBag(),
/// and InputError like checkMap().
std::shared_ptr<const LaneMap> readLaneMap(const std::string& path, const InputLimits& limits);

/// Returns request and attack, without alternatives, from a bag of `forge inject`. The scene is
/// named after the file. `crash` gives the fields of the crash definition that the bag leaves
/// empty. Throws BagError like readBag() and for a bag without an attack, and InputError like
/// checkTrajectory() and checkPattern().
Scenario readAttack(const std::string& path, const DataOptions& options,
                    const CrashDefinition& crash);

}  // namespace forge
