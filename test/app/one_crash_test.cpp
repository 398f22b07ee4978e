// One attack, 1 s after its contact, compared between all outputs that show it.
#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <boost/make_shared.hpp>

#include "collision_forge/attack/verify/contact_watch.h"
#include "collision_forge/io/drawing/scenario_motion.h"
#include "collision_forge/io/export/crash_record.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/report/attack_record.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/bag_reader.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "collision_forge/ros/injection/injection.h"
#include "collision_forge/ros/injection/live_injector.h"
#include "collision_forge/ros/markers/live_scene.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "io/logs/nuscenes_fixture.h"
#include "planner_test/report/decoded_motion.h"

namespace forge {
namespace {

constexpr double kTolerance = 0.1;  // m
constexpr double kAfter = 1.0;      // s after the contact
constexpr const char* kAttacker = "crossing";

struct Places {
  Vector2 ego;
  Vector2 attacker;
};

/// Returns the position at `time` (s), interpolated linearly.
Vector2 placeAt(const std::vector<std::pair<double, Vector2>>& samples, double time) {
  const auto after = std::find_if(samples.begin(), samples.end(),
                                  [=](const auto& sample) { return sample.first >= time; });
  if (after == samples.begin() || after == samples.end()) throw std::out_of_range("no such time");
  const auto& [begin, from] = *std::prev(after);
  return from + (time - begin) / (after->first - begin) * (after->second - from);
}

/// An added car crosses the road of an embedded recording, and the ego drives into it.
class OneCrash : public testing::Test {
 protected:
  OneCrash() {
    const LogSource logs{COLLISION_FORGE_SOURCE_DIR "/data/embedded", "v1.0-embedded"};
    const LoggedScene logged =
        nuScenesFormat().open(logs, {{}, config_, {}, {}})->recording("scene-0005");
    writeBag(recorded_, logged.recording, logged.lanes->map());
    recording_ = {readBag(recorded_, config_), logged.lanes};
    now_ = recording_.scene.frame_times[10];
    moment_ =
        std::get<Moment>(momentAt(recording_, now_, config_.attack.prediction.history_frames));
    makeAttack();
    inject();
  }

  /// Straight across the ego's path at 6 m/s, to the ego's position 4 s later.
  void makeAttack() {
    const Pose2 ego = stateAt(recording_.scene.ego, now_ + 4.0).value().pose;
    answer_.trajectory = {kAttacker, AgentClass::kCar, {4.5, 1.9}, {}};
    for (int i = 0; i <= 60; ++i) {
      const Pose2 pose = compose(ego, {0.0, 0.6 * (i - 40), M_PI / 2});
      answer_.trajectory.points.push_back({now_ + 0.1 * i, pose, 6.0, 0.0, 0.0});
    }
    answer_.pattern.ego = {ego, recording_.scene.ego.size};
    request_.tta = 4.0;
    request_.crash = config_.crash;
    report_ =
        verify(answer_.trajectory, {moment_.snapshot, *moment_.recorded, request_, *moment_.lanes},
               config_.attack.verification);
    answer_.report = report_;
    message_ = toMessage(answer_, "of a test", now_);
  }

  void inject() {
    BagAttack attack;
    attack.attack = message_;
    attack.tested_report = toMessage(report_, kAttacker, now_);
    injectIntoBag(recorded_, attacked_, attack,
                  {recording_.scene.ego, config_.ego_vehicle.center_offset,
                   config_.attack.verification, config_.attacked_bag});
  }

  double time() const { return report_.contact_time + kAfter; }
  std::optional<PostCrashMotion> motion() const {
    return motionAfterContact(report_, answer_.trajectory, moment_.recorded->ego,
                              config_.attack.verification.severity);
  }

  template <typename Message>
  std::vector<Message> read(const std::string& bag, const std::string& topic) const {
    const rosbag::Bag opened(bag, rosbag::bagmode::Read);
    std::vector<Message> messages;
    for (const auto& instance : rosbag::View(opened, rosbag::TopicQuery(topic))) {
      messages.push_back(*instance.instantiate<Message>());
    }
    return messages;
  }

