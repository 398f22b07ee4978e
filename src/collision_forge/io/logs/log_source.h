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
  NuScenesRecording recording;
  std::shared_ptr<const LaneIndex> lanes;
};

/// The wanted scenes of a log source, each read when it is asked for. Thread-safe.
class SceneReader {
 public:
  virtual ~SceneReader() = default;

  /// Of the wanted scenes, in the source's order.
  virtual std::vector<std::string> names() const = 0;
  /// Within the limits of input. Throws what is wrong with the scene.
  virtual IndexedScene read(const std::string& name) = 0;
  /// The same before it is flattened to the ground; throws also where the source has it flat alone.
  virtual LoggedScene recording(const std::string& name) = 0;
};

/// What is wanted of a log source, and how it is read.
struct SceneReading {
  std::vector<std::string> scenes;  ///< the wanted ones; empty: all
  DataOptions options;
  OnWarnings on_warnings;
  NuScenesProgress on_progress;
};

struct LogSource;

/// A kind of log source.
struct LogFormat {
  const char* name;  ///< for people, as "a nuScenes root"
  /// True for a path that looks like one.
  bool (*accepts)(const std::string& path);
  /// The names of all scenes. Throws for a source that cannot be read.
  std::vector<std::string> (*names)(const LogSource& source);
  /// Throws as names(), and for a wanted scene that is not there.
  std::unique_ptr<SceneReader> (*open)(const LogSource& source, const SceneReading& reading);
};

/// Tables and maps as nuScenes has them. read() gives scenes as NuScenesRoot::readScene(),
/// toScene() and CityMaps do.
const LogFormat& nuScenesFormat();

/// Where recorded scenes are read from.
struct LogSource {
  std::string path;
  /// Of a nuScenes root: the folder of its tables; empty: the only one.
  std::string version;
  const LogFormat* format = &nuScenesFormat();

  /// For messages.
  std::string described() const { return version.empty() ? path : path + "/" + version; }
  /// For headlines: the version, else the last part of the path.
  std::string title() const;
};

/// The names of all scenes of a source, in its order.
std::vector<std::string> readSceneNames(const LogSource& source);

/// Those of `wanted`, in the source's order; all if it is empty. Throws std::runtime_error naming
/// one that the source does not have.
std::vector<std::string> wantedScenes(const LogSource& source,
                                      const std::vector<std::string>& wanted);

/// Leaves out instances that are beyond the limits of input as an agent; `warnings`, if given, gets
/// one line a kind. Throws InputError as checkScene(), naming the recording.
void keepWithin(NuScenesRecording& recording, const DataOptions& options,
                std::vector<std::string>* warnings);

/// What read() gives of what recording() gave: on the ground.
IndexedScene flattened(const LoggedScene& logged, const SceneReading& reading);

/// The folder of the tables: `source.version`, or the only one that there is. Throws NuScenesError
/// where there is none, or more than one.
std::string versionOf(const LogSource& source);

/// What results depend on in a source: where it is, and logFingerprints().
std::map<std::string, std::string> fingerprintsOf(const LogSource& source);

}  // namespace forge
