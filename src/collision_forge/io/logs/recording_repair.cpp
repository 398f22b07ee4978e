#include "collision_forge/io/logs/recording_repair.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr double kFaster = 20.0;  // m/s above the speed of most steps: impossible for a vehicle
constexpr double kNoise = 1.0;    // m, noise of positions
constexpr double kBeside = 2.0;   // m from the line between the neighbours
constexpr double kAcceleration = 20.0;  // m/s2; twice the grip of tyres
constexpr double kEgoShare = 0.9;       // share of its frames in which an agent is in the ego's box
constexpr std::size_t kEgoFrames = 3;   // fewer such frames are a false detection or a near miss
constexpr double kOtherSize = 1.0;      // m, see isOtherSize()
constexpr double kMicrosecond = 1e-6;   // s

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Finds the positions of one track that jump.
class JumpFinder {
 public:
  JumpFinder(const std::vector<double>& times, const std::vector<Vector2>& positions)
      : times_(times), positions_(positions), kept_(times.size(), true) {
    if (times.size() > 1) most_ = speedOfMost();
  }

  std::vector<std::size_t> find() {
    keepLongestChain();
    dropSingleJumps();
    std::vector<std::size_t> jumps;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (!kept_[i]) jumps.push_back(i);
    }
    return jumps;
  }

 private:
  /// Positions without an impossible step, [first, last], and the best chain of runs up to them.
  struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t chained = 0;  // positions in the chain
    std::ptrdiff_t before = -1;
  };

  /// Returns the speed (m/s) that three of four steps do not exceed.
  double speedOfMost() const {
    std::vector<double> speeds;
    for (std::size_t i = 1; i < times_.size(); ++i) {
      speeds.push_back((positions_[i] - positions_[i - 1]).norm() / (times_[i] - times_[i - 1]));
    }
    const auto place = speeds.begin() + static_cast<std::ptrdiff_t>(3 * speeds.size() / 4);
    std::nth_element(speeds.begin(), place, speeds.end());
    return std::min(*place, medianOf(speeds) + kFaster);
  }

  bool isPossible(std::size_t from, std::size_t to) const {
    const double distance = (positions_[to] - positions_[from]).norm();
    return distance <= (most_ + kFaster) * (times_[to] - times_[from]) + kNoise;
  }

  void keepLongestChain() {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      if (i > 0 && isPossible(i - 1, i)) {
        runs.back().last = i;
      } else {
        runs.push_back({i, i, 0, -1});
      }
    }
    if (runs.size() < 2) return;
    std::size_t best = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      Run& run = runs[i];
      std::size_t before = 0;
      for (std::size_t j = i < kMostRuns ? 0 : i - kMostRuns; j < i; ++j) {
        if (runs[j].chained <= before || !isPossible(runs[j].last, run.first)) continue;
        before = runs[j].chained;
        run.before = static_cast<std::ptrdiff_t>(j);
      }
      run.chained = before + run.last - run.first + 1;
      if (run.chained > runs[best].chained) best = i;
    }
    kept_.assign(kept_.size(), false);
    for (auto i = static_cast<std::ptrdiff_t>(best); i >= 0;
         i = runs[static_cast<std::size_t>(i)].before) {
      const Run& run = runs[static_cast<std::size_t>(i)];
      for (std::size_t k = run.first; k <= run.last; ++k) kept_[k] = true;
    }
  }

  /// Returns true if position `b` is where a vehicle that goes from `a` to `c` cannot be.
  bool isBeside(std::size_t a, std::size_t b, std::size_t c) const {
    const double before = times_[b] - times_[a];
    const double after = times_[c] - times_[b];
    const double share = before / (before + after);
    const Vector2 between = positions_[a] + share * (positions_[c] - positions_[a]);
    const double beside = (positions_[b] - between).norm();
    return beside > std::max(kBeside, 0.5 * kAcceleration * before * after);
  }

  void dropSingleJumps() {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (kept_[i]) at.push_back(i);
    }
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
      const bool fits_before = i < 2 || !isBeside(at[i - 2], at[i - 1], at[i + 1]);
      const bool fits_after = i + 2 >= at.size() || !isBeside(at[i - 1], at[i + 1], at[i + 2]);
      const bool is_checked = i >= 2 || i + 2 < at.size();
      if (!is_checked || !fits_before || !fits_after) continue;
      if (!isBeside(at[i - 1], at[i], at[i + 1])) continue;
      kept_[at[i]] = false;
      ++i;  // the next one has a new neighbour
    }
  }

  static constexpr std::size_t kMostRuns = 200;  // looked back; bounds the time of broken tracks

  const std::vector<double>& times_;
  const std::vector<Vector2>& positions_;
  std::vector<bool> kept_;
  double most_ = 0.0;
};

