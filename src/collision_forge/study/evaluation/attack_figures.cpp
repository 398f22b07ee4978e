#include "collision_forge/study/evaluation/attack_figures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/statistics/csv_text.h"

namespace forge {
namespace {

const std::vector<std::string> kColumns = {
    "attacker",  "class",      "length",    "width",         "on_lane", "wrong_way",
    "off_road",  "on_walkway", "on_island", "steering_rate", "jerk",    "lateral_acceleration",
    "least_gap", "window"};

/// Tracks the minimum distance of a moving box to the other agents.
class LeastGap {
 public:
  LeastGap(const std::vector<Track>& others, const std::string& id) : others_(others), id_(id) {}

  void update(const OrientedBox& box, double time) {
    for (const Track& other : others_) {
      if (other.id != id_) update(box, other, time);
    }
  }
  void update(const OrientedBox& box, const Track& other, double time) {
    const auto state = stateAt(other, time);
    if (!state) return;
    const double reach = circumradius(box.size) + circumradius(other.size);
    const double middles = (state->pose.position() - box.center.position()).norm();
    if (least_ && middles - reach >= *least_) return;
    const double gap = distance(box, boxAt(other, state->pose));
    least_ = std::min(gap, least_.value_or(gap));
  }
  const std::optional<double>& found() const { return least_; }

