#include "collision_forge/app/options.h"

#include <ros/package.h>

#include <filesystem>
#include <memory>
#include <sstream>

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/maps/common_road_logs.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/io/weights/traffic_generators.h"
#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/ros/bags/log_sources.h"

namespace forge {
namespace {

/// Returns the path of the package, or "" if ROS does not find it.
const std::string& packageFolder() {
  static const std::string folder = ros::package::getPath("collision_forge");
  return folder;
}

/// Returns the pairs (name, value) of `values`.
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
  for (const CollisionType type : kAllCollisionTypes) {
    text += (text.empty() ? "" : "; ") + std::string(toString(type)) + ": " + manoeuvreNames(type);
  }
  return text;
}

}  // namespace

CLI::Validator oneOf(const std::vector<std::string>& words) {
  const CLI::Validator member = CLI::IsMember(words, CLI::ignore_case);
  const auto check = [member, words](std::string& word) {
    if (member(word).empty()) return std::string();
    return "\"" + word + "\" is none of " + CLI::detail::join(words, ", ") +
           nearestNameHint(word, words);
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
  if (turning) request.turning = *turning;
  if (from_side) request.from_side = from_side;
  if (hidden_by) request.hidden_by = hidden_by;
  if (queue) request.queue = *queue;
  for (const auto& [control, range] : ranges) request.*control->asked = range;
  if (alternatives) request.alternatives = *alternatives;
}

void addAttacker(CLI::App& app, RequestControls& controls) {
  app.add_option("--attacker", controls.attacker,
                 "attacker: an agent id, any, existing (a recorded vehicle) or new (an added one)");
}

void addControls(CLI::App& app, RequestControls& controls) {
  addChoice<std::optional<bool>>(
      app, "--believable", controls.believable, {{"true", true}, {"false", false}},
      "true: the attacker drives plausibly, like recorded drivers, until it attacks; false: any "
      "motion within its limits; default: crash_definition.yaml");
  addChoice<std::optional<LimitSet>>(
      app, "--limits", controls.limits,
      wordsOf<LimitSet>(std::vector<LimitSet>{LimitSet::kDrivable, LimitSet::kStrict}),
      "limits of the attacker's motion (vehicle_limits.yaml); drivable: per class; strict: the "
      "same for all classes, requires --believable false; default: crash_definition.yaml");
  addChoice<std::optional<AgentClass>>(app, "--attacker-class", controls.attacker_class,
                                       wordsOf<AgentClass>(kAttackerClasses),
                                       "class of the attacker; default: any");
  addChoice<std::optional<Manoeuvre>>(
      app, "--manoeuvre", controls.manoeuvre, wordsOf<Manoeuvre>(kManoeuvres),
      "manoeuvre of the attacker; default: any; " + manoeuvresByType())
      ->get_validator()
      ->description("");
  addChoice<std::optional<Side>>(
      app, "--ego-side", controls.ego_side,
      wordsOf<Side>(std::vector<Side>{Side::kFront, Side::kRear, Side::kLeft, Side::kRight}),
      "side of the ego that is hit; default: any");
  addRange(app, "--impact-speed", controls.impact_speed,
           "range of the relative speed at contact, m/s; default: any");
  addRange(app, "--overlap", controls.overlap,
           "range of the share, 0 to 1, of the ego's hit side that the attacker covers; default: "
           "any");
  addChoice<std::optional<Turning>>(
      app, "--turning", controls.turning,
      wordsOf<Turning>(std::vector<Turning>{Turning::kAttacker, Turning::kEgo}),
      "vehicle that must turn: ego in ltap, junction_crossing and angle types; default: attacker");
  addChoice<std::optional<Side>>(app, "--from-side", controls.from_side,
                                 wordsOf<Side>(std::vector<Side>{Side::kLeft, Side::kRight}),
                                 "side of the ego from which the attacker comes; default: any");
  addChoice<std::optional<Hider>>(
      app, "--hidden-by", controls.hidden_by,
      wordsOf<Hider>(std::vector<Hider>{Hider::kParkedVehicle, Hider::kLeader}),
      "vehicle that hides the attacker until it comes into view, added if need be; default: any");
  addChoice<std::optional<bool>>(
      app, "--queue", controls.queue, {{"true", true}, {"false", false}},
      "true: a second vehicle stands ahead of the attacker, which stands in its lane; one is added "
      "if need be; default: false");
  for (const RangeControl& control : kRangeControls) {
    app.add_option_function<std::pair<double, double>>(
           "--" + optionName(control.name),
           [&controls, &control](const std::pair<double, double>& range) {
             controls.ranges.emplace_back(&control, Range{range.first, range.second});
           },
           "range, " + std::string(control.unit) + ", of the " + control.meaning + "; default: any")
        ->type_name("MIN MAX");
  }
}

void addAlternatives(CLI::App& app, RequestControls& controls) {
  app.add_option("--alternatives", controls.alternatives,
                 "number of attacks per request that differ in attacker or manoeuvre; default: 1")
      ->check(CLI::Range(1, kMaxAlternatives));
}

CLI::Option* addSource(CLI::App& app, LogSource& logs, const std::string& text) {
  CLI::Option* source =
      app.add_option_function<std::string>(
             "--source,--dataroot",
             [&logs](const std::string& path) { logs = logSourceAt(path, logs.version); },
             text +
                 ": nuScenes root, ScenarioNet folder, bag or folder of bags, CommonRoad scenario "
                 "or "
                 "folder of scenarios")
          ->type_name("PATH")
          ->check(CLI::ExistingPath);
  app.add_option("--version", logs.version,
                 "table folder in a nuScenes root, e.g. v1.0-mini; optional if there is only one")
      ->needs(source);
  app.add_option(
         "--ego-obstacle", logs.ego,
         "CommonRoad: id of the dynamic obstacle that is the ego; default: the vehicle at the "
         "start of a planning problem, else the one in sight for the longest time")
      ->needs(source);
  return source;
}

CLI::Option* addScenes(CLI::App& app, std::vector<std::string>& scenes) {
  return app.add_option("--scene", scenes, "names of scenes; default: all");
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
         installed ? "folder with files and keys that override the installed configuration"
                   : "folder with the complete configuration")
      ->check(CLI::ExistingDirectory)
      ->required(!installed);
}

