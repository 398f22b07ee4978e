#include "collision_forge/app/options.h"

#include <memory>

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scenario_net_logs.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/io/weights/traffic_generators.h"
#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"

#ifndef COLLISION_FORGE_WITHOUT_ROS
#include <ros/package.h>

#include "collision_forge/ros/bags/log_sources.h"
#endif

namespace forge {
namespace {

/// Empty where ROS does not know the package.
const std::string& packageFolder() {
#ifdef COLLISION_FORGE_WITHOUT_ROS
  static const std::string folder;
#else
  static const std::string folder = ros::package::getPath("collision_forge");
#endif
  return folder;
}

#ifdef COLLISION_FORGE_WITHOUT_ROS
/// Bags are not read here.
LogSource logSourceAt(const std::string& path, const std::string& version) {
  const LogFormat& scenario_net = scenarioNetFormat();
  return {path, version, scenario_net.accepts(path) ? &scenario_net : &nuScenesFormat()};
}
#endif

/// The names of the values, each with its value.
template <typename Value, typename Values>
std::vector<std::pair<std::string, std::optional<Value>>> wordsOf(const Values& values) {
  std::vector<std::pair<std::string, std::optional<Value>>> words;
  for (const Value value : values) words.emplace_back(toString(value), value);
  return words;
}

void addRange(CLI::App& app, const std::string& name, std::optional<Range>& value,
              const std::string& text) {
  app.add_option_function<std::pair<double, double>>(
         name,
         [&value](const std::pair<double, double>& range) {
           value = Range{range.first, range.second};
         },
         text)
      ->type_name("MIN MAX");
}

std::string manoeuvresByType() {
  std::string text;
  for (const CollisionType type : kCollisionTypes) {
    text += (text.empty() ? "" : "; ") + std::string(toString(type)) + ": " + manoeuvreNames(type);
  }
  return text;
}

}  // namespace

CLI::Validator oneOf(const std::vector<std::string>& words) {
  const CLI::Validator member = CLI::IsMember(words, CLI::ignore_case);
  const auto check = [member, words](std::string& word) {
    const std::string complaint = member(word);
    return complaint.empty() ? complaint : complaint + nearestNameHint(word, words);
  };
  return {check, member.get_description()};
}

void RequestControls::applyTo(CollisionRequest& request) const {
  if (const auto choice = attackerChoiceFromString(attacker)) {
    request.attacker.reset();
    request.choice = *choice;
  } else if (!attacker.empty()) {
    request.attacker = attacker;
  }
  if (believable) request.crash.believable = *believable;
  if (limits) request.crash.limits = *limits;
  if (attacker_class) request.attacker_class = attacker_class;
  if (manoeuvre) request.manoeuvre = manoeuvre;
  if (ego_side) request.ego_side = ego_side;
  if (impact_speed) request.impact_speed = impact_speed;
  if (overlap) request.overlap = overlap;
  if (alternatives) request.alternatives = *alternatives;
}

void addAttacker(CLI::App& app, RequestControls& controls) {
  app.add_option("--attacker", controls.attacker,
                 "agent id, or any, existing (a recorded vehicle) or new (one is added)");
}

void addControls(CLI::App& app, RequestControls& controls) {
  addChoice<std::optional<bool>>(app, "--believable", controls.believable,
                                 {{"true", true}, {"false", false}},
                                 "true: the attacker drives as drivers do until it attacks; false: "
                                 "as it can; default: crash_definition.yaml");
  addChoice<std::optional<LimitSet>>(
      app, "--limits", controls.limits,
      wordsOf<LimitSet>(std::vector<LimitSet>{LimitSet::kDrivable, LimitSet::kStrict}),
      "of vehicle_limits.yaml; drivable: by the attacker's class; strict: the same for all, "
      "requires --believable false; default: crash_definition.yaml");
  addChoice<std::optional<AgentClass>>(app, "--attacker-class", controls.attacker_class,
                                       wordsOf<AgentClass>(kAttackerClasses),
                                       "of the attacker; any by default");
  addChoice<std::optional<Manoeuvre>>(
      app, "--manoeuvre", controls.manoeuvre, wordsOf<Manoeuvre>(kManoeuvres),
      "what the attacker does, any by default; " + manoeuvresByType())
      ->get_validator()
      ->description("");
  addChoice<std::optional<Side>>(
      app, "--ego-side", controls.ego_side,
      wordsOf<Side>(std::vector<Side>{Side::kFront, Side::kRear, Side::kLeft, Side::kRight}),
      "of the ego, where it is touched; any by default");
  addRange(app, "--impact-speed", controls.impact_speed,
           "least and greatest, m/s, of the relative velocity at contact; any by default");
  addRange(app, "--overlap", controls.overlap,
           "least and greatest share, 0 to 1, of the ego's touched side that the attacker covers; "
           "any by default");
}

void addAlternatives(CLI::App& app, RequestControls& controls) {
  app.add_option("--alternatives", controls.alternatives,
                 "attacks asked for, which differ in attacker or manoeuvre; 1 by default")
      ->check(CLI::Range(1, kMaxAlternatives));
}

CLI::Option* addSource(CLI::App& app, LogSource& logs, const std::string& text) {
  CLI::Option* source =
      app.add_option_function<std::string>(
             "--source,--dataroot",
             [&logs](const std::string& path) { logs = logSourceAt(path, logs.version); },
             text + ": a nuScenes root, a ScenarioNet folder, a bag or a folder of bags")
          ->type_name("PATH")
          ->check(CLI::ExistingPath);
  app.add_option(
         "--version", logs.version,
         "folder of the tables in a nuScenes root, as v1.0-mini; may be left out where there "
         "is one alone")
      ->needs(source);
  return source;
}

CLI::Option* addScenes(CLI::App& app, std::vector<std::string>& scenes) {
  return app.add_option("--scene", scenes, "names of scenes; all by default");
}

std::optional<ConfigFolder> installedConfig() {
  if (packageFolder().empty()) return std::nullopt;
  return ConfigFolder(packageFolder() + "/config");
}

void addConfig(CLI::App& app, ConfigFolder& config) {
  const auto installed = installedConfig();
  if (installed) config = *installed;
  const auto use = [&config, installed](const std::string& folder) {
    config = installed ? ConfigFolder(packageFolder() + "/config", folder) : ConfigFolder(folder);
  };
  app.add_option_function<std::string>(
         "--config", use,
         installed ? "folder with the files and keys that differ from the installed configuration"
                   : "folder with the configuration files")
      ->check(CLI::ExistingDirectory)
      ->required(!installed);
}

void addOut(CLI::App& app, std::string& out, const std::string& text) {
  app.add_option("--out", out, text)->required();
}

void addJobs(CLI::App& app, int& jobs, const std::string& text) {
  app.add_option("--jobs", jobs, text)->check(CLI::Range(1, 256))->capture_default_str();
}

CLI::Option* addMethod(CLI::App& app, std::string& method, const ConfigFolder& config) {
  app.parse_complete_callback([&method, &config] {
    if (!method.empty()) checkMethod("--method", method, config);
  });
  std::string known;
  for (const std::string& name : builtInMethods().names()) known += name + ", ";
  return app.add_option(
      "--method", method,
      "how attacks are made: " + known +
          "or one of the libraries in methods.yaml; by default the suite's own way");
}

void checkMethod(const std::string& option, const std::string& method, const ConfigFolder& config) {
  try {
    loadMethods(loadConfig(config)).at(method);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(option, error.what());
  } catch (const std::runtime_error&) {
    return;  // the run reads the configuration again and says what is wrong with it
  }
}

CLI::Option* addSeed(CLI::App& app, std::uint64_t& seed, const std::string& text) {
  return app.add_option("--seed", seed, text)->capture_default_str();
}

std::string checkType(const std::string& name) {
  if (collisionTypeFromString(name)) return "";
  std::vector<std::string> names = {"head_on"};
  for (const CollisionType type : kCollisionTypes) names.push_back(toString(type));
  return "\"" + name + "\" is none of " + collisionTypeWords() + nearestNameHint(name, names);
}

void addMode(CLI::App& app, Mode& mode, bool may_adapt) {
  if (!may_adapt) {
    addChoice<Mode>(app, "--mode", mode, {{"history", Mode::kHistory}, {"replay", Mode::kReplay}},
                    "replay: the recorded future is known; history: only the frames up to now are");
    return;
  }
  addChoice<Mode>(
      app, "--mode", mode,
      {{"history", Mode::kHistory}, {"replay", Mode::kReplay}, {"adaptive", Mode::kAdaptive}},
      "replay: the recorded future is known; history: only the frames up to now are; adaptive: as "
      "history, and the attacker replans at every frame that comes");
}

void addPlannerFile(CLI::App& app, std::string& file) {
  app.add_option("--planner-file", file,
                 "TorchScript file of the planner torchscript (default: that of planners.yaml)");
}

void usePlannerFile(const std::string& file, const std::vector<std::string>& planners,
                    Config& config) {
  if (!file.empty()) config.planners.torchscript.file = allowedWeights(config, file);
  for (const std::string& name : planners) {
    if (name == kTorchscript) makePlanner(name, config.planners, "");
  }
}

void addPlannerFingerprint(ResumableFile::Options& options,
                           const std::vector<std::string>& planners,
                           const PlannerOptions& settings) {
  if (std::find(planners.begin(), planners.end(), kTorchscript) == planners.end()) return;
  options["planner_file"] = fingerprintOfFile(settings.torchscript.file);
}

void addBackground(CLI::App& app, Background& background) {
  addChoice<Background>(app, "--background", background,
                        {{"replay", Background::kReplay}, {"idm", Background::kIdm}},
                        "the others: replay, or idm (they brake for who is in their way)");
}

ResumableFile::Options inputsOf(const Config& config, const LogSource& logs) {
  ResumableFile::Options options = fingerprintsOf(config, config.folder);
  for (const auto& [name, found] : fingerprintsOf(logs)) options[name] = found;
  return options;
}

void addWeightsOf(const std::string& method, const Config& config,
                  ResumableFile::Options& options) {
  const std::string model = generatorOf(method);
  if (!model.empty()) addWeights(model, generatorWeights(config)[model], options);
}

NuScenesProgress showReading() {
  if (!isMaster()) return {};
  const auto line = std::make_shared<ProgressLine>("tables");
  return [line](std::uint64_t done, std::uint64_t total) {  // bytes, of which nobody wants a rate
    line->show(static_cast<double>(done) / static_cast<double>(total));
  };
}

void printWarnings(const std::string& subject, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    printLine("warning: " + subject + ": " + warning);
  }
}

}  // namespace forge
