#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <utility>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/request_check.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/drawing/draw_scenario.h"
#include "collision_forge/policy/adaptive_answer.h"
#include "collision_forge/ros/bag_reader.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/injection.h"
#include "collision_forge/settings/config.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string bag;
  std::string out;
  std::string draw;
  std::string config;
  std::string method;
  double now = 0.0;
  int alternative = 1;
  collision_forge::CollisionRequest request;
  RequestControls controls;
  Mode mode = Mode::kHistory;
};

/// The frame at or before `now` seconds after the scene's first.
double frameAt(const Scene& scene, double now) {
  const double start = scene.frame_times.front();
  const auto frame = lastFrameTime(scene, start + now);
  if (!frame || !(start + now <= scene.frame_times.back())) {
    throw std::invalid_argument("--now " + std::to_string(now) +
                                " is outside the recording, 0 to " +
                                std::to_string(scene.frame_times.back() - start) + " s");
  }
  return *frame;
}

void printReport(const char* subject, const CollisionReport& report, double now) {
  constexpr double kDegrees = 180.0 / M_PI;
  std::cout << std::fixed << std::setprecision(2) << subject << ": ";
  if (!report.contact) {
    std::cout << "no contact\n";
    return;
  }
  std::cout << (report.verified() ? "crash as asked" : "contact, not as asked") << ", "
            << report.contact_time - now << " s from now, relative heading "
            << report.relative_heading * kDegrees << " degrees, attacker's "
            << toString(report.attacker_side) << " to ego's " << toString(report.ego_side)
            << ", impact speed " << report.impact_speed << " m/s, overlap "
            << 100.0 * report.overlap << " %, "
            << (report.limits_kept ? "limits kept" : report.broken_limit)
            << (report.first_other_id.empty() ? ""
                                              : ", touches " + report.first_other_id + " first")
            << ", " << 100.0 * report.off_road_share << " % off road, "
            << toString(report.manoeuvre) << " from " << report.manoeuvre_begin - now << " s on, "
            << (report.believable() ? "believable" : "not believable: it " + report.unbelievable)
            << "\n";
}

int refuse(const Status& status) {
  std::cerr << toString(status.code) << ": " << status.message << "\n";
  return kExitNoAttack;
}

bool isSameFile(const fs::path& a, const fs::path& b) {
  return fs::weakly_canonical(a) == fs::weakly_canonical(b);
}

/// Throws for a picture that would replace a bag, and for one that cannot be written.
void checkPicture(const std::string& picture, const Arguments& arguments) {
  for (const auto& [option, bag] : {std::pair{"--bag", arguments.bag}, {"--out", arguments.out}}) {
    if (isSameFile(picture, bag)) {
      throw std::invalid_argument("--draw would write " + picture + ", the bag of " + option);
    }
  }
  const fs::path folder = fs::absolute(picture).parent_path();
  if (!fs::is_directory(folder) || access(folder.c_str(), W_OK | X_OK) != 0) {
    throw std::runtime_error("cannot draw " + picture + ": " + folder.string() +
                             " is no folder that can be written to");
  }
  if (fs::is_directory(picture)) throw std::runtime_error("cannot draw " + picture + ": a folder");
}

/// So that nothing is written, or lost, where not all can be written.
void checkOutputs(const Arguments& arguments) {
  if (isSameFile(arguments.bag, arguments.out)) {
    throw std::invalid_argument("--out names the input bag " + arguments.bag);
  }
  if (arguments.draw.empty()) return;
  for (const char* ending : {".png", ".gif"}) checkPicture(arguments.draw + ending, arguments);
}

/// The attack that is to be injected, `number` 1 the method's own; declined where there are fewer.
Realization alternativeOf(const Realization& first, int number) {
  if (first.status.code != StatusCode::kOk || number == 1) return first;
  const std::size_t others = first.alternatives.size();
  const auto place = static_cast<std::size_t>(number) - 2;
  if (place < others) return first.alternatives[place];
  Realization declined;
  declined.status = {StatusCode::kNoAttackWithinLimits,
                     "--alternative " + std::to_string(number) + ": there are " +
                         std::to_string(others + 1) + " distinct attacks only"};
  return declined;
}

/// Without plans where the attacker does not react.
AdaptiveAnswer answerOf(const MethodMaker& maker, const Moment& moment, const Scene& scene,
                        const CollisionRequest& request, const Arguments& arguments,
                        const Config& config) {
  if (request.mode == Mode::kAdaptive) {
    const AttackerSetup setup{maker.egoFutures(), config.attack, config.adaptive};
    return withoutMisses(
        answerAdaptively(*maker.make(), moment, scene, config.ego_vehicle, request, setup),
        request);
  }
  const Realization first =
      generateCollision(*maker.make(), moment, request, config.attack.prediction);
  return {alternativeOf(first, arguments.alternative), {}, {}};
}