 private:
  const std::vector<Track>& others_;
  const std::string& id_;
  std::optional<double> least_;
};

DrivePeaks peaksUntil(const AttackerTrajectory& trajectory, double until, double wheelbase) {
  DrivePeaks peaks;
  const TrajectoryPoint* before = nullptr;
  for (const TrajectoryPoint& point : trajectory.points) {
    peaks.lateral_acceleration =
        std::max(peaks.lateral_acceleration, point.speed * point.speed * std::abs(point.curvature));
    if (before != nullptr) {
      const double step = point.time - before->time;
      const double turned =
          std::atan(wheelbase * point.curvature) - std::atan(wheelbase * before->curvature);
      const double change = point.acceleration - before->acceleration;
      peaks.steering_rate = std::max(peaks.steering_rate, std::abs(turned) / step);
      peaks.jerk = std::max(peaks.jerk, std::abs(change) / step);
    }
    if (point.time >= until) break;
    before = &point;
  }
  return peaks;
}

std::string decimals(int places, double value) { return formatted("%.*f", places, value); }

std::string windowText(const MotionWindow& window) {
  std::string text = std::to_string(window.generated);
  for (const WindowSample& sample : window.samples) {
    text += " " + decimals(6, sample.time) + " " + decimals(3, sample.pose.x) + " " +
            decimals(3, sample.pose.y) + " " + decimals(5, sample.pose.yaw);
  }
  return text;
}

bool parse(const std::string& text, double& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool parse(const std::string& text, AgentClass& agent_class) {
  for (int i = 0; i <= static_cast<int>(AgentClass::kStaticObject); ++i) {
    agent_class = static_cast<AgentClass>(i);
    if (text == toString(agent_class)) return true;
  }
  return false;
}

bool parseWindow(const std::string& text, MotionWindow& window) {
  std::istringstream stream(text);
  stream >> window.generated;
  for (WindowSample& sample : window.samples) {
    stream >> sample.time >> sample.pose.x >> sample.pose.y >> sample.pose.yaw;
  }
  return static_cast<bool>(stream) && stream.eof();
}

/// Returns pointers to the members of the columns on_lane to lateral_acceleration, in this order.
std::vector<double*> sharesAndPeaks(AttackFigures& attack) {
  return {&attack.road.on_lane,   &attack.road.wrong_way,
          &attack.road.off_road,  &attack.road.on_walkway,
          &attack.road.on_island, &attack.peaks.steering_rate,
          &attack.peaks.jerk,     &attack.peaks.lateral_acceleration};
}

}  // namespace

AttackFigures attackFigures(const Realization& answer, const Scene& recording,
                            const StudyOptions& options) {
  const AttackerTrajectory& trajectory = answer.trajectory;
  const double contact = answer.report.contact_time;
  AttackFigures figures{trajectory.attacker_id,
                        trajectory.agent_class,
                        trajectory.size,
                        answer.report.road,
                        {},
                        {},
                        {}};
  const DriveLimits limits =
      driveLimitsOf(trajectory.agent_class, trajectory.size, options.attack.verification.drivable);
  figures.peaks = peaksUntil(trajectory, contact, limits.wheelbase);
  LeastGap gap(recording.agents, trajectory.attacker_id);
  for (const TrajectoryPoint& point : trajectory.points) {
    if (point.time > contact) break;
    gap.update({point.pose, trajectory.size}, point.time);
  }
  figures.least_gap = gap.found();
  figures.window =
      attackWindow(recording.name, attackerPast(trajectory, recording.agents), trajectory, contact,
                   options.attack.verification.believability.before_contact);
  return figures;
}

std::vector<RecordedMotion> recordedMotion(const IndexedScene& recording,
                                           const StudyOptions& options) {
  std::vector<RecordedMotion> found;
  const Scene& scene = recording.scene;
  for (const Track& agent : scene.agents) {
    for (MotionWindow& window : recordedWindows(scene.name, agent)) {
      std::vector<TrajectoryPoint> points;
      LeastGap gap(scene.agents, agent.id);
      for (const WindowSample& sample : window.samples) {
        points.push_back({sample.time, sample.pose, 0.0, 0.0, 0.0});
        gap.update({sample.pose, agent.size}, sample.time);
        gap.update({sample.pose, agent.size}, scene.ego, sample.time);
      }
      const RoadUse road = roadUse(points, agent.size, points.back().time, *recording.lanes,
                                   options.attack.verification.believability);
      found.push_back({std::move(window), road, gap.found()});
    }
  }
  return found;
}

std::string attackHeader() {
  std::string text;
  for (const std::string& column : kColumns) text += (text.empty() ? "" : ",") + column;
  return text;
}

std::vector<std::string> attackColumns(const std::optional<AttackFigures>& attack) {
  if (!attack) return std::vector<std::string>(kColumns.size());
  AttackFigures figures = *attack;
  std::vector<std::string> columns = {csvText(figures.attacker_id), toString(figures.agent_class),
                                      decimals(3, figures.size.length),
                                      decimals(3, figures.size.width)};
  for (const double* number : sharesAndPeaks(figures)) columns.push_back(decimals(4, *number));
  columns.push_back(figures.least_gap ? decimals(3, *figures.least_gap) : "");
  columns.push_back(figures.window ? windowText(*figures.window) : "");
  return columns;
}

bool readAttackColumns(const std::vector<std::string>& columns, const std::string& scene,
                       std::optional<AttackFigures>& attack) {
  if (columns.size() != kColumns.size()) return false;
  attack.reset();
  const auto is_empty = [](const std::string& column) { return column.empty(); };
  if (std::all_of(columns.begin(), columns.end(), is_empty)) return true;
  AttackFigures found;
  found.attacker_id = columns[0];
  if (!parse(columns[1], found.agent_class) || !parse(columns[2], found.size.length) ||
      !parse(columns[3], found.size.width)) {
    return false;
  }
  auto column = columns.begin() + 4;
  for (double* number : sharesAndPeaks(found)) {
    if (!parse(*column++, *number)) return false;
  }
  if (!column->empty() && !parse(*column, found.least_gap.emplace())) return false;
  ++column;
  if (!column->empty()) {
    found.window = MotionWindow{scene, found.attacker_id, found.agent_class, found.size, {}, 0};
    if (!parseWindow(*column, *found.window)) return false;
  }
  attack = std::move(found);
  return true;
}

}  // namespace forge
