#pragma once

#include <map>
#include <string>
#include <variant>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {

/// Reasons why the layout cannot hold an attack.
enum class ClipObstacle {
  kShortHistory,      ///< fewer than kCollideNowFrame frames at 2 Hz before t0
  kEgoMissing,        ///< the ego is missing in a frame of the clip
  kAttackerMissing,   ///< the attacker is missing in a frame up to t0
  kNoCollisionFrame,  ///< the collision frame is not after t0, or the recording ends before it
  kTrajectoryEnds,    ///< the attacker's trajectory ends before the collision frame
  kNotCarLike,  ///< the attacker is not car-like, such as a motorcycle: readers give every track a
                ///< car's box
  kOtherType,   ///< the type is none of COLLIDE's five, or the request asks the ego to turn
  kUnfitName,   ///< the name of map, scene or attacker is empty or contains '_' or '/'
};

/// Returns a text for people that follows a number of attacks: "with fewer than 7 frames at 2 Hz
/// before t0".
const char* toString(ClipObstacle obstacle);

/// Converts an attack to the layout of COLLIDE. `scene` is the recording of its request, with a
/// map; support vehicles are added to it. `variant` becomes CollideName::variant. Returns the
/// reason instead if the layout cannot hold the attack.
///
/// Frame kCollideNowFrame is t0; the last frame is TTA / 0.5 s frames later, rounded to the
/// nearest, halves up. If the recording is not at 2 Hz (areCollideFrames()), it is interpolated at
/// times 0.5 s apart. The ego and other car-like vehicles (isCarLike()) are as recorded in all
/// frames; the attacker is as recorded up to t0 and on its trajectory after it. All poses are box
/// centres. All speeds are norms of the velocity, except for the attacker after t0, which has the
/// speed of its trajectory. Tracks are sorted by id; vehicles that are in no frame are left out.
///
/// Name: batch "collision-forge", angle from the report. Placement: 4 for rear_end, 5 for
/// opposite_direction; lane_change 0 if the attacker's centre at contact is left of the ego's, else
/// 1; junction_crossing and ltap 2 (from the left) if CollisionReport::relative_heading is
/// negative, else 3. Throws std::invalid_argument for a scenario without an attack and for a t0
/// that is not a frame of the scene, to kTimeEpsilon.
std::variant<CollideClip, ClipObstacle> toCollideClip(const Scenario& scenario, const Scene& scene,
                                                      int variant);

/// Writes attacks as clips to DIRECTORY/trajectory/SPLIT, where listCollideClips() finds them, and
/// counts attacks that have none. Not thread-safe.
class CollideExporter {
 public:
  /// Returns the folder of a split's clips, DIRECTORY/trajectory/SPLIT; `split`: "train" or "val"
  /// as published, or another name.
  static std::string folderIn(const std::string& directory, const std::string& split = "val");

  /// Creates the folder. Throws std::filesystem::filesystem_error.
  explicit CollideExporter(const std::string& directory, const std::string& split = "val");

  /// Writes the clip of an attack with an AsideFile, unless it exists; ignores a scenario without
  /// an attack. `variant` must differ between calls. Throws as toCollideClip() and
  /// writeCollideClip().
  void add(const Scenario& scenario, const Scene& scene, int variant);

  /// Returns the number of attacks that have a clip, written or found.
  int clips() const { return clips_; }

  /// Returns "3 of 9 attacks have no clip of COLLIDE's layout: 2 with ..., 1 without ..."; "" if
  /// all have one.
  std::string complaint() const;

 private:
  std::string folder_;
  int clips_ = 0;                          ///< attacks with a clip
  std::map<ClipObstacle, int> obstacles_;  ///< number of attacks without a clip, by reason
};

}  // namespace forge
