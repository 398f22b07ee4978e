#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/study/evaluation/motion_windows.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// The peak absolute values of a motion.
struct DrivePeaks {
  double steering_rate = 0.0;         ///< rad/s, of the front wheels
  double jerk = 0.0;                  ///< m/s3 along the heading
  double lateral_acceleration = 0.0;  ///< m/s2, speed times yaw rate
};

/// Figures on the motion of an attacker from t0 to the contact predicted by its method.
struct AttackFigures {
  std::string attacker_id;
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  RoadUse road;                        ///< road use from the report of the attack
  DrivePeaks peaks;                    ///< of the trajectory's speed, acceleration and curvature
  std::optional<double> least_gap;     ///< m, to the box of the nearest other agent; empty: none
  std::optional<MotionWindow> window;  ///< attackWindow(); empty: see there
};

/// Computes the figures of an attack, whose report must hold a contact. `recording` provides the
/// positions of other agents and the past of a recorded attacker.
AttackFigures attackFigures(const Realization& answer, const Scene& recording,
                            const StudyOptions& options);

/// Figures on a recorded vehicle in one of recordedWindows().
struct RecordedMotion {
  MotionWindow window;
  RoadUse road;                     ///< road use at the samples of the window
  std::optional<double> least_gap;  ///< m, to the nearest box (ego included) at the samples
};

/// Computes the figures of all recorded windows of all agents of a recording.
std::vector<RecordedMotion> recordedMotion(const IndexedScene& recording,
                                           const StudyOptions& options);

/// Returns the CSV header of attackColumns(), "attacker,class,length,width,on_lane,...,window",
/// without a line end. The column `window` is empty or holds, separated by spaces, the number of
/// generated samples and then time (s), x, y (m) and yaw (rad) of each sample.
std::string attackHeader();
/// Returns one value per column of attackHeader(), all empty without an attack. Replaces commas in
/// the attacker's id.
std::vector<std::string> attackColumns(const std::optional<AttackFigures>& attack);
/// Parses the output of attackColumns() into `attack`. Returns false for invalid columns. `scene`
/// is stored as the scene of the window.
bool readAttackColumns(const std::vector<std::string>& columns, const std::string& scene,
                       std::optional<AttackFigures>& attack);

}  // namespace forge
