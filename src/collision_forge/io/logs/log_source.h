#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/logs/city_maps.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/nuscenes_rows.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// A recording with its map.
struct LoggedScene {
  NuScenesRecording recording;             ///< before it is flattened to the ground plane
  std::shared_ptr<const LaneIndex> lanes;  ///< never null; shared among the scenes of a map
};

/// Extension point: reads the selected scenes of a log source on demand. SceneSource calls read()
/// from several threads, for different scenes at the same time; implementations must be
/// thread-safe.
class SceneReader {
 public:
  virtual ~SceneReader() = default;

  /// Returns the names of the selected scenes, in the source's order. Called from any thread, any
  /// number of times; must be fast and must not throw.
  virtual std::vector<std::string> names() const = 0;
  /// Returns a selected scene on the ground plane, in the map frame; times (s on the scene's clock,
  /// > 0) must increase and values must be within the input limits. Called each time a scene is not
  /// cached, for different scenes concurrently: must be thread-safe. Throws any std::exception for
  /// a scene that cannot be used; callers report it and may go on with other scenes.
  virtual IndexedScene read(const std::string& name) = 0;
  /// Returns the same scene before flattening. Called by `forge convert` once per scene, on the
  /// main thread. Throws as read(), and if the source has flat scenes only.
  virtual LoggedScene recording(const std::string& name) = 0;
};

/// Which scenes of a log source to read, and how.
struct SceneReading {
  std::vector<std::string> scenes;  ///< names of the selected scenes; empty: all
  DataOptions options;              ///< how recordings and maps are read
  // Callbacks; may be empty. Called while LogFormat::open(), SceneReader::read() or recording()
  // runs, in its thread.
  OnWarnings on_warnings;        ///< about scenes and maps
  NuScenesProgress on_progress;  ///< nuScenes: bytes of the tables
};

struct LogSource;

/// Extension point: a kind of log source, as functions. Called by the thread that opens the source.
struct LogFormat {
  const char* name;  ///< for messages, as "a nuScenes root"
  /// Returns true if `path` looks like a source of this kind, false if it cannot be read. Called
  /// once per source for each format in turn; must not read whole files and must not throw.
  bool (*accepts)(const std::string& path);
  /// Returns the names of all scenes. Throws std::exception for a source that cannot be read.
  std::vector<std::string> (*names)(const LogSource& source);
  /// Opens the source. Throws as names(), and for a selected scene that does not exist.
  std::unique_ptr<SceneReader> (*open)(const LogSource& source, const SceneReading& reading);
};

/// Returns the format of nuScenes roots (tables and map expansion), which reads scenes with
/// NuScenesRoot::readScene(), toScene() and CityMaps. The object lives until the program ends.
const LogFormat& nuScenesFormat();

/// The place of recorded scenes.
struct LogSource {
  std::string path;  ///< folder or file
  /// nuScenes root: folder of the tables, as "v1.0-mini"; empty: the only one there.
  std::string version;
  const LogFormat* format = &nuScenesFormat();  ///< kind of the source, not owned; never null
  std::string ego = {};  ///< CommonRoad: id of the obstacle that is the ego; empty: by rule

  /// Returns "PATH/VERSION", or "PATH" without a version, for messages.
  std::string described() const { return version.empty() ? path : path + "/" + version; }
  /// Returns the version, or else the last component of the path, for headings.
  std::string title() const;
};

/// Returns the names of all scenes of a source, in its order. Throws as LogFormat::names().
std::vector<std::string> readSceneNames(const LogSource& source);

/// Returns the names in `wanted` (empty: all scenes), each once, in the source's order. Throws
/// std::runtime_error naming a scene that the source does not have. Also throws as
/// LogFormat::names().
std::vector<std::string> wantedScenes(const LogSource& source,
                                      const std::vector<std::string>& wanted);

/// Repairs the recording (repair()) and removes the annotations of agents that are beyond the input
/// limits (checkScene()). Every reader of recordings calls this. Appends one line per kind of
/// problem to `warnings`, if not null. Throws InputError as checkScene(), naming the recording.
void keepWithin(NuScenesRecording& recording, const DataOptions& options,
                std::vector<std::string>* warnings);

/// Converts the result of SceneReader::recording() to the result of read(): projects the recording
/// to the ground plane by toScene(), with `reading.options.ego_vehicle`.
IndexedScene flattened(const LoggedScene& logged, const SceneReading& reading);

/// Returns the folder of a nuScenes root's tables: `source.version`, or the only one. Throws
/// NuScenesError if there is none, or more than one.
std::string versionOf(const LogSource& source);

/// Returns the inputs on which results depend, by name: "source" (absolute path), "version" (if
/// empty, the only one of a nuScenes root; left out if there is none or more than one), "ego"
/// unless empty, and logFingerprints(). Throws as logFingerprints(), and if the path does not
/// exist.
std::map<std::string, std::string> fingerprintsOf(const LogSource& source);

}  // namespace forge
