#include <collision_forge/Attack.h>
#include <collision_forge/PlannerOutcome.h>
#include <collision_forge/TestPlanner.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <pluginlib/class_list_macros.hpp>

#include <filesystem>
#include <mutex>
#include <utility>

#include "collision_forge/base/config/section.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/planners/planner_worker.h"
#include "collision_forge/planner_test/trials/planner_grid.h"
#include "collision_forge/planner_test/trials/planner_result.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/log_sources.h"
#include "collision_forge/ros/messages/paths.h"
#include "collision_forge/ros/messages/planner_messages.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/external_planner.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/planner_playback.h"
#include "collision_forge/ros/nodes/served_nodelet.h"
#include "collision_forge/ros/nodes/trial_scenarios.h"

namespace forge {
namespace {

using Request = collision_forge::TestPlanner::Request;
using Response = collision_forge::TestPlanner::Response;

[[noreturn]] void refuse(std::uint8_t code, const std::string& message) {
  throw TestRefusal(code, message);
}

/// Throws unless `path` is absolute or empty: the working directory of a node differs from the
/// user's shell.
void requireAbsolute(const std::string& parameter, const std::string& path) {
  if (path.empty() || std::filesystem::path(path).is_absolute()) return;
  throw std::invalid_argument("parameter " + parameter + " = \"" + path +
                              "\" is not an absolute path");
}

Background backgroundOf(const std::string& name) {
  if (name.empty()) return Background::kReplay;
  const auto background = backgroundFromString(name);
  if (!background || *background == Background::kModel) {
    refuse(Response::INVALID_INPUT, "background = \"" + name + "\" is neither replay nor idm");
  }
  return *background;
}

PolicyKind policyOf(const std::string& name) {
  if (name.empty()) return PolicyKind::kFixed;
  const auto policy = policyKindFromString(name);
  if (!policy) {
    refuse(Response::INVALID_INPUT,
           "attacker_policy = \"" + name + "\" is neither fixed nor adaptive");
  }
  return *policy;
}

}  // namespace

/// Serves test_planner: drives a planner in closed loop through a generated crash and shows the
/// rollout. Private parameters: `source`, `version` and `scenarios` for lines of scenario files,
/// `recording` (a bag) for trajectories, `config_dir`.
class PlannerTesterNodelet : public QueuedNodelet {
 private:
  void start(ros::NodeHandle node) override {
    const ros::NodeHandle& own = getPrivateNodeHandle();
    config_ = loadNodeConfig(own);
    planners_text_ = config_.folder.text("planners.yaml");
    loadLogged("scenarios", [&] { openSources(own); });
    loadLogged("network", [&] { models_ = loadPredictionModels(config_); });
    external_ =
        std::make_unique<ExternalPlanner>(node, config_.planners.external, config_.input_limits);
    outcomes_ = node.advertise<collision_forge::PlannerOutcome>(names::kPlannerOutcome, 1, true);
    playback_ = std::make_unique<PlannerPlayback>(node, config_.attack.verification.severity);
    paths_ = node.advertise<nav_msgs::Path>(names::kPlannerPath, 1, true);
    maps_ = node.advertise<collision_forge::LaneMap>(names::kTestedMap, 1, true);
    subscribers_ = {node.subscribe(names::kAttack, 1, &PlannerTesterNodelet::receiveAttack, this)};
    service_ = std::make_unique<OwnThreadService>(node, names::kTestPlanner,
                                                  &PlannerTesterNodelet::answer, this);
  }

  void openSources(const ros::NodeHandle& own) {
    TrialSources sources{
        logSourceAt(own.param<std::string>("source", ""), own.param<std::string>("version", "")),
        own.param<std::string>("scenarios", ""), own.param<std::string>("recording", "")};
    for (const auto& [name, path] :
         {std::pair<const char*, std::string>{"source", sources.logs.path},
          {"scenarios", sources.scenarios},
          {"recording", sources.recording}}) {
      requireAbsolute(name, path);
    }
    std::vector<std::string> warnings;
    const std::string recording = sources.recording;
    try {
      scenarios_ = std::make_unique<TrialScenarios>(sources, config_, &warnings);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM("no trajectories can be tested: " << printable(error.what()));
      sources.recording.clear();
      scenarios_ = std::make_unique<TrialScenarios>(sources, config_, nullptr);
    }
    for (const std::string& warning : warnings) {
      NODELET_WARN_STREAM(printable(recording + ": " + warning));
    }
  }