void addOut(CLI::App& app, std::string& out, const std::string& text) {
  app.add_option("--out", out, text)->required();
}

void addJobs(CLI::App& app, int& jobs, const std::string& text) {
  app.add_option("--jobs", jobs, text)->check(CLI::Range(1, 256))->capture_default_str();
}

std::vector<CatalogueEntry> CatalogueChoice::entries(const ConfigFolder& folder) const {
  return namedEntries(readCatalogue(folder, name), scenarios);
}

void addCatalogue(CLI::App& app, CLI::Option* types, CatalogueChoice& choice) {
  CLI::Option* catalogue = app.add_option(
      "--catalogue", choice.name,
      "scenarios of a test programme instead of types: euro_ncap_2026, un_r157, nhtsa or all");
  catalogue->excludes(types);
  app.add_option("--name", choice.scenarios, "scenarios of the catalogue, e.g. CCRb; default: all")
      ->needs(catalogue);
}

CLI::Option* addMethod(CLI::App& app, std::string& method, const ConfigFolder& config) {
  app.parse_complete_callback([&method, &config] {
    if (!method.empty()) checkMethod("--method", method, config);
  });
  std::string known;
  for (const std::string& name : builtInMethods().names()) known += name + ", ";
  return app.add_option("--method", method,
                        "method that makes attacks: " + known +
                            "or a library of methods.yaml; default: the built-in search");
}

void checkMethod(const std::string& option, const std::string& method, const ConfigFolder& config) {
  try {
    loadMethods(loadConfig(config)).at(method);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(option, error.what());
  } catch (const std::runtime_error&) {
    return;  // the run loads the configuration again and reports its errors
  }
}

CLI::Option* addSeed(CLI::App& app, std::uint64_t& seed, const std::string& text) {
  return app.add_option("--seed", seed, text)->capture_default_str();
}

std::string checkType(const std::string& name) {
  if (collisionTypeFromString(name)) return "";
  std::vector<std::string> names = {"head_on"};
  for (const CollisionType type : kAllCollisionTypes) names.push_back(toString(type));
  return "\"" + name + "\" is none of " + collisionTypeWords() + nearestNameHint(name, names);
}

