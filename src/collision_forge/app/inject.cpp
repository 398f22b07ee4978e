#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <utility>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/instant.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/attack/policy/adaptive_answer.h"
#include "collision_forge/attack/search/alternatives.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/attack/verify/untested_contact.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/support_vehicles.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/drawing/draw_clouds.h"
#include "collision_forge/io/drawing/draw_scenario.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/ros/bags/bag_reader.h"
#include "collision_forge/ros/injection/cloud_pairs.h"
#include "collision_forge/ros/injection/injection.h"
#include "collision_forge/ros/markers/crash_words.h"
#include "collision_forge/ros/messages/attack_request.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/report_text.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string bag;
  std::string out;
  std::string draw;
  ConfigFolder config;
  std::string method;
  double now = 0.0;
  std::uint32_t alternative = 1;
  collision_forge::CollisionRequest request;
  RequestControls controls;
  Mode mode = Mode::kReplay;
  AfterContact after_contact = AfterContact::kStop;
  const CLI::Option* after_contact_option = nullptr;
  std::optional<double> seconds_after_stand;
  std::vector<std::string> lidar;  ///< topics of clouds, or kAllClouds

  /// Sensors do not feel the crash, so that bags with changed clouds end with the contact.
  AfterContact afterContact() const {
    return !lidar.empty() && after_contact_option->empty() ? AfterContact::kEnd : after_contact;
  }
};

/// Returns a sentence on the content of the output bag after the contact with the recorded ego.
std::string aftermathOf(AfterContact after, const std::optional<PostCrashMotion>& crash,
                        bool is_untested, const AttackedBagOptions& options) {
  if (is_untested) return "the bag ends before the contact; the ego drives as recorded";
  if (!crash) return "no contact: the bag continues, the ego drives as recorded";
  std::ostringstream text;
  text << "after the contact: ";
  switch (after) {
    case AfterContact::kStop:
      text << "both stand " << formatted("%.1f", crash->standTime() - crash->contactTime())
           << " s later; /tf and odom are rewritten; the bag ends " << options.seconds_after_stand
           << " s after both have stopped";
      break;
    case AfterContact::kEnd:
      text << "the bag ends " << options.end_time << " s later";
      break;
    case AfterContact::kDriveOn:
      text << "the ego continues as recorded, the attacker to the end of its trajectory";
      break;
  }
  return text.str();
}

/// Returns a line per agent that ego or attacker touch after the contact, each after a line break.
std::string secondaryContactText(const PostCrashMotion& crash, const std::string& attacker,
                                 const std::vector<Track>& agents) {
  std::string text;
  for (const SecondaryContact& contact : secondaryContacts(crash, attacker, agents)) {
    text += formatted("\n%.1f s after the contact ", contact.time - crash.contactTime()) +
            (contact.is_ego ? "the ego" : "the attacker") + " touches " +
            toString(findTrack(agents, contact.agent_id)->agent_class) + " " +
            printable(contact.agent_id) + ", which drives as recorded";
  }
  return text;
}

/// Returns the exit code after the bag was written. If the attack does not hit the recorded ego as
/// requested, prints the difference on stderr. `is_untested`: endsBeforeContact().
int exitCodeOf(const collision_forge::CollisionReport& tested, bool is_untested,
               const Arguments& arguments) {
  if (tested.verified) return kExitOk;
  std::cout.flush();
  std::cerr << "NOT_AS_ASKED: " << printable(arguments.out)
            << " does not show the requested collision: "
            << (is_untested ? "the recording ends before the contact" : outcomeWords(tested))
            << (arguments.mode == Mode::kReplay ? "" : " (--mode replay uses the recorded future)")
            << "\n";
  return kExitNoAttack;
}

int refuse(const Status& status) {
  std::cerr << toString(status.code) << ": " << printable(status.message) << "\n";
  return kExitNoAttack;
}

bool isSameFile(const fs::path& a, const fs::path& b) {
  return fs::weakly_canonical(a) == fs::weakly_canonical(b);
}