  /// From /tf and agents of the bag.
  Places inBag() const {
    std::vector<std::pair<double, Vector2>> ego;
    for (const auto& message : read<tf2_msgs::TFMessage>(attacked_, names::kTf)) {
      const auto& transform = message.transforms.front();
      const Pose2 middle =
          compose(fromMessage(transform.transform), {config_.ego_vehicle.center_offset, 0.0, 0.0});
      ego.emplace_back(transform.header.stamp.toSec(), middle.position());
    }
    return {placeAt(ego, time()),
            attackerIn(read<collision_forge::AgentArray>(attacked_, bagTopic(names::kAgents)))};
  }

  Vector2 attackerIn(const std::vector<collision_forge::AgentArray>& frames) const {
    std::vector<std::pair<double, Vector2>> places;
    for (const auto& frame : frames) {
      for (const auto& agent : frame.agents) {
        if (agent.id != kAttacker) continue;
        places.emplace_back(frame.header.stamp.toSec(), fromMessage(agent.pose).position());
      }
    }
    return placeAt(places, time());
  }

  Vector2 boxIn(const visualization_msgs::MarkerArray& markers, const std::string& name) const {
    for (const auto& marker : markers.markers) {
      if (marker.ns == name) return {marker.pose.position.x, marker.pose.position.y};
    }
    throw std::out_of_range(name);
  }

  /// From attack_markers of the bag.
  Places inMarkersOfBag() const {
    std::vector<std::pair<double, Vector2>> ego;
    std::vector<std::pair<double, Vector2>> attacker;
    for (const auto& markers :
         read<visualization_msgs::MarkerArray>(attacked_, bagTopic(names::kAttackMarkers))) {
      const double stamp = markers.markers.front().header.stamp.toSec();
      if (stamp <= now_) continue;
      ego.emplace_back(stamp, boxIn(markers, "ego"));
      attacker.emplace_back(stamp, boxIn(markers, "attacker"));
    }
    return {placeAt(ego, time()), placeAt(attacker, time())};
  }

  /// From injected_agents during playback of the recording.
  Vector2 inInjectedAgents() const {
    std::vector<collision_forge::AgentArray> published;
    LiveInjector injector(config_, AfterContact::kStop,
                          [&](const auto& message) { published.push_back(message); });
    const auto frames = read<collision_forge::AgentArray>(recorded_, bagTopic(names::kAgents));
    auto next = frames.begin();
    bool is_attacked = false;
    for (const AgentState& ego : recording_.scene.ego.states) {
      injector.addEgo({ego.time, ego.pose});
      for (; next != frames.end() && next->header.stamp.toSec() <= ego.time; ++next) {
        injector.addFrame(boost::make_shared<collision_forge::AgentArray>(*next));
      }
      if (!is_attacked && ego.time >= now_) injector.setAttack(message_);
      is_attacked = ego.time >= now_;
    }
    return attackerIn(published);
  }

  /// From scene_markers during playback of the recording.
  Places inSceneMarkers() const {
    ContactWatch watch(config_.ego_vehicle.size, config_.live.maxAttackAge(),
                       config_.attack.verification);
    watch.start(answer_.trajectory);
    for (const AgentState& ego : recording_.scene.ego.states) {
      if (ego.time <= time()) watch.addEgo({ego.time, ego.pose});
    }
    const collision_forge::SceneSnapshot scene = toMessage(moment_.snapshot);
    LiveScene live;
    live.scene = &scene;
    live.now = ros::Time(time());
    live.attack = &message_;
    live.crash = watch.crash();
    const auto markers = liveMarkers(live);
    return {boxIn(markers, "ego"), boxIn(markers, "attacker")};
  }

  /// From the input of the drawing of PNG and GIF.
  Places inPicture() const {
    ScenarioView view{"scene-0005",       4.0,
                      Mode::kReplay,      moment_.snapshot,
                      *moment_.recorded,  answer_.pattern,
                      answer_.trajectory, report_};
    view.crash = motion();
    const ScenarioMotion shown(view);
    return {shown.egoAt(time())->center.position(), shown.attackerAt(time())->center.position()};
  }

