#include "collision_forge/study/evaluation/clip_cases.h"

#include <filesystem>
#include <utility>

#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/base/files/file_fingerprint.h"
#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/io/collide/collide_scene.h"
#include "collision_forge/io/logs/city_maps.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/evaluation/clip_attackers.h"
#include "collision_forge/study/evaluation/clip_question.h"
#include "collision_forge/study/evaluation/published_planner.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// Returns the recorded relative pose of ego and attacker at t0 + TTA as the collision pattern,
/// because the data set defines none.
CollisionPattern patternOf(const PlannerCase& one, const PredictionOptions& prediction) {
  const CrashScenario& scenario = one.scenario;
  const double time = scenario.snapshot.now + one.request.tta;
  CollisionPattern pattern;
  pattern.type = one.request.type;
  pattern.attacker_id = scenario.attacker.attacker_id;
  pattern.time = time;
  pattern.tolerance = prediction.pattern_tolerance;
  const auto ego = stateAt(scenario.recorded.ego, time);
  const auto attacker = stateAt(attackerTrack(scenario), time);
  if (!ego || !attacker) return pattern;
  pattern.ego = {ego->pose, scenario.ego.size};
  pattern.attacker_offset = relativeTo(ego->pose, attacker->pose);
  pattern.attacker_speed = attacker->velocity.norm();
  return pattern;
}

/// Returns the attack of the method on a clip.
Attack answerTo(const CollideClip& clip, const PlannerCase& one, const MethodMaker& method,
                const StudyOptions& study, ClipAttacks answers) {
  const CrashScenario& scenario = one.scenario;
  const std::unique_ptr<const AttackMethod> made = method.makeWithoutScene(one.scene);
  if (answers == ClipAttacks::kAll) {
    const ClipQuestion question(clip, scenario.lanes, one.request.mode, study);
    return question.answer(method, *made, one.request.seed);
  }
  const Moment moment{scenario.snapshot, scenario.recorded, scenario.lanes};
  return generateCollision(*made, moment, one.request, study.attack.prediction);
}

constexpr EnumWord<ClipAttacker> kAttackerWords[] = {
    {ClipAttacker::kRecorded, "recorded"},
    {ClipAttacker::kHistory, "history"},
    {ClipAttacker::kReplay, "replay"},
};

class ClipCases : public PlannerCases {
 public:
  ClipCases(std::vector<std::string> paths, const std::string& dataroot, ClipAttacker attacker,
            const std::string& method, ClipAttacks answers, const StudyOptions& study)
      : paths_(std::move(paths)),
        attacker_(attacker),
        answers_(answers),
        study_(study),
        maps_(dataroot, study),
        method_(loadMethod(method, study, study.attack)) {
    for (const std::string& path : paths_) names_.push_back(fs::path(path).stem().string());
  }

  const std::vector<std::string>& names() const override { return names_; }

  std::string fingerprint() const override {
    return "clips, attacker " + std::string(wordOf(kAttackerWords, attacker_)) + " by " +
           method_.name() + (answers_ == ClipAttacks::kAll ? ", unverified" : "") + ", " +
           fingerprintOfFiles(paths_);
  }

  PlannerCase at(std::size_t index) const override {
    const CollideClip clip = readCollideClip(paths_[index], study_.input_limits);
    PlannerCase one = caseOfClip(clip, attacker_, maps_.at(clip.city), method_, study_, answers_);
    one.source = wordOf(kAttackerWords, attacker_);
    return one;
  }

 private:
  std::vector<std::string> paths_;
  std::vector<std::string> names_;
  ClipAttacker attacker_;
  ClipAttacks answers_;
  const StudyOptions& study_;
  mutable CityMaps maps_;
  MethodMaker method_;
};

}  // namespace

PlannerCase caseOfClip(const CollideClip& clip, ClipAttacker attacker,
                       std::shared_ptr<const LaneIndex> lanes, const MethodMaker& method,
                       const StudyOptions& study, ClipAttacks answers) {
  const BoxSize& box = study.evaluation.collide.box;
  const Scene scene = toScene(clip, study.evaluation.collide, lanes->sharedMap());
  PlannerCase one;
  one.name = clip.name;
  one.scene = clip.scene;
  one.request = requestOf(clip, attacker == ClipAttacker::kReplay ? Mode::kReplay : Mode::kHistory,
                          study.attack.prediction.min_tta, withClipRules(study.crash));
  one.scenario = {snapshotAt(scene, clip.now(), study.attack.prediction.history_frames),
                  recordedFuture(scene, clip.now()),
                  {},
                  clip.type,
                  {box, study.ego_vehicle.center_offset},
                  std::move(lanes)};
  if (attacker == ClipAttacker::kRecorded) {
    one.scenario.attacker = recordedAttacker(clip, box, study.attack.search);
    one.pattern = patternOf(one, study.attack.prediction);
    one.published = publishedProtocol(clip, study.evaluation.published);
    return one;
  }
  Attack answer = answerTo(clip, one, method, study, answers);
  one.status = answer.status;
  one.scenario.attacker = std::move(answer.trajectory);
  if (one.status.code == StatusCode::kOk) {
    one.published =
        publishedProtocol(withAttacker(clip, one.scenario.attacker), study.evaluation.published);
  }
  one.pattern = answer.pattern;
  one.effort = answer.effort;
  return one;
}

std::unique_ptr<PlannerCases> openClipCases(const std::vector<std::string>& paths,
                                            const std::string& dataroot, ClipAttacker attacker,
                                            const std::string& method, ClipAttacks answers,
                                            const StudyOptions& study) {
  return std::make_unique<ClipCases>(paths, dataroot, attacker, method, answers, study);
}

}  // namespace forge
