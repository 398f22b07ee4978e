#include <algorithm>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/instant.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/weights/pattern_network_file.h"

namespace forge {
namespace {

constexpr int kTypeWidth = 24;  // characters of the longest name

struct Arguments {
  std::string bag;
  LogSource logs;
  std::string scene;
  double now = 0.0;
  std::vector<std::string> types;
  std::vector<double> ttas;
  RequestControls controls;
  std::string method;
  Mode mode = Mode::kReplay;
  std::uint64_t seed = 0;
  ConfigFolder config;
  CatalogueChoice catalogue;
};

std::shared_ptr<const IndexedScene> recordingOf(const Arguments& arguments, const Config& config) {
  if (!arguments.bag.empty()) {
    return std::make_shared<const IndexedScene>(readRecording(arguments.bag, config));
  }
  SceneSource scenes(arguments.logs, {arguments.scene}, config, 1, printWarnings);
  return scenes.at(arguments.scene);
}

std::vector<CollisionType> typesOf(const Arguments& arguments) {
  std::vector<CollisionType> types = typesNamed(arguments.types);
  if (types.empty() && arguments.controls.manoeuvre) {
    types.push_back(typeOf(*arguments.controls.manoeuvre));
  } else if (types.empty() && arguments.controls.turning == Turning::kEgo) {
    std::copy_if(std::begin(kAllCollisionTypes), std::end(kAllCollisionTypes),
                 std::back_inserter(types), mayAskForEgoTurn);
  }
  if (types.empty()) types.assign(std::begin(kCollisionTypes), std::end(kCollisionTypes));
  return types;
}

std::string requestText(const CollisionRequest& request) {
  std::ostringstream text;
  text << std::left << std::setw(kTypeWidth) << toString(request.type) << std::right << std::setw(4)
       << request.tta << " s";
  return text.str();
}

void printPossible(const CollisionRequest& request, const Attack& attack, double now) {
  const CollisionReport& report = attack.report;
  std::cout << requestText(request) << "  " << std::left << std::setw(22)
            << toString(report.manoeuvre) << std::setw(kShortId + 4)
            << shortId(attack.trajectory.attacker_id) << std::setw(24)
            << std::string(toString(attack.trajectory.agent_class)) +
                   (attack.trajectory.isAdded() ? ", added" : "")
            << std::right << std::fixed << std::setprecision(0) << std::setw(8)
            << 100.0 * report.confidence << " %" << std::setprecision(1) << std::setw(9)
            << report.contact_time - now << " s" << std::setw(7) << report.impact_speed << " m/s\n"
            << std::defaultfloat << std::setprecision(6);
}

/// Returns the attack and its alternatives, highest confidence first.
std::vector<Attack> attacksOf(Attack answer) {
  std::vector<Attack> attacks = std::move(answer.alternatives);
  attacks.insert(attacks.begin(), std::move(answer));
  std::stable_sort(attacks.begin(), attacks.end(), [](const Attack& a, const Attack& b) {
    return a.report.confidence > b.report.confidence;
  });
  return attacks;
}

std::vector<double> ttasOf(const Arguments& arguments, const Config& config) {
  return arguments.ttas.empty() ? config.requests.ttas : arguments.ttas;
}

std::string rejectionText(const Status& status) {
  return std::string(toString(status.code)) + ": " + status.message;
}

/// Prints the first attack of a scenario over its cells and the TTAs, and returns ""; without an
/// attack, returns the reason. `common`: fields that all requests share.
std::string tryScenario(const CatalogueEntry& entry, const CollisionRequest& common,
                        const Arguments& arguments, const Config& config, const Moment& moment,
                        const MethodMaker& maker) {
  if (!entry.missing.empty()) return "cannot be requested: " + entry.missing;
  std::string reason;
  for (const CatalogueCell& cell : entry.cells) {
    CollisionRequest request = cell.request;
    request.crash = common.crash;
    request.mode = common.mode;
    request.seed = common.seed;
    arguments.controls.applyTo(request);
    for (const double tta : ttasOf(arguments, config)) {
      request.tta = tta;
      const Attack answer =
          generateCollision(*maker.make(), moment, request, config.attack.prediction);
      if (answer.status.code == StatusCode::kOk) {
        std::cout << cell.name << "\n  ";
        printPossible(request, answer, moment.snapshot.now);
        return "";
      }
      if (reason.empty()) reason = rejectionText(answer.status);
    }
  }
  return reason;
}

/// Prints the scenarios of a catalogue that are possible at the instant, then the others with the
/// reason. Returns the exit code.
int listScenarios(const CollisionRequest& common, const Arguments& arguments, const Config& config,
                  const Moment& moment, const MethodMaker& maker) {
  std::ostringstream rejected;
  const std::vector<CatalogueEntry> entries = arguments.catalogue.entries(arguments.config);
  std::size_t possible = 0;
  for (const CatalogueEntry& entry : entries) {
    const std::string reason = tryScenario(entry, common, arguments, config, moment, maker);
    possible += reason.empty();
    if (!reason.empty()) rejected << entry.name << "  " << reason << "\n";
  }
  if (possible < entries.size()) std::cout << "\nrejected\n" << rejected.str();
  return possible > 0 ? kExitOk : kExitNoAttack;
}

int listPossible(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const std::shared_ptr<const IndexedScene> recording = recordingOf(arguments, config);
  const double now = frameTimeOf(recording->scene, arguments.now);
  const Moment moment =
      std::get<Moment>(momentAt(*recording, now, config.attack.prediction.history_frames));
  const MethodMaker maker = loadMethod(arguments.method, config, config.attack);
  CollisionRequest request;
  request.crash = config.crash;
  request.mode = arguments.mode;
  request.seed = arguments.seed;
  arguments.controls.applyTo(request);
  if (!arguments.catalogue.name.empty()) {
    return listScenarios(request, arguments, config, moment, maker);
  }

  std::ostringstream rejected;
  std::size_t possible = 0;
  std::cout << std::left << std::setw(kTypeWidth) << "type"
            << "  TTA  manoeuvre             id      attacker                "
               "confidence  contact     impact\n";
  for (const CollisionType type : typesOf(arguments)) {
    for (const double tta : ttasOf(arguments, config)) {
      request.type = type;
      request.tta = tta;
      const Attack answer =
          generateCollision(*maker.make(), moment, request, config.attack.prediction);
      if (answer.status.code != StatusCode::kOk) {
        rejected << requestText(request) << "  " << rejectionText(answer.status) << "\n";
        continue;
      }
      for (const Attack& attack : attacksOf(answer)) {
        printPossible(request, attack, now);
        ++possible;
      }
    }
  }
  if (!rejected.str().empty()) std::cout << "\nrejected\n" << rejected.str();
  return possible > 0 ? kExitOk : kExitNoAttack;
}

}  // namespace

void addPossible(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMakingCollisions, "possible",
                           "Lists the collisions that are feasible at one instant of a recording.",
                           [arguments] { return listPossible(*arguments); });
  CLI::Option_group& recording =
      *app.add_option_group("recording", "a bag, or one scene of a source");
  recording.add_option("--bag", arguments->bag, "recorded bag, as written by forge convert");
  CLI::Option* source = addSource(app, arguments->logs, "recorded scenes, requires --scene");
  recording.add_option(source);
  recording.require_option(1);
  source->needs(app.add_option("--scene", arguments->scene, "name of the scene, e.g. scene-0061")
                    ->needs(source));
  app.add_option("--now", arguments->now,
                 "time of the request t0, s from the first frame; uses the frame at or before")
      ->required();
  CLI::Option* types = app.add_option(
      "--type", arguments->types,
      "requested collision types; any: all; default: the first five of " + collisionTypeWords());
  types->check(checkType);
  app.add_option("--tta", arguments->ttas,
                 "times to attack, s: time from t0 to contact; default: ttas of requests.yaml");
  addAttacker(app, arguments->controls);
  addCatalogue(app, types, arguments->catalogue);
  addControls(app, arguments->controls);
  addAlternatives(app, arguments->controls);
  addMethod(app, arguments->method, arguments->config);
  addMode(app, arguments->mode, false);
  addSeed(app, arguments->seed, "random seed of the candidates");
  addConfig(app, arguments->config);
}

}  // namespace forge
