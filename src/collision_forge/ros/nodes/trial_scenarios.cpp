#include "collision_forge/ros/nodes/trial_scenarios.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/json/input_line.h"
#include "collision_forge/io/logs/nuscenes_json.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/ros/bags/bag_reader.h"

namespace forge {
namespace {

using Codes = collision_forge::TestPlanner::Response;

bool hasMore(std::istream& file) { return file.peek() != std::istream::traits_type::eof(); }

std::string whereOf(const std::string& path, std::size_t line) {
  return path + ": line " + std::to_string(line);
}

/// Calls `take` with each readable scenario and its line number, until `take` returns false.
void readScenarios(const std::string& path, const InputLimits& limits,
                   const std::function<bool(const Scenario& scenario, std::size_t line)>& take) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  for (std::size_t number = 1; hasMore(file); ++number) {
    const std::string where = whereOf(path, number);
    try {
      readInputLine(file, line, where, limits);
      if (!take(readScenarioLine(where, line, limits), number)) return;
    } catch (const JsonLineError&) {
      continue;  // reported when requested
    } catch (const InputError&) {
      continue;
    }
  }
}

std::set<std::string> scenesIn(const std::string& path, const InputLimits& limits) {
  std::set<std::string> scenes;
  readScenarios(path, limits, [&](const Scenario& scenario, std::size_t) {
    scenes.insert(scenario.asked.scene);
    return true;
  });
  return scenes;
}

/// Returns the recorded frame at `time`; tolerates the resolution of a bag's clock.
double frameAt(const Scene& scene, double time) {
  constexpr double kFrameTolerance = 1e-3;  // s
  const auto frame = lastFrameTime(scene, time + kFrameTolerance);
  if (!frame || std::abs(*frame - time) > kFrameTolerance) {
    throw TestRefusal(Codes::NO_SCENE, "recording \"" + scene.name +
                                           "\" has no frame at trajectory.header.stamp = " +
                                           numberText(time) + " s");
  }
  return *frame;
}

}  // namespace

TrialScenarios::TrialScenarios(TrialSources sources, const Config& config,
                               std::vector<std::string>* warnings)
    : sources_(std::move(sources)), config_(config) {
  if (sources_.recording.empty()) return;
  recording_.emplace();
  recording_->scene = readBag(sources_.recording, config, warnings);
  recording_->lanes = std::make_shared<const LaneIndex>(recording_->scene.map);
}

PlannerCase TrialScenarios::ofLine(const std::string& line) {
  const bool is_number = !line.empty() && line.front() != '{';
  const std::string where =
      is_number ? sources_.scenarios + ": line " + line : std::string("scenario");
  try {
    const std::string text = is_number ? numberedLine(line) : line;
    const Scenario scenario = readScenarioLine(where, text, config_.input_limits);
    const auto scene = sceneOf(scenario.asked.scene);
    PlannerCase one = caseOfScenario(scenario, *scene, config_);
    if (one.status.code != StatusCode::kOk) {
      throw TestRefusal(static_cast<std::uint8_t>(one.status.code),
                        where + ": " + one.status.message + (is_number ? firstWithAttack() : ""));
    }
    return one;
  } catch (const TestRefusal&) {
    throw;
  } catch (const JsonLineError& error) {
    throw TestRefusal(Codes::UNREADABLE, error.what());
  } catch (const std::runtime_error& error) {  // the readers of logs have errors of several types
    throw TestRefusal(Codes::UNREADABLE, where + ": " + error.what());
  }
}

std::string TrialScenarios::firstWithAttack() const {
  std::string found = "; no line has an attack";
  readScenarios(sources_.scenarios, config_.input_limits,
                [&](const Scenario& scenario, std::size_t line) {
                  if (scenario.answer.status.code != StatusCode::kOk) return true;
                  found = "; the first line with an attack is " + std::to_string(line);
                  return false;
                });
  return found;
}

std::string TrialScenarios::numberedLine(const std::string& number) const {
  std::size_t wanted = 0;
  const char* end = number.data() + number.size();
  const auto [parsed_to, problem] = std::from_chars(number.data(), end, wanted);
  if (problem != std::errc() || parsed_to != end) {
    throw TestRefusal(
        Codes::NO_SCENARIO,
        "scenario = \"" + number + "\" is neither a line number nor a line of a scenario file");
  }
  std::ifstream file(sources_.scenarios, std::ios::binary);
  if (!file) {
    throw TestRefusal(Codes::NO_SCENARIO,
                      "parameter scenarios = \"" + sources_.scenarios + "\" cannot be read");
  }
  std::size_t count = 0;
  for (std::string line; hasMore(file);) {
    if (++count == wanted) {
      readInputLine(file, line, whereOf(sources_.scenarios, count), config_.input_limits);
      return line;
    }
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  throw TestRefusal(Codes::NO_SCENARIO, "scenario = \"" + number + "\": " + sources_.scenarios +
                                            " has the lines 1 to " + std::to_string(count));
}

std::shared_ptr<const IndexedScene> TrialScenarios::sceneOf(const std::string& name) {
  if (sources_.logs.path.empty()) {
    throw TestRefusal(Codes::UNREADABLE,
                      "a scenario is tested over the parameter source, which is not set");
  }
  if (wanted_.count(name) == 0) {
    const std::vector<std::string> known = readSceneNames(sources_.logs);
    std::set<std::string> wanted = scenesIn(sources_.scenarios, config_.input_limits);
    wanted.insert(wanted_.begin(), wanted_.end());
    wanted.insert(name);
    std::vector<std::string> scenes;
    std::copy_if(known.begin(), known.end(), std::back_inserter(scenes),
                 [&](const std::string& scene) { return wanted.count(scene) > 0; });
    if (std::find(scenes.begin(), scenes.end(), name) == scenes.end()) {
      throw TestRefusal(Codes::UNREADABLE,
                        "scene = \"" + name + "\" is not in " + sources_.logs.described());
    }
    source_ = std::make_unique<SceneSource>(sources_.logs, scenes, config_, std::size_t{1});
    wanted_ = {scenes.begin(), scenes.end()};
  }
  return source_->at(name);
}

PlannerCase TrialScenarios::ofTrajectory(const AttackerTrajectory& trajectory,
                                         CollisionType type) const {
  if (!recording_) {
    throw TestRefusal(Codes::NO_RECORDING,
                      "a trajectory is tested over the parameter recording, which is not set");
  }
  const double now = frameAt(recording_->scene, trajectory.points.front().time);
  const auto moment =
      std::get<Moment>(momentAt(*recording_, now, config_.attack.prediction.history_frames));
  PlannerCase one;
  one.scenario = {moment.snapshot,
                  *moment.recorded,
                  trajectory,
                  type,
                  egoVehicleOf(recording_->scene, config_.ego_vehicle.center_offset),
                  recording_->lanes};
  one.scene = recording_->scene.name;
  addAttackerPast(one.scenario);
  return one;
}

}  // namespace forge
