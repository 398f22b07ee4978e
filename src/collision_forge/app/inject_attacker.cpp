#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <utility>

#include "collision_forge/app/tool_support.h"
#include "collision_forge/attack/generator.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/drawing/draw_scenario.h"
#include "collision_forge/ros/bag_reader.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/injection.h"
#include "collision_forge/settings/config.h"

namespace {

using namespace forge;

namespace fs = std::filesystem;

struct Arguments {
  std::string bag;
  std::string out;
  std::string draw;
  std::string config;
  double now = 0.0;
  collision_forge::CollisionRequest request;
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
            << ", impact speed " << report.impact_speed << " m/s, "
            << (report.bounds_kept ? "bounds kept" : report.broken_bound)
            << (report.first_other_id.empty() ? ""
                                              : ", touches " + report.first_other_id + " first")
            << ", " << 100.0 * report.off_road_share << " % off road\n";
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

int inject(const Arguments& arguments) {
  checkOutputs(arguments);
  const auto parsed = fromMessage(arguments.request);
  if (const Status* refusal = std::get_if<Status>(&parsed)) return refuse(*refusal);
  const auto& request = std::get<CollisionRequest>(parsed);
  const Config config = loadConfig(arguments.config);
  std::vector<std::string> warnings;
  const Scene scene = readBag(arguments.bag, config.ego_vehicle, &warnings);
  printWarnings(arguments.bag, warnings);

  const double now = frameAt(scene, arguments.now);
  const LaneIndex lanes(scene.map);
  const Snapshot snapshot = snapshotAt(scene, now, config.attack.prediction.history_frames);
  const Future recorded = recordedFuture(scene, now);
  const auto predictor = loadForesight(config).patterns(config.attack);
  const Realization attack =
      generateCollision(request, snapshot, lanes, &recorded, *predictor, config.attack);
  if (attack.status.code != StatusCode::kOk) return refuse(attack.status);
  CollisionReport tested =
      verify(attack.trajectory, {snapshot, recorded, request, lanes}, config.attack);
  tested.confidence = attack.report.confidence;
  const std::string& attacker = attack.trajectory.attacker_id;
  injectIntoBag(arguments.bag, arguments.out,
                {toMessage(attack.pattern, now), toMessage(attack.trajectory),
                 toMessage(attack.report, attacker, now), toMessage(tested, attacker, now)});
  std::cout << toString(request.type) << " by " << attacker
            << ", now = " << now - scene.frame_times.front() << " s, confidence "
            << attack.report.confidence << "\n";
  printReport("generated", attack.report, now);
  printReport("against the recording", tested, now);
  std::cout << "wrote " << arguments.out << "\n";
  if (!arguments.draw.empty()) {
    const ScenarioView view{scene.name, request.tta,    request.mode,      snapshot,
                            recorded,   attack.pattern, attack.trajectory, tested};
    drawScenarioPng(arguments.draw + ".png", view, config.drawing);
    drawScenarioGif(arguments.draw + ".gif", view, config.drawing);
    std::cout << "wrote " << arguments.draw << ".png\nwrote " << arguments.draw << ".gif\n";
  }
  return kExitOk;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Makes an agent of a recorded bag crash into the ego, and writes the attacked bag.",
               "inject_attacker");
  app.add_option("--bag", arguments.bag, "recorded bag, as from nuscenes_to_bag")->required();
  app.add_option(
         "--type", arguments.request.collision_type,
         "lane_change, opposite_direction, rear_end, junction_crossing or ltap (LC, OD, HO, "
         "RE, JC, LTAP)")
      ->required();
  app.add_option("--tta", arguments.request.tta, "seconds from now to impact, 0.5 to 9")
      ->required();
  app.add_option("--now", arguments.now,
                 "seconds from the bag's first frame; the frame at or before")
      ->required();
  app.add_option("--attacker", arguments.request.attacker_id, "agent id; any by default");
  app.add_option("--mode", arguments.request.mode,
                 "history: use only what was seen up to now; replay: use the recorded future")
      ->check(CLI::IsMember({"history", "replay"}))
      ->default_str("history");
  app.add_option("--seed", arguments.request.seed, "of the variations tried")
      ->capture_default_str();
  app.add_option("--out", arguments.out, "bag to write")->required();
  app.add_option("--draw", arguments.draw, "also draw to this name + .png and .gif");
  addConfigOption(app, arguments.config);
  return runTool(app, argc, argv, [&] { return inject(arguments); });
}