/// Throws if `picture` names one of the bags or cannot be written.
void checkPicture(const std::string& picture, const Arguments& arguments) {
  for (const auto& [option, bag] : {std::pair{"--bag", arguments.bag}, {"--out", arguments.out}}) {
    if (isSameFile(picture, bag)) {
      throw std::invalid_argument("--draw would overwrite " + picture + ", the bag of " + option +
                                  "; choose another name");
    }
  }
  const fs::path folder = fs::absolute(picture).parent_path();
  if (!fs::is_directory(folder) || access(folder.c_str(), W_OK | X_OK) != 0) {
    throw std::runtime_error("cannot draw " + picture + ": " + folder.string() +
                             " is not a writable folder");
  }
  if (fs::is_directory(picture)) {
    throw std::runtime_error("cannot draw " + picture + ": it is a folder");
  }
}

/// Checks all output paths before anything is written.
void checkOutputs(const Arguments& arguments) {
  if (isSameFile(arguments.bag, arguments.out)) {
    throw std::invalid_argument("--out names the input bag " + arguments.bag +
                                "; choose another file");
  }
  if (arguments.draw.empty()) return;
  for (const char* ending : {".png", ".gif"}) checkPicture(arguments.draw + ending, arguments);
  if (!arguments.lidar.empty()) checkPicture(arguments.draw + "_lidar.gif", arguments);
}

/// Runs the request. The plans of the result are empty except in mode adaptive.
AdaptiveDrive answerOf(const MethodMaker& maker, const Moment& moment, const Scene& scene,
                       const CollisionRequest& request, const Arguments& arguments,
                       const Config& config) {
  if (request.mode == Mode::kAdaptive) {
    const AttackerSetup setup{maker.egoFutures(), config.attack, config.adaptive};
    return rejectMisses(
        requestAdaptively(*maker.make(), moment, scene,
                          egoVehicleOf(scene, config.ego_vehicle.center_offset), request, setup),
        request);
  }
  return {attackOf(generateCollision(*maker.make(), moment, request, config.attack.prediction),
                   arguments.alternative),
          {},
          {}};
}

/// The attack and its check against the recording, as written into the bag.
struct TestedAttack {
  const Attack& attack;
  const std::vector<AttackerPlan>& plans;
  const CollisionReport& tested;
  const CollisionRequest& request;
  double now;
};

collision_forge::AttackRequest requestMessage(const TestedAttack& attack,
                                              const collision_forge::Attack& attack_message,
                                              const Scene& scene, const Arguments& arguments,
                                              const Config& config) {
  collision_forge::AttackRequest message =
      attackRequest(attack.request, attack_message, fingerprintOfAll(config, config.folder),
                    arguments.alternative);
  message.now = attack.now - scene.frame_times.front();
  message.after_contact = toString(arguments.afterContact());
  message.bag = fs::path(arguments.bag).filename().string();
  return message;
}

/// The messages and notes of a written bag.
struct WrittenBag {
  BagAttack attack;
  InjectionNotes notes;
};

/// Returns the lines on clouds and cameras; "" without any.
std::string sensorText(const WrittenBag& written, const Scene& scene) {
  std::string text;
  for (const std::string& line : written.notes.lidar) {
    text += "lidar: " + std::string(printable(line)) + "\n";
  }
  const collision_forge::CollisionReport& tested = written.attack.tested_report;
  if (!text.empty() && tested.contact) {
    text += formatted(
        "lidar: sensors match until the contact, %.2f s after the first frame; "
        "cameras are not changed\n",
        tested.contact_time.toSec() - scene.frame_times.front());
  }
  for (const std::string& line : written.notes.cameras) {
    text += "camera: " + std::string(printable(line)) + "\n";
  }
  return text;
}

