#include "properties/random_scenes.h"

#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/io/answers/request_solver.h"
#include "collision_forge/io/weights/pattern_network_file.h"

namespace forge {
namespace {

constexpr std::size_t kScenes = 10;  // of data/embedded

SceneSource& embeddedScenes() {
  static SceneSource scenes(embeddedLogs(), {}, embeddedConfig(), kScenes);
  return scenes;
}

const MethodMaker& searchMaker() {
  static const MethodMaker maker = loadMethod("search", embeddedConfig(), embeddedConfig().attack);
  return maker;
}

}  // namespace

const StudyConfig& embeddedConfig() {
  static const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config;
}

LogSource embeddedLogs() { return {COLLISION_FORGE_SOURCE_DIR "/data/embedded", "v1.0-embedded"}; }

Moment AskedMoment::moment() const {
  return std::get<Moment>(
      momentAt(*recording, now, embeddedConfig().attack.prediction.history_frames));
}

AskedMoment randomRequest(Random& random, const std::vector<Mode>& modes) {
  AskedMoment asked;
  asked.recording = embeddedScenes().at(oneOf(embeddedScenes().names(), random));
  const std::vector<double>& frames = asked.recording->scene.frame_times;
  asked.now = frames[2 + random.index(frames.size() - 12)];
  CollisionRequest& request = asked.request;
  request.crash = embeddedConfig().crash;
  request.type = oneOf(kAllCollisionTypes, random);
  request.tta = random.uniform(1.0, 5.0);
  request.mode = oneOf(modes, random);
  request.seed = random.index(1000);
  if (isLikely(random, 0.2)) request.choice = AttackerChoice::kNew;
  request.crash.believable = isLikely(random, 0.7);
  return asked;
}

Attack answerTo(const AskedMoment& asked) {
  return generateCollision(*searchMaker().makeWithoutScene(asked.recording->scene.name),
                           asked.moment(), asked.request, embeddedConfig().attack.prediction);
}

Scenario answered(const SceneRequest& asked) {
  const StudyConfig& config = embeddedConfig();
  return RequestSolver(embeddedScenes(), searchMaker(), asked.request.crash, config.ego_vehicle,
                       config.adaptive)
      .answer(asked);
}

CollisionReport testedReport(const AttackerTrajectory& trajectory, const AskedMoment& asked) {
  const Moment moment = asked.moment();
  return verify(trajectory, {moment.snapshot, *moment.recorded, asked.request, *moment.lanes},
                embeddedConfig().attack.verification);
}

}  // namespace forge
