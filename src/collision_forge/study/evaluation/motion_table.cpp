#include "collision_forge/study/evaluation/motion_table.h"

#include <sstream>

namespace forge {
namespace {

void writeRow(std::ostream& text, const std::string& drive, const AttackFigures& figures,
              const DriveLimitOptions& options) {
  text << drive;
  for (const std::string& column : attackColumns(figures)) text << ',' << column;
  const DriveLimits limits = driveLimitsOf(figures.agent_class, figures.size, options);
  text << ',' << limits.max_steering_rate << ',' << limits.max_jerk << ','
       << limits.max_lateral_acceleration << '\n';
}

AttackFigures figuresOf(const RecordedMotion& motion) {
  const MotionWindow& window = motion.window;
  return {window.id, window.agent_class, window.size, motion.road, {}, motion.least_gap, window};
}

}  // namespace

std::string motionTable(const std::vector<ResultRow>& rows, const std::vector<std::string>& methods,
                        const std::vector<RecordedMotion>& recorded, const StudyOptions& options) {
  const DriveLimitOptions& limits = options.attack.verification.drivable;
  std::ostringstream text;
  text << "driver,scene,type,tta," << attackHeader()
       << ",max_steering_rate,max_jerk,max_lateral_acceleration\n";
  for (const std::string& method : methods) {
    for (const ResultRow& row : rows) {
      if (row.method != method || !row.request || !row.request->attack) continue;
      std::ostringstream drive;
      drive << method << ',' << row.scene << ',' << toString(row.type) << ',' << row.tta;
      writeRow(text, drive.str(), *row.request->attack, limits);
    }
  }
  for (const RecordedMotion& motion : recorded) {
    writeRow(text, "recorded," + motion.window.scene + ",,", figuresOf(motion), limits);
  }
  return text.str();
}

}  // namespace forge
