#pragma once

#include <map>
#include <string>
#include <variant>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {

/// Why an attack has no clip: the layout cannot hold it.
enum class ClipObstacle {
  kShortHistory,      ///< fewer than kCollideNowFrame frames before now
  kEgoMissing,        ///< the ego is not there in a frame of the clip
  kAttackerMissing,   ///< the attacker is not there in a frame up to now
  kNoCollisionFrame,  ///< the recording ends before the collision frame, or that is not after now
  kTrajectoryEnds,    ///< the attacker's trajectory ends before the collision frame
  kNoCar,             ///< the attacker is a motorcycle: readers give every track a car's box
  kUnfitName,         ///< map, scene or attacker have a '_' or '/' in their name, or none
};

/// For people, to stand after a number of attacks: "with fewer than 7 frames before now".
const char* toString(ClipObstacle obstacle);

/// An attack in the layout of COLLIDE; `scene` is the recording that it was asked of.
///
/// Frame kCollideNowFrame is now, the last one the recorded frame that lies TTA / 0.5 s, rounded,
/// after it. In all frames ego and other vehicles (isCarLike()) are as recorded, the attacker up to
/// now; after now it is on its trajectory. Poses are middles of boxes, the ego's too; a speed is
/// the norm of the velocity, the attacker's after now that of its trajectory. Tracks are in the
/// order of their ids; who is in no frame is left out.
///
/// Of the name, the batch is "collision-forge", the angle that of the report; the placement is 4
/// for rear_end and 5 for opposite_direction, for the other types told from the report: on which
/// side of the ego the attacker's middle is (lane_change), from which side it comes by its heading
/// (junction_crossing, ltap). Throws std::invalid_argument for a scenario that is no attack or
/// whose now is no frame of the scene.
std::variant<CollideClip, ClipObstacle> toCollideClip(const Scenario& scenario, const Scene& scene,
                                                      int variant);

/// Writes attacks as clips into DIRECTORY/trajectory/SPLIT, where listCollideClips() finds them,
/// and counts those that have none.
class CollideExporter {
 public:
  /// Where the clips of a split lie.
  static std::string folderIn(const std::string& directory, const std::string& split = "val");

  /// Makes the folder. Throws std::filesystem::filesystem_error.
  explicit CollideExporter(const std::string& directory, const std::string& split = "val");

  /// Writes the clip of an attack, aside and renamed, unless it is there already; a scenario that
  /// is no attack is passed over. `variant` must be another for every call. Throws as
  /// toCollideClip() and writeCollideClip().
  void add(const Scenario& scenario, const Scene& scene, int variant);

  /// Attacks that have their clip now.
  int clips() const { return clips_; }

  /// "3 of 9 attacks have no clip: 2 with ..., 1 without ..."; empty when all have one.
  std::string complaint() const;

 private:
  std::string folder_;
  int clips_ = 0;
  std::map<ClipObstacle, int> obstacles_;
};

}  // namespace forge