int inject(const Arguments& arguments) {
  checkOutputs(arguments);
  collision_forge::CollisionRequest asked = arguments.request;
  asked.mode = toString(arguments.mode);
  const Config config = loadConfig(arguments.config);
  const auto parsed = fromMessage(asked, config.crash);
  if (const Status* refusal = std::get_if<Status>(&parsed)) return refuse(*refusal);
  CollisionRequest request = std::get<CollisionRequest>(parsed);
  arguments.controls.applyTo(request);
  // All of them: the others are sorted by how sure they are.
  request.alternatives = arguments.alternative == 1 ? 1 : kMaxAlternatives;
  std::vector<std::string> warnings;
  const Scene scene = readBag(arguments.bag, config.ego_vehicle, &warnings);
  printWarnings(arguments.bag, warnings);

  const double now = frameAt(scene, arguments.now);
  const PredictionOptions& prediction = config.attack.prediction;
  const Moment moment{snapshotAt(scene, now, prediction.history_frames), recordedFuture(scene, now),
                      std::make_shared<const LaneIndex>(scene.map), pastOf(scene, now)};
  const MethodMaker maker = loadMethod(arguments.method, config, config.attack);
  const auto [attack, plans, _] = answerOf(maker, moment, scene, request, arguments, config);
  if (attack.status.code != StatusCode::kOk) return refuse(attack.status);
  CollisionReport tested =
      verify(attack.trajectory, {moment.snapshot, *moment.recorded, request, *moment.lanes},
             config.attack.verification);
  tested.confidence = attack.report.confidence;
  const std::string& attacker = attack.trajectory.attacker_id;
  collision_forge::Attack message = toMessage(attack, maker.name(), now);
  collision_forge::CollisionReport tested_message = toMessage(tested, attacker, now);
  if (!plans.empty()) {
    setPlans(plans, message);
    tested_message.decision = message.decision;
  }
  injectIntoBag(arguments.bag, arguments.out, message, tested_message);
  std::cout << toString(request.type) << " by " << attacker << ", "
            << (attack.trajectory.isAdded() ? "an added " : "a recorded ")
            << toString(attack.trajectory.agent_class)
            << ", now = " << now - scene.frame_times.front() << " s, confidence "
            << attack.report.confidence << "\n";
  printReport("generated", attack.report, now);
  printReport("against the recording", tested, now);
  std::cout << "wrote " << arguments.out << "\n";
  if (!arguments.draw.empty()) {
    const ScenarioView view{scene.name,       request.tta, request.mode,      moment.snapshot,
                            *moment.recorded, attack.aim,  attack.trajectory, tested};
    drawScenarioPng(arguments.draw + ".png", view, config.drawing);
    drawScenarioGif(arguments.draw + ".gif", view, config.drawing);
    std::cout << "wrote " << arguments.draw << ".png\nwrote " << arguments.draw << ".gif\n";
  }
  return kExitOk;
}

}  // namespace

void addInject(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMakingCollisions, "inject",
                           "Makes an agent of a bag crash into the ego, and writes that bag.",
                           [arguments] { return inject(*arguments); });
  auto& request = arguments->request;
  app.add_option("--bag", arguments->bag, "recorded bag, as from forge convert")->required();
  app.add_option("--type", request.collision_type,
                 "lane_change, opposite_direction, rear_end, junction_crossing or ltap (LC, OD, "
                 "HO, RE, JC, LTAP)")
      ->required();
  app.add_option("--tta", request.tta, "seconds from now to impact, 0.5 to 9")->required();
  app.add_option("--now", arguments->now,
                 "seconds from the bag's first frame; the frame at or before")
      ->required();
  addAttacker(app, arguments->controls);
  addControls(app, arguments->controls);
  app.add_option("--alternative", arguments->alternative,
                 "which of the attacks that differ in attacker or manoeuvre; 1, the default: the "
                 "method's own; from 2 on the others, the surest first")
      ->check(CLI::Range(1, kMaxAlternatives));
  addMethod(app, arguments->method);
  addMode(app, arguments->mode, true);
  addSeed(app, request.seed, "of the variations tried");
  addOut(app, arguments->out, "bag to write");
  app.add_option("--draw", arguments->draw, "also draw to this name + .png and .gif");
  addConfig(app, arguments->config);
}

}  // namespace forge