WrittenBag writeAttackedBag(const TestedAttack& attack, const Scene& scene,
                            const std::string& method, const Arguments& arguments,
                            const Config& config) {
  const std::string& attacker = attack.attack.trajectory.attacker_id;
  BagAttack bag_attack;
  bag_attack.attack = toMessage(attack.attack, method, attack.now);
  bag_attack.tested_report = toMessage(attack.tested, attacker, attack.now);
  bag_attack.request = requestMessage(attack, bag_attack.attack, scene, arguments, config);
  bag_attack.after_contact = arguments.afterContact();
  if (!arguments.lidar.empty()) {
    bag_attack.lidar = LidarRequest{arguments.lidar, config.lidar, arguments.request.seed};
  }
  if (!attack.plans.empty()) {
    setPlans(attack.plans, bag_attack.attack);
    bag_attack.tested_report.decision = bag_attack.attack.decision;
  }
  ProgressLine progress("writing");
  const InjectionNotes notes = injectIntoBag(arguments.bag, arguments.out, bag_attack,
                                             {scene.ego, config.ego_vehicle.center_offset,
                                              config.attack.verification, config.attacked_bag},
                                             [&](double share) { progress.show(share); });
  printWarnings(arguments.out, notes.warnings);
  return {bag_attack, notes};
}

/// Writes the animation of the clouds around the contact, and prints its name; nothing if no cloud
/// was changed then.
void drawClouds(const Arguments& arguments, const CollisionReport& tested, const Track& ego,
                double now, const Config& config) {
  constexpr double kBefore = 3.0;      // s before the contact
  constexpr double kAfter = 0.2;       // s after it
  constexpr std::size_t kClouds = 24;  // a small file
  const double end = tested.contact ? tested.contact_time : now + arguments.request.tta;
  const std::vector<CloudPair> pairs = readCloudPairs(arguments.bag, arguments.out, arguments.lidar,
                                                      {end - kBefore, end + kAfter, kClouds});
  if (pairs.empty()) return;
  const std::string path = arguments.draw + "_lidar.gif";
  const OrientedBox box{{config.ego_vehicle.center_offset, 0.0, 0.0}, ego.size};
  drawCloudsGif(path, pairs, box, config.drawing);
  std::cout << "wrote " << path << "\n";
}

int inject(const Arguments& arguments) {
  checkOutputs(arguments);
  const OutputLock lock = OutputLock::ofFile(arguments.out);
  collision_forge::CollisionRequest asked = arguments.request;
  asked.mode = toString(arguments.mode);
  Config config = loadConfig(arguments.config);
  auto& seconds_after_stand = config.attacked_bag.seconds_after_stand;
  seconds_after_stand = arguments.seconds_after_stand.value_or(seconds_after_stand);
  const auto parsed = fromMessage(asked, config.crash);
  if (const Status* refusal = std::get_if<Status>(&parsed)) return refuse(*refusal);
  CollisionRequest request = std::get<CollisionRequest>(parsed);
  arguments.controls.applyTo(request);
  // Alternatives are sorted by confidence, so request all of them before choosing one.
  request.alternatives = arguments.alternative == 1 ? 1 : kMaxAlternatives;
  const IndexedScene recording = readRecording(arguments.bag, config);
  const Scene& scene = recording.scene;
  requireNoAttack(arguments.bag);

  const double now = frameTimeOf(scene, arguments.now);
  Moment moment =
      std::get<Moment>(momentAt(recording, now, config.attack.prediction.history_frames));
  const MethodMaker maker = loadMethod(arguments.method, config, config.attack);
  const auto [attack, plans, _] = answerOf(maker, moment, scene, request, arguments, config);
  if (attack.status.code != StatusCode::kOk) return refuse(attack.status);
  request = withTypeOf(request, attack);
  addSupports(attack.supports, moment.snapshot);
  addSupports(attack.supports, *moment.recorded);
  CollisionReport tested =
      verify(attack.trajectory, {moment.snapshot, *moment.recorded, request, *moment.lanes},
             config.attack.verification);
  tested.confidence = attack.report.confidence;
  if (tested.contact) tested.careful_drivers = driveCarefully(*moment.recorded, attack.trajectory);
  const WrittenBag bag = writeAttackedBag({attack, plans, tested, request, now}, scene,
                                          maker.name(), arguments, config);
  const BagAttack& written = bag.attack;
  const Track& recorded_ego = moment.recorded->ego;
  const bool is_untested = endsBeforeContact(recorded_ego, attack.pattern, tested);
  const auto crash = motionAfterContact(tested, attack.trajectory, recorded_ego,
                                        config.attack.verification.severity);
  std::cout << "t0: " << now - scene.frame_times.front() << " s after the first frame\n"
            << "generated: " << summaryOf(written.attack) << "\n"
            << "against the recording: "
            << (is_untested ? formatted("it ends %.2f s after t0, before the contact",
                                        recorded_ego.states.back().time - now)
                            : lineOf(written.tested_report))
            << "\n"
            << aftermathOf(arguments.afterContact(), crash, is_untested, config.attacked_bag)
            << (arguments.afterContact() == AfterContact::kStop && crash
                    ? secondaryContactText(*crash, attack.trajectory.attacker_id,
                                           moment.recorded->agents)
                    : "")
            << "\n"
            << sensorText(bag, scene) << "wrote " << arguments.out << "\n";
  if (!arguments.draw.empty()) {
    ScenarioView view{scene.name,       request.tta,    request.mode,      moment.snapshot,
                      *moment.recorded, attack.pattern, attack.trajectory, tested};
    view.crash = crash;
    for (const SupportVehicle& support : attack.supports) {
      view.supports.push_back(support.motion.attacker_id);
    }
    view.seconds_after_stand = seconds_after_stand;
    view.lights = scene.lights;
    drawScenarioPng(arguments.draw + ".png", view, config.drawing);
    drawScenarioGif(arguments.draw + ".gif", view, config.drawing);
    std::cout << "wrote " << arguments.draw << ".png\nwrote " << arguments.draw << ".gif\n";
    if (!arguments.lidar.empty()) drawClouds(arguments, tested, recorded_ego, now, config);
  }
  return exitCodeOf(written.tested_report, is_untested, arguments);
}

}  // namespace

