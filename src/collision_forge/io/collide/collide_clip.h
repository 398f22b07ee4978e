#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// A clip of the COLLIDE data set (arXiv 2510.12206) that is not what its layout says. The message
/// names the file and, where they are known, line, column and value.
struct CollideError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The frame of every clip that is now; frames 0 to 7 are the history.
inline constexpr int kCollideNowFrame = 7;
inline constexpr double kCollideFrameInterval = 0.5;  ///< s, nominal

/// One vehicle in one frame. Global map frame of nuScenes; the pose is the middle of the box.
struct CollideState {
  Pose2 pose;
  double speed = 0.0;  ///< m/s as recorded (column V)
};

struct CollideTrack {
  std::string id;
  std::vector<std::optional<CollideState>> frames;  ///< 0 to collision_frame; empty where missing
};

/// What a file's name says:
/// data_hcis_BATCH_trainval_CITY_TYPE_SCENE_PLACEMENT-VARIANT-N-FRAME_ANGLE_ATTACKER.csv,
/// TYPE one of LC, HO, RE, JC, LTAP, N = (FRAME - 8) / 12, ANGLE in degrees.
struct CollideName {
  std::string batch;  ///< of generation, as "v4.5"
  std::string city;   ///< name of the map
  std::string scene;
  CollisionType type = CollisionType::kRearEnd;
  int placement = 0;  ///< 0 left front, 1 right front, 2 from left, 3 from right, 4 rear, 5 head-on
  int variant = 0;
  int collision_frame = 8;  ///< 8 or above; last frame of every track
  double angle = 0.0;  ///< rad in [0, pi]: |relative heading| at first contact, to 0.01 degrees
  std::string attacker_id;
};

/// A published clip: one collision, frames at about 2 Hz.
struct CollideClip : CollideName {
  std::string name;                  ///< of the file, without its ending
  std::vector<double> times;         ///< seconds, one a frame, strictly increasing
  std::vector<CollideTrack> tracks;  ///< in the file's order, ego and attacker among them

  double now() const { return times[kCollideNowFrame]; }
  /// Seconds from now to the collision frame, by the recorded times.
  double tta() const { return times.back() - now(); }
  /// The same at the nominal 2 Hz, a multiple of 0.5 s.
  double nominalTta() const { return kCollideFrameInterval * (collision_frame - kCollideNowFrame); }
  /// Throws std::out_of_range for an id that is not there.
  const CollideTrack& track(const std::string& id) const;
  const CollideTrack& ego() const;
  const CollideTrack& attacker() const { return track(attacker_id); }
};

/// Takes a path or a file name. Throws CollideError naming the field.
CollideName parseCollideName(const std::string& path);

/// The published file name of these fields, ending included. Throws std::invalid_argument for a
/// text that is empty or has a '_' or '/' in it.
std::string composeCollideName(const CollideName& name);

/// Reads one clip: its name and its rows. A row whose V, X, Y and YAW are all 0 is a frame in which
/// the track is missing. Throws CollideError for a name as above, a missing column, a value that is
/// no finite number or beyond the limits, a track without exactly collision_frame + 1 rows,
/// timestamps that do not increase or differ between tracks, and an ego or attacker that is absent
/// or missing in a frame; InputError as readInputLine().
CollideClip readCollideClip(const std::string& path, const InputLimits& limits);

/// Writes the rows of a clip as published: TRACK_ID,TIMESTAMP,V,X,Y,YAW with microseconds and
/// degrees, every number as the shortest text that reads back as the same, zeros for a missing
/// frame. Throws as AsideFile does.
void writeCollideClip(const std::string& path, const CollideClip& clip);

}  // namespace forge