  void receiveAttack(const collision_forge::AttackConstPtr& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    // A test starts from the first plan: later updates use observations made during the attack.
    const bool goes_on = attack_ && message->adaptive && message->plans > 1 &&
                         message->header.stamp == attack_->header.stamp &&
                         message->trajectory.attacker_id == attack_->trajectory.attacker_id;
    if (goes_on) return;
    attack_ = message;
    playback_->stop();
  }

  bool answer(Request& request, Response& response) {
    response.code = Response::OK;
    try {
      test(request, response);
    } catch (const TestRefusal& refusal) {
      response.code = refusal.code;
      response.message = refusal.what();
    } catch (const PlannerFileError& error) {
      response.code = Response::INVALID_INPUT;
      response.message = error.what();
    } catch (const std::exception& error) {
      const Status status = statusOf(error);
      response.code = static_cast<std::uint8_t>(status.code);
      response.message = status.message;
    }
    if (response.code != Response::OK) {
      NODELET_INFO_STREAM("no test (" << int{response.code}
                                      << "): " << printable(response.message));
    }
    return true;
  }

  void test(const Request& request, Response& response) {
    const TrialOptions options = optionsWith(request.parameters);
    const Background background = backgroundOf(request.background);
    const PolicyKind policy = policyOf(request.attacker_policy);
    PlannerCase one = caseOf(request, policy);
    const CrashScenario& scenario = one.scenario;
    PlannerUnderTest made = makeByName(request.planner, options, scenario.attacker.attacker_id);
    showPlace(scenario);
    const auto attacker = makeAttacker(one, policy, models_, config_);
    const PlannerTrial trial =
        tryPlanner(made.planner ? *made.planner : *external_, made.driving, scenario,
                   {options, config_.attack, config_.crash, background, true, attacker.get()});
    response.outcome = toMessage(trial, request.planner, policy);
    outcomes_.publish(response.outcome);
    paths_.publish(toPath(trial.outcome.driven));
    one.scenario.attacker = trial.outcome.attacker;
    playback_->play(trial, scenario, request.planner);
  }

  /// Creates the planner `name`; for the external one, returns the options alone, since that object
  /// is shared by all tests.
  PlannerUnderTest makeByName(const std::string& name, const PlannerOptions& options,
                              const std::string& attacker_id) {
    if (name == kExternal) {
      external_->setOptions(options.external);
      return {nullptr, {options.external.interval, false}};
    }
    try {
      return makePlanner(name, options, attacker_id);
    } catch (const std::invalid_argument& error) {
      refuse(Response::UNKNOWN_PLANNER, error.what());
    }
  }

  TrialOptions optionsWith(const std::vector<collision_forge::PlannerParameter>& parameters) const {
    PlannerValues values;
    for (const auto& parameter : parameters) {
      if (!values.emplace(parameter.name, parameter.value).second) {
        refuse(Response::BAD_PARAMETER, "parameter " + parameter.name + " is given twice");
      }
    }
    try {
      TrialOptions options = readTrialOptions("planners.yaml", planners_text_, values,
                                              config_.attack.verification.limits);
      options.torchscript.file = config_.planners.torchscript.file;
      options.torchscript.workers = config_.planners.torchscript.workers;
      return options;
    } catch (const ConfigError& error) {
      refuse(Response::BAD_PARAMETER, error.what());
    }
  }

  PlannerCase caseOf(const Request& request, PolicyKind policy) {
    PlannerCase one = request.scenario.empty() ? caseOfTrajectory(request, policy)
                                               : scenarios_->ofLine(request.scenario);
    try {
      checkScenario(one.scenario);
    } catch (const std::invalid_argument& error) {
      refuse(Response::UNFIT, error.what());
    }
    return one;
  }