/// One annotation: its frame and its place in the frame.
struct AnnotationPlace {
  std::size_t frame = 0;
  std::size_t row = 0;
};

class RecordingRepair {
 public:
  RecordingRepair(NuScenesRecording& recording, std::vector<std::string>* warnings)
      : recording_(recording), warnings_(warnings) {}

  void run(const DataOptions& options) {
    repairEgo();
    group();
    nameCategories(options.categories);
    dropEgoAmongAgents(toScene(recording_, options.ego_vehicle, nullptr).ego);
    dropJumps();
    unifySizes();
    erase();
    deriveVelocities(recording_, jumping_);
  }

 private:
  double timeOf(std::int64_t timestamp_us) const {
    return static_cast<double>(timestamp_us) * kMicrosecond;
  }

  double timeOf(const AnnotationPlace& place) const {
    return timeOf(recording_.frames[place.frame].timestamp_us);
  }

  NuScenesAnnotation& at(const AnnotationPlace& place) const {
    return recording_.frames[place.frame].annotations[place.row];
  }

  void warn(const std::string& warning) const {
    if (warnings_ != nullptr) warnings_->push_back(warning);
  }

  void repairEgo() const {
    auto& poses = recording_.ego_poses;
    std::vector<double> times;
    std::vector<Vector2> positions;
    for (const NuScenesEgoPose& pose : poses) {
      times.push_back(timeOf(pose.timestamp_us));
      positions.emplace_back(pose.translation.head<2>());
    }
    const std::vector<std::size_t> jumps = jumpsOf(times, positions);
    if (jumps.empty()) return;
    const std::size_t first = jumps.front();
    const double off = (positions[first] - positions[first > 0 ? first - 1 : first + 1]).norm();
    warn(counted(jumps.size(), "pose") + " of " + std::to_string(poses.size()) +
         " of the ego left out as jumps (first: " +
         formatted("%.2f s after the start, %.1f m off its neighbour", times[first] - times[0],
                   off) +
         ")");
    for (auto jump = jumps.rbegin(); jump != jumps.rend(); ++jump) {
      poses.erase(poses.begin() + static_cast<std::ptrdiff_t>(*jump));
    }
  }

  /// Collects the annotations of each agent, agents in order of appearance.
  void group() {
    std::unordered_map<std::string, std::size_t> places;
    for (std::size_t frame = 0; frame < recording_.frames.size(); ++frame) {
      const auto& annotations = recording_.frames[frame].annotations;
      for (std::size_t row = 0; row < annotations.size(); ++row) {
        const auto [entry, is_new] = places.try_emplace(annotations[row].instance, agents_.size());
        if (is_new) agents_.emplace_back();
        agents_[entry->second].push_back({frame, row});
      }
    }
    for (const NuScenesFrame& frame : recording_.frames) {
      dropped_.emplace_back(frame.annotations.size(), false);
    }
  }

  void nameCategories(const std::map<std::string, AgentClass>& others) const {
    std::map<std::string, std::size_t> unknown;
    for (const std::vector<AnnotationPlace>& agent : agents_) {
      const std::string& category = at(agent.front()).category;
      const auto known = agentClassOfCategory(category, others);
      if (!known) ++unknown[category];
      if (!known || agentClassOfCategory(category)) continue;
      for (const AnnotationPlace& place : agent) at(place).category = categoryOf(*known);
    }
    if (unknown.empty()) return;
    std::string names;
    for (const auto& [category, count] : unknown) {
      names += (names.empty() ? "" : ", ") + std::to_string(count) + " of \"" + category + "\"";
    }
    warn("agents of categories that categories.yaml does not have are static objects: " + names);
  }

  void drop(const AnnotationPlace& place) { dropped_[place.frame][place.row] = true; }

