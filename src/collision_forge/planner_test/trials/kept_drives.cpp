#include "collision_forge/planner_test/trials/kept_drives.h"

#include <fstream>
#include <stdexcept>

#include "collision_forge/planner_test/trials/planner_result_file.h"

namespace forge {

KeptDrives::KeptDrives(const std::string& path) : path_(path) {
  std::ifstream file(path, std::ios::binary);
  std::streamoff begin = 0;
  for (std::string line; std::getline(file, line); begin = file.tellg()) lines_.push_back(begin);
  if (lines_.empty()) throw std::runtime_error(path + ": cannot be read");
}

PlannerRow KeptDrives::rowOf(const PlannerCase& one, std::size_t index, const RowKey& key) const {
  std::ifstream file(path_, std::ios::binary);
  file.seekg(lines_.at(index));
  std::string line;
  std::getline(file, line);
  const std::string where = path_ + ": line " + std::to_string(index + 1);
  for (PlannerRow& row : readPlannerResultLine(where, line).rows) {
    if (rowName(row) != rowName(key)) continue;
    const auto complete = [&](AttackerTrajectory& attacker) {
      std::vector<TrajectoryPoint> points = std::move(attacker.points);
      attacker = one.scenario.attacker;
      attacker.points = std::move(points);
    };
    complete(row.outcome.attacker);
    if (row.evasion_drive) complete(row.evasion_drive->attacker);
    return row;
  }
  throw std::out_of_range(where + ": has no row for planner " + rowName(key));
}

}  // namespace forge
