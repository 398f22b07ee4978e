#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/study/evaluation/motion_windows.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// The greatest absolute values of a motion.
struct DrivePeaks {
  double steering_rate = 0.0;         ///< rad/s, of the front wheels
  double jerk = 0.0;                  ///< m/s3 along the heading
  double lateral_acceleration = 0.0;  ///< m/s2, speed times yaw rate
};

/// How an attacker drives from now to the contact that its method expects.
struct AttackFigures {
  std::string attacker_id;
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  RoadUse road;                        ///< of its report
  DrivePeaks peaks;                    ///< of the written speeds, accelerations and curvatures
  std::optional<double> least_gap;     ///< m to the box of anybody but the ego; empty: nobody there
  std::optional<MotionWindow> window;  ///< attackWindow(), its positions to the millimetre
};

/// Of an answer with a contact. `recording`: the scene that the attacker's past is taken from, if
/// it has none of its own; the others are where it has them.
AttackFigures attackFigures(const Realization& answer, const Scene& recording,
                            const StudyOptions& options);

/// What a recorded vehicle does in one of recordedWindows().
struct RecordedMotion {
  MotionWindow window;
  RoadUse road;                     ///< of its samples
  std::optional<double> least_gap;  ///< m to the box of anybody, at its samples
};

/// Every window of a recording.
std::vector<RecordedMotion> recordedMotion(const IndexedScene& recording,
                                           const StudyOptions& options);

/// "attacker,class,length,width,on_lane,...,window": the columns of attackColumns(), without a line
/// end. `window` is empty or holds the number of generated samples and of each sample time, x, y
/// and yaw, apart by spaces.
std::string attackHeader();
/// Of as many columns as in the header, all empty without an attack. Commas in the id are replaced.
std::vector<std::string> attackColumns(const std::optional<AttackFigures>& attack);
/// Of columns as attackColumns() writes them, into `attack`; false for any others. `scene` is the
/// window's.
bool readAttackColumns(const std::vector<std::string>& columns, const std::string& scene,
                       std::optional<AttackFigures>& attack);

}  // namespace forge