  void dropEgoAmongAgents(const Track& ego) {
    std::vector<std::string> found;
    for (std::vector<AnnotationPlace>& agent : agents_) {
      std::size_t known = 0;
      std::size_t inside = 0;
      for (const AnnotationPlace& place : agent) {
        const auto state = stateAt(ego, timeOf(place));
        if (!state) continue;
        ++known;
        const Vector2 middle = at(place).translation.head<2>();
        inside += distanceToPoint(boxAt(ego, state->pose), middle) == 0.0;
      }
      if (inside < kEgoFrames ||
          static_cast<double>(inside) < kEgoShare * static_cast<double>(known)) {
        continue;
      }
      found.push_back(at(agent.front()).instance + " in " + std::to_string(inside) + " of " +
                      std::to_string(known) + " frames");
      for (const AnnotationPlace& place : agent) drop(place);
      agent.clear();
    }
    if (found.empty()) return;
    warn(counted(found.size(), "agent") +
         " at the place of the ego left out as the ego itself (first: " + found.front() + ")");
  }

  void dropJumps() {
    std::size_t states = 0;
    std::string first;
    for (std::vector<AnnotationPlace>& agent : agents_) {
      std::vector<double> times;
      std::vector<Vector2> positions;
      for (const AnnotationPlace& place : agent) {
        times.push_back(timeOf(place));
        positions.emplace_back(at(place).translation.head<2>());
      }
      const std::vector<std::size_t> jumps = jumpsOf(times, positions);
      if (jumps.empty()) continue;
      const std::string& id = at(agent.front()).instance;
      if (states == 0) {
        first = id + formatted(", %.2f s after the start",
                               times[jumps.front()] - timeOf(recording_.frames[0].timestamp_us));
      }
      states += jumps.size();
      jumping_.insert(id);
      for (const std::size_t jump : jumps) drop(agent[jump]);
    }
    if (states == 0) return;
    warn(counted(states, "state") + " of " + counted(jumping_.size(), "agent") +
         " left out as jumps (first: " + first + ")");
  }

  void unifySizes() const {
    std::vector<std::string> others;
    for (const std::vector<AnnotationPlace>& agent : agents_) {
      if (agent.empty()) continue;
      std::vector<Eigen::Vector3d> sizes;
      for (const AnnotationPlace& place : agent) sizes.push_back(at(place).size);
      const Eigen::Vector3d median = medianSize(sizes);
      if (isOtherSize(sizes.front(), median)) others.push_back(at(agent.front()).instance);
      for (const AnnotationPlace& place : agent) at(place).size = median;
    }
    if (!others.empty()) warn(sizeWarning(others));
  }

  void erase() {
    for (std::size_t frame = 0; frame < dropped_.size(); ++frame) {
      auto& annotations = recording_.frames[frame].annotations;
      std::size_t row = 0;
      annotations.erase(
          std::remove_if(annotations.begin(), annotations.end(),
                         [&](const auto& /*annotation*/) { return dropped_[frame][row++]; }),
          annotations.end());
    }
  }

  NuScenesRecording& recording_;
  std::vector<std::string>* warnings_;
  std::vector<std::vector<AnnotationPlace>> agents_;
  std::vector<std::vector<bool>> dropped_;  // by frame and row
  std::set<std::string> jumping_;           // ids
};

}  // namespace

Eigen::Vector3d medianSize(const std::vector<Eigen::Vector3d>& sizes) {
  Eigen::Vector3d median;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& size : sizes) values.push_back(size[axis]);
    median[axis] = medianOf(std::move(values));
  }
  return median;
}

bool isOtherSize(const Eigen::Vector3d& size, const Eigen::Vector3d& median) {
  return (size - median).head<2>().cwiseAbs().maxCoeff() > kOtherSize;
}

std::string sizeWarning(const std::vector<std::string>& ids) {
  return counted(ids.size(), "agent") +
         " whose first size is not typical of the track (first: " + ids.front() +
         "): the median is used";
}

std::vector<std::size_t> jumpsOf(const std::vector<double>& times,
                                 const std::vector<Vector2>& positions) {
  return JumpFinder(times, positions).find();
}

void repair(NuScenesRecording& recording, const DataOptions& options,
            std::vector<std::string>* warnings) {
  if (recording.frames.empty()) return;
  RecordingRepair(recording, warnings).run(options);
}

}  // namespace forge
