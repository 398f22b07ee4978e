#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Thrown for a COLLIDE clip (arXiv 2510.12206) that violates the data set's layout. The message
/// names the file and, if known, line, column and value.
struct CollideError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Index of the frame at t0 in every clip; frames 0 to 7 are the history.
inline constexpr int kCollideNowFrame = 7;
inline constexpr double kCollideFrameInterval = 0.5;  ///< s between frames, nominal

/// One vehicle in one frame. Global map frame of nuScenes; the pose is the box centre, its yaw as
/// in the file, not wrapped.
struct CollideState {
  Pose2 pose;
  double speed = 0.0;  ///< m/s as recorded (column V); may be negative
};

/// One vehicle of a clip.
struct CollideTrack {
  std::string id;  ///< TRACK_ID: kEgoId or the token of the instance
  /// One per element of CollideClip::times; nullopt: missing in that frame.
  std::vector<std::optional<CollideState>> frames;
};

/// Fields of a clip's file name:
/// data_hcis_BATCH_trainval_CITY_TYPE_SCENE_PLACEMENT-VARIANT-N-FRAME_ANGLE_ATTACKER.csv,
/// TYPE one of LC (kLaneChange), HO (kOppositeDirection), RE (kRearEnd), JC (kJunctionCrossing),
/// LTAP (kLtap), N = (FRAME - 8) / 12, ANGLE in degrees.
struct CollideName {
  std::string batch;                             ///< batch of generation, as "v4.5"
  std::string city;                              ///< name of the map
  std::string scene;                             ///< name of the nuScenes scene
  CollisionType type = CollisionType::kRearEnd;  ///< one of the five types that have a word in TYPE
  /// Attacker seen from the ego: 0 left front, 1 right front, 2 from left, 3 from right, 4 rear, 5
  /// head-on.
  int placement = 0;
  int variant = 0;          ///< counts clips with equal other fields
  int collision_frame = 8;  ///< 8 or above; index of the last frame of every track
  double angle = 0.0;  ///< rad in [0, pi]: |relative heading| at first contact, to 0.01 degrees
  std::string attacker_id;  ///< CollideTrack::id
};

/// A published clip: one collision, frames at about 2 Hz.
struct CollideClip : CollideName {
  std::string name;  ///< file name without its ending
  /// s on the clock of the nuScenes scene, one per frame (`collision_frame` + 1), strictly
  /// increasing.
  std::vector<double> times;
  std::vector<CollideTrack> tracks;  ///< in the file's order, ego and attacker among them

  /// Returns t0, s on the clock of `times`.
  double now() const { return times[kCollideNowFrame]; }
  /// Returns the time from t0 to the collision frame, s, by the recorded times.
  double tta() const { return times.back() - now(); }
  /// Returns the TTA at the nominal 2 Hz, s, a multiple of 0.5 s.
  double nominalTta() const { return kCollideFrameInterval * (collision_frame - kCollideNowFrame); }
  /// Returns a track by id. Throws std::out_of_range for an unknown id.
  const CollideTrack& track(const std::string& id) const;
  // Return the track of the ego or the attacker. Throw std::out_of_range if it is missing.
  const CollideTrack& ego() const;
  const CollideTrack& attacker() const { return track(attacker_id); }
};

/// Parses the name of a file, given with or without its folder. Throws CollideError naming the
/// field.
CollideName parseCollideName(const std::string& path);

/// Returns the published file name of these fields, with ending, without folder. `name.type` must
/// be one of the five types of COLLIDE (not checked); the angle is rounded to 0.01 degrees. Throws
/// std::invalid_argument for a text that is empty or contains '_' or '/'.
std::string composeCollideName(const CollideName& name);

/// Reads one clip: its name and its rows. The first line names the columns of writeCollideClip(),
/// in any order; further columns are ignored. A row whose V, X, Y and YAW are all 0 means that the
/// track is missing in that frame. Throws CollideError for a malformed name, a missing column, a
/// value that is not a finite number or beyond the limits, a track without exactly collision_frame
/// + 1 rows, timestamps that do not increase or differ between tracks, and an ego or attacker that
/// is absent or missing in a frame; InputError as readInputLine().
CollideClip readCollideClip(const std::string& path, const InputLimits& limits);

/// Writes the rows of a clip as published, track by track: TRACK_ID,TIMESTAMP,V,X,Y,YAW, timestamps
/// in whole microseconds, V in m/s, X and Y in m, YAW in degrees, each number as the shortest text
/// that reads back as the same, zeros for a missing frame. `path` should end in the result of
/// composeCollideName(); not checked. Throws as AsideFile.
void writeCollideClip(const std::string& path, const CollideClip& clip);

}  // namespace forge