  /// Includes request and pattern if the trajectory belongs to the newest attack.
  PlannerCase caseOfTrajectory(const Request& request, PolicyKind policy) {
    const collision_forge::AttackConstPtr newest = newestAttack();
    const bool is_given = !request.trajectory.points.empty();
    if (is_given && policy == PolicyKind::kAdaptive) {
      refuse(Response::INVALID_INPUT,
             "attacker_policy = adaptive: a trajectory alone has no planned contact time; "
             "give a scenario, or leave the trajectory out to test the newest attack");
    }
    if (!is_given && (!newest || newest->trajectory.points.empty())) {
      refuse(Response::NO_SCENARIO,
             "neither scenario nor trajectory is given, and no attack was received yet");
    }
    const auto& message = is_given ? request.trajectory : newest->trajectory;
    const bool is_newest = newest && newest->header.stamp == message.header.stamp;
    std::string type = request.collision_type;
    if (type.empty() && is_newest) type = newest->pattern.collision_type;
    const auto parsed = collisionTypeFromString(type);
    if (!parsed) {
      refuse(Response::UNKNOWN_TYPE, "collision_type = \"" + type + "\" is not a collision type");
    }
    const bool is_other = !is_given && *parsed != fromMessage(newest->pattern).type;
    if (is_other && policy == PolicyKind::kAdaptive) {
      refuse(Response::INVALID_INPUT, "collision_type = \"" + type +
                                          "\" differs from the type of the newest attack, "
                                          "which an adaptive attacker keeps");
    }
    const AttackerTrajectory trajectory = fromMessage(message);
    checkTrajectory(trajectory, config_.input_limits, "trajectory");
    PlannerCase one = scenarios_->ofTrajectory(trajectory, *parsed);
    one.request.type = *parsed;
    one.request.crash = config_.crash;
    if (!is_given) {
      one.request.tta = newest->pattern.tta;
      one.pattern = fromMessage(newest->pattern);
      one.effort = newest->effort;
      if (newest->report.manoeuvre == toString(Manoeuvre::kBackOut)) {
        one.request.manoeuvre = Manoeuvre::kBackOut;
      }
    }
    return one;
  }

  collision_forge::AttackConstPtr newestAttack() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return attack_;
  }

  /// Publishes the map around the test, and a frame at the ego as the target of RViz.
  void showPlace(const CrashScenario& scenario) {
    const Pose2& ego = scenario.snapshot.ego.states.back().pose;
    std::vector<Vector2> around;
    for (const AgentState& state : scenario.recorded.ego.states) {
      around.push_back(state.pose.position());
    }
    const LaneMap map = cropped(scenario.lanes->map(), around, config_.conversion.map_radius);
    maps_.publish(toMessage(map, stampOf(scenario.snapshot.now)));
    geometry_msgs::TransformStamped frame;
    frame.header.frame_id = names::kMapFrame;
    frame.header.stamp = ros::Time::now();
    frame.child_frame_id = names::kTestedEgoFrame;
    const geometry_msgs::Pose pose = toPoseMessage(ego);
    frame.transform.translation.x = pose.position.x;
    frame.transform.translation.y = pose.position.y;
    frame.transform.rotation = pose.orientation;
    frames_.sendTransform(frame);
  }

  Config config_;
  std::string planners_text_;
  std::unique_ptr<TrialScenarios> scenarios_;
  PredictionModels models_;  // of adaptive attackers
  std::unique_ptr<ExternalPlanner> external_;
  std::mutex mutex_;
  collision_forge::AttackConstPtr attack_;  // the newest, behind the mutex
  std::unique_ptr<PlannerPlayback> playback_;
  tf2_ros::StaticTransformBroadcaster frames_;
  ros::Publisher outcomes_;
  ros::Publisher paths_;
  ros::Publisher maps_;
  std::vector<ros::Subscriber> subscribers_;
  std::unique_ptr<OwnThreadService> service_;
};

using ServedPlannerTester = Served<PlannerTesterNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedPlannerTester, nodelet::Nodelet)