  /// From the record of the attack in the HTML report.
  Places inPage() const {
    Scenario scenario;
    scenario.asked = {"scene-0005", now_, request_};
    scenario.answer = answer_;
    const std::string record =
        attackRecord(scenario, answer_, RecordedOutcome{report_, ShownCrash{motion().value(), 3.0}},
                     config_.attack.verification);
    const auto placeOf = [&](const std::string& who) {
      const std::size_t begin = record.find('"' + who + "\":{", record.find("\"crash\":"));
      const DecodedMotion motion = decodedMotion(record.substr(begin));
      std::vector<std::pair<double, Vector2>> places;
      for (std::size_t i = 0; i < motion.t.size(); ++i) {
        places.emplace_back(now_ + motion.t[i], Vector2(motion.x[i], motion.y[i]));
      }
      return placeAt(places, time());
    };
    return {placeOf("ego"), placeOf("other")};
  }

  /// From the input of OpenSCENARIO, CommonRoad and ScenarioNet.
  Places inExport() const {
    Scenario scenario;
    scenario.asked = {"scene-0005", now_, request_};
    scenario.answer = answer_;
    const CrashRecord record = crashRecord(
        scenario, 1, 2.0, {recording_, {}, config_.exports, config_.attack.verification});
    const double then = *record.contact + kAfter;
    return {stateAt(record.ego, then).value().pose.position(),
            stateAt(record.attacker, then).value().pose.position()};
  }

  void expectSame(const Places& places, const char* where) const {
    const Places expected = inBag();
    EXPECT_LT((places.ego - expected.ego).norm(), kTolerance) << where;
    EXPECT_LT((places.attacker - expected.attacker).norm(), kTolerance) << where;
  }

  const Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  const TemporaryFolder folder_;
  const std::string recorded_ = folder_.path() + "/scene-0005.bag";
  const std::string attacked_ = folder_.path() + "/attacked.bag";
  IndexedScene recording_;
  double now_ = 0.0;
  Moment moment_;
  CollisionRequest request_;
  Attack answer_;
  CollisionReport report_;
  collision_forge::Attack message_;
};

TEST_F(OneCrash, BothVehiclesMoveAfterTheContact) {
  ASSERT_TRUE(report_.contact);
  const Places places = inBag();
  const auto recorded = stateAt(recording_.scene.ego, time())->pose.position();
  EXPECT_GT((places.ego - report_.ego_at_contact.position()).norm(), 1.0);
  EXPECT_GT((places.attacker - report_.attacker_at_contact.position()).norm(), 1.0);
  EXPECT_GT((places.ego - recorded).norm(), 1.0) << "not as recorded";
}

TEST_F(OneCrash, IsTheSameInBagsAndTheirMarkers) { expectSame(inMarkersOfBag(), "attack_markers"); }

TEST_F(OneCrash, IsTheSameInBagsAndLive) {
  EXPECT_LT((inInjectedAgents() - inBag().attacker).norm(), kTolerance);
  expectSame(inSceneMarkers(), "scene_markers");
}

TEST_F(OneCrash, IsTheSameInBagsPicturesPagesAndExports) {
  expectSame(inPicture(), "picture");
  expectSame(inPage(), "page");
  expectSame(inExport(), "export");
}

TEST_F(OneCrash, EndsInBagsAndAnimationsAtTheSameTime) {
  ScenarioView view{"scene-0005",       4.0,
                    Mode::kReplay,      moment_.snapshot,
                    *moment_.recorded,  answer_.pattern,
                    answer_.trajectory, report_};
  view.crash = motion();
  view.seconds_after_stand = config_.attacked_bag.seconds_after_stand;
  const auto frames = read<collision_forge::AgentArray>(attacked_, bagTopic(names::kAgents));
  EXPECT_NEAR(frames.back().header.stamp.toSec(), ScenarioMotion(view).endTime(), 0.1);
  EXPECT_LT(frames.back().header.stamp.toSec(), recording_.scene.ego.states.back().time - 1.0);
}

}  // namespace
}  // namespace forge