void addInject(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMakingCollisions, "inject",
                           "Adds a collision to a bag: a recorded or added vehicle hits the ego.",
                           [arguments] { return inject(*arguments); });
  auto& request = arguments->request;
  app.add_option("--bag", arguments->bag, "recorded bag, as written by forge convert")->required();
  app.add_option("--type", request.collision_type,
                 "requested collision type: " + collisionTypeWords())
      ->required()
      ->check(checkType);
  app.add_option("--tta", request.tta, "time to attack, s: time from t0 to contact")->required();
  app.add_option(
         "--now", arguments->now,
         "time of the request t0, s from the bag's first frame; uses the frame at or before")
      ->required();
  addAttacker(app, arguments->controls);
  addControls(app, arguments->controls);
  app.add_option("--alternative", arguments->alternative,
                 "which attack to write; 1 (default): the first choice of the method; 2 and more: "
                 "alternatives with another attacker or manoeuvre, highest confidence first")
      ->check(CLI::Range(1, kMaxAlternatives));
  addMethod(app, arguments->method, arguments->config);
  addMode(app, arguments->mode, true);
  addSeed(app, request.seed, "random seed of the candidates");
  arguments->after_contact_option = addChoice<AfterContact>(
      app, "--after-contact", arguments->after_contact,
      {{"stop", AfterContact::kStop},
       {"end", AfterContact::kEnd},
       {"drive_on", AfterContact::kDriveOn}},
      "content of the bag after the contact; stop: both vehicles move by the "
      "impact until they stand, the ego's /tf and odom are rewritten; end: the "
      "bag ends shortly after (default with --lidar); drive_on: the ego "
      "continues as recorded");
  app.add_option("--lidar", arguments->lidar,
                 "also show the attacker in the lidar clouds of these topics; auto: in all clouds "
                 "except radar clouds (docs/lidar.md)");
  app.add_option("--seconds-after-stand", arguments->seconds_after_stand,
                 "time, s, that bag and animation continue after both vehicles have stopped; "
                 "default: seconds_after_stand of attacked_bag.yaml")
      ->check(CLI::NonNegativeNumber);
  addOut(app, arguments->out, "output bag");
  app.add_option(
      "--draw", arguments->draw,
      "also write pictures to this name + .png and .gif, and with --lidar clouds from above "
      "to this name + _lidar.gif");
  addConfig(app, arguments->config);
  app.footer(
      "Exit codes: 0 success, 1 error, 2 invalid command line, 3 no collision as requested. With "
      "3, either no attack is possible, or the bag is written but its attack does not hit the "
      "recorded ego as requested; the last line then says so.");
}

}  // namespace forge
