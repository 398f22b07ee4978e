#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/traffic_light.h"
#include "collision_forge/io/export/options.h"
#include "collision_forge/io/export/pickle_writer.h"
#include "collision_forge/io/export/scenario_net_tracks.h"

namespace forge {

/// Content of a ScenarioNet scenario description (Li et al., NeurIPS 2023), for crashes and
/// recordings. All at z = 0.
struct ScenarioDescription {
  std::string name;  ///< name of the scenario, valid in file names
  TrackTable table;  ///< from 0 s on; the first track is the ego's, box centres in the map frame
  std::optional<double> step;        ///< s between rows; empty if uneven: no `sample_rate`
  std::size_t current_row = 0;       ///< row of t0; rows before it are history
  const LaneMap& map;                ///< whole content is written; must outlive this object
  std::vector<TrafficLight> lights;  ///< times as in `table`
  /// Writes fields of the dict "collision_forge" in the metadata, which is open; called once by
  /// describe(). writeGround() adds more fields. Must be set.
  std::function<void(PickleWriter&)> write_own;
};

/// Returns the content of a scenario file. If the map has no recorded road edges, it includes the
/// boundary lines of the drivable area within `options.radius` of `path_points`. `path_points`: m,
/// map frame (none: no boundary lines); only `radius` and `heights` of `options` are used. Throws
/// std::invalid_argument for a number that is not finite.
PickleContent describe(const ScenarioDescription& scenario, const std::vector<Vector2>& path_points,
                       const ExportOptions& options);

/// Returns the file name of a scenario: sd_collision_forge_v1_NAME.pkl.
std::string scenarioNetFile(const std::string& name);

/// Returns the names of the scenarios whose files are in a folder, sorted; names as in
/// scenarioNetFile(), files with other names are ignored. Throws std::filesystem::filesystem_error
/// if the folder cannot be read.
std::vector<std::string> scenarioNetNames(const std::string& folder);

/// Writes the format's files over the scenarios `names` of a folder: dataset_summary.pkl, from the
/// metadata in their files, and dataset_mapping.pkl, in which every file is in the folder itself;
/// replaces earlier ones. Without names, both files hold an empty dict. Throws PickleError naming a
/// file that is missing or is not a scenario description, and as AsideFile.
void writeScenarioNetSummary(const std::string& folder, const std::vector<std::string>& names,
                             PickleWorkers& workers);

}  // namespace forge
