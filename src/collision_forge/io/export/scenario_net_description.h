#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/options.h"
#include "collision_forge/io/export/pickle_writer.h"
#include "collision_forge/io/export/scenario_net_tracks.h"

namespace forge {

/// What a scenario description of ScenarioNet (Li et al., NeurIPS 2023) is made of, whatever it is
/// of. Everything lies at z = 0.
struct ScenarioDescription {
  std::string name;             ///< of the scenario; a plain word
  TrackTable table;             ///< from 0 s on; the first track is the self-driving car's
  std::optional<double> step;   ///< s between rows, where they are even
  std::size_t current_row = 0;  ///< what is before it is history
  const LaneMap& map;
  /// Writes the metadata's "collision_forge", to which writeGround() adds.
  std::function<void(PickleWriter&)> write_own;
};

/// What a scenario's file holds. Lines where drivable ground ends are told within
/// `options.radius` of `ways`.
PickleContent describe(const ScenarioDescription& scenario, const std::vector<Vector2>& ways,
                       const ExportOptions& options);

/// The name of a scenario's file: sd_collision_forge_v1_NAME.pkl.
std::string scenarioNetFile(const std::string& name);

/// The names of the scenarios that have their files in a folder, sorted.
std::vector<std::string> scenarioNetNames(const std::string& folder);

/// Writes what the format wants of all scenarios of a folder: dataset_summary.pkl, from the
/// metadata in their files, and dataset_mapping.pkl. Throws PickleError naming a file that is
/// missing or no scenario description.
void writeScenarioNetSummary(const std::string& folder, const std::vector<std::string>& names,
                             PickleWorkers& workers);

}  // namespace forge