std::vector<CollisionType> typesNamed(const std::vector<std::string>& names) {
  std::vector<CollisionType> types;
  for (const std::string& name : names) {
    for (const CollisionType type : typesMeant(*collisionTypeFromString(name))) {
      if (std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
    }
  }
  return types;
}

void addPolicies(CLI::App& app, std::vector<std::string>& policies, const std::string& fallback) {
  app.add_option("--attacker-policy", policies,
                 "attacker policies, separated by commas; fixed: follows its planned trajectory; "
                 "adaptive: observes the ego and replans; default: " +
                     fallback)
      ->delimiter(',')
      ->transform(oneOf({"fixed", "adaptive"}));
}

void addMode(CLI::App& app, Mode& mode, bool may_adapt) {
  if (!may_adapt) {
    addChoice<Mode>(app, "--mode", mode, {{"history", Mode::kHistory}, {"replay", Mode::kReplay}},
                    "information of the attack search; replay: the recorded future; history: only "
                    "frames up to t0");
    return;
  }
  addChoice<Mode>(
      app, "--mode", mode,
      {{"history", Mode::kHistory}, {"replay", Mode::kReplay}, {"adaptive", Mode::kAdaptive}},
      "information of the attack search; replay: the recorded future; history: only frames up to "
      "t0; adaptive: as history, and the attacker replans at every new frame");
}

void addOwnPlanners(CLI::App& app, OwnPlanners& own) {
  app.add_option("--planner-file", own.file,
                 "TorchScript file of the planner torchscript (default: file of planners.yaml)");
  CLI::Option* command =
      app.add_option("--planner-command", own.command,
                     "shell command of the planner external: a process that uses the line protocol "
                     "of docs/planners.md");
  app.add_option("--planner-node", own.node,
                 "shell command of the planner external: starts a ROS node; each has a master of "
                 "its own")
      ->excludes(command);
}

void useOwnPlanners(const OwnPlanners& own, const std::vector<std::string>& planners,
                    Config& config) {
  PlannerOptions& settings = config.planners;
  if (!own.file.empty()) settings.torchscript.file = allowedWeights(config, own.file);
  settings.external.is_node = !own.node.empty();
  settings.external.command = own.node.empty() ? own.command : own.node;
  for (const std::string& name : planners) {
    if (name == kTorchscript) makePlanner(name, settings, "");
    if (name == kExternal) ProcessPlanner(settings.external).start();
  }
}

void addPlannerFingerprints(ResumableFile::Options& options,
                            const std::vector<std::string>& planners,
                            const PlannerOptions& settings) {
  const auto is_tested = [&](const char* name) {
    return std::find(planners.begin(), planners.end(), name) != planners.end();
  };
  if (is_tested(kTorchscript)) {
    options["planner_file"] = fingerprintOfFile(settings.torchscript.file);
  }
  if (!is_tested(kExternal)) return;
  const std::string& command = settings.external.command;
  std::string& found = options[settings.external.is_node ? "planner_node" : "planner_command"];
  found = command;
  std::istringstream words(command);
  for (std::string word; words >> word;) {
    std::error_code unreadable;
    if (!std::filesystem::is_regular_file(word, unreadable)) continue;
    found += ", " + word + ": " + fingerprintOfFile(word);
  }
}

std::string BackgroundChoice::text() const {
  std::string names;
  for (const Background background : backgrounds) {
    names += std::string(names.empty() ? "" : ",") + toString(background);
  }
  return names;
}

void addBackground(CLI::App& app, BackgroundChoice& choice, std::size_t most) {
  const auto take = [&choice, most](const std::vector<std::string>& words) {
    const auto refuse = [](const std::string& problem) {
      throw CLI::ValidationError("--background", problem);
    };
    choice.backgrounds.clear();
    for (const std::string& word : words) {
      const bool is_model = word.rfind("model:", 0) == 0 && word != "model:";
      const auto background = is_model ? Background::kModel : backgroundFromString(lowered(word));
      if (!background || (*background == Background::kModel && !is_model)) {
        refuse("\"" + word + "\" is none of replay, idm, model:FILE.pt" +
               nearestNameHint(word, {"replay", "idm"}));
      }
      auto& chosen = choice.backgrounds;
      if (std::find(chosen.begin(), chosen.end(), *background) != chosen.end()) {
        refuse(std::string(toString(*background)) + " is given twice");
      }
      if (is_model) choice.model = word.substr(word.find(':') + 1);
      chosen.push_back(*background);
    }
    if (choice.backgrounds.size() > most) refuse("takes one value");
  };
  const std::string several =
      most > 1 ? "; several, separated by commas, test each case with each" : "";
  app.add_option_function<std::vector<std::string>>(
         "--background", take,
         "motion of other agents; replay: as recorded; idm: reactive, they brake for vehicles "
         "ahead "
         "(IDM); model:FILE.pt: by a learned model (docs/learned_planner.md)" +
             several)
      ->delimiter(',')
      ->type_name("TEXT:{replay,idm,model:FILE.pt}")
      ->default_str("replay");
}

void useBackground(const BackgroundChoice& choice, Config& config) {
  if (choice.model.empty()) return;
  TorchscriptOptions& model = config.planners.traffic_model;
  model.file = allowedWeights(config, choice.model);
  model.workers->giveBack(model.workers->take(model, workerKey(model)));
}

void addBackgroundFingerprints(ResumableFile::Options& options, const BackgroundChoice& choice) {
  options["background"] = choice.text();
  if (!choice.model.empty()) options["background_model"] = fingerprintOfFile(choice.model);
}

ResumableFile::Options inputsOf(const Config& config, const LogSource& logs) {
  ResumableFile::Options options = fingerprintsOf(config, config.folder);
  for (const auto& [name, found] : fingerprintsOf(logs)) options[name] = found;
  return options;
}

void addWeightsOf(const std::string& method, const Config& config,
                  ResumableFile::Options& options) {
  if (isLearnedBaseline(method)) addWeights(method, generatorWeights(config)[method], options);
}

NuScenesProgress showReading() {
  const auto line = std::make_shared<ProgressLine>("tables");
  return [line](std::uint64_t done, std::uint64_t total) {  // bytes; show the share, not a rate
    line->show(static_cast<double>(done) / static_cast<double>(total));
  };
}

void printWarnings(const std::string& subject, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    printLine("warning: " + subject + ": " + warning);
  }
}

}  // namespace forge
