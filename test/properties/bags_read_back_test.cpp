// Attacks in bags and MCAP files are read back and verified against the motion in the same file.
#include <collision_forge/AgentArray.h>
#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>

#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/ros/bags/bag_reader.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "collision_forge/ros/bags/mcap_export.h"
#include "collision_forge/ros/injection/injection.h"
#include "collision_forge/ros/messages/attack_request.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "io/logs/nuscenes_fixture.h"
#include "properties/same_verdict.h"
#include "ros/mcap_contents.h"

namespace forge {
namespace {

constexpr double kBagShare = 0.1;

/// The bags of the recordings, each written at its first use, and one bag with an attack.
class Bags {
 public:
  /// Returns the path of the recording's bag with the attack in it.
  std::string inject(const Scenario& scenario, const AskedMoment& asked, AfterContact after) {
    const Config& config = embeddedConfig();
    const CollisionReport tested = testedReport(scenario.answer.trajectory, asked);
    BagAttack attack;
    attack.attack = toMessage(scenario.answer, "search", asked.now);
    attack.tested_report = toMessage(tested, scenario.answer.trajectory.attacker_id, asked.now);
    attack.request = attackRequest(asked.request, attack.attack, "of a test", 1);
    attack.after_contact = after;
    const std::string path = folder_.path() + "/attacked.bag";
    injectIntoBag(bagOf(scenario.asked.scene), path, attack,
                  {asked.recording->scene.ego, config.ego_vehicle.center_offset,
                   config.attack.verification, config.attacked_bag});
    return path;
  }

  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }

 private:
  std::string bagOf(const std::string& scene) {
    const std::string path = folder_.path() + "/" + scene + ".bag";
    if (std::filesystem::exists(path)) return path;
    const LoggedScene logged = logs_->recording(scene);
    writeBag(path, logged.recording, logged.lanes->map());
    return path;
  }

  const TemporaryFolder folder_;
  const std::unique_ptr<SceneReader> logs_ =
      nuScenesFormat().open(embeddedLogs(), {{}, embeddedConfig(), {}, {}});
};

/// Returns the recording of a bag with t0 and the request of its attack.
AskedMoment askedIn(const std::string& bag, const Scenario& read) {
  IndexedScene indexed{readBag(bag, embeddedConfig()), nullptr};
  indexed.lanes = std::make_shared<const LaneIndex>(indexed.scene.map);
  return {std::make_shared<const IndexedScene>(std::move(indexed)), read.asked.now,
          read.asked.request};
}

/// Writes random attacks to bags and calls `check` for each.
void forAttackedBags(
    const std::function<void(Random&, const AskedMoment&, const Scenario&)>& check) {
  forAllCases(
      [&](Random& random) {
        const AskedMoment asked = randomRequest(random, kAllModes);
        const Scenario scenario = answered(asked);
        if (scenario.answer.status.code == StatusCode::kOk) check(random, asked, scenario);
      },
      kBagShare);
}

TEST(BagsReadBack, AnAttackedBagHasTheAttackItsRequestAndTheSameVerdict) {
  Bags bags;
  forAttackedBags([&](Random& random, const AskedMoment& asked, const Scenario& scenario) {
    const AfterContact after = isLikely(random, 0.5)   ? AfterContact::kStop
                               : isLikely(random, 0.5) ? AfterContact::kEnd
                                                       : AfterContact::kDriveOn;
    SCOPED_TRACE(toString(after));
    const std::string bag = bags.inject(scenario, asked, after);
    const Scenario read = readAttack(bag, embeddedConfig(), embeddedConfig().crash);
    const AskedMoment there = askedIn(bag, read);
    const SceneRequest request{scenario.asked.scene, there.now, there.request};
    EXPECT_EQ(requestLine(request), requestLine(scenario.asked));
    EXPECT_EQ(there.request.mode, asked.request.mode);
    expectSameVerdict(read.answer.trajectory, scenario.answer.trajectory, asked);
    expectSameVerdict(read.answer.trajectory, there, scenario.answer.trajectory, asked);
  });
}

template <typename Message>
Message messageIn(const McapMessage& read) {
  Message message;
  std::string bytes = read.bytes;
  ros::serialization::IStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, message);
  return message;
}

/// Returns the motion of ego and attacker in the messages up to the record's end, s from its start.
ReadCrash crashIn(const McapContents& contents, const CrashRecord& written) {
  ReadCrash read{written.ego, written.attacker, true};
  read.ego.states.clear();
  read.attacker.states.clear();
  const double begin = written.scenario.asked.now - written.now;
  const auto add = [&](const AgentState& state, Track& track) {
    track.states.push_back({state.time - begin, state.pose, state.velocity});
    if (track.states.back().time > written.end()) track.states.pop_back();
  };
  const Pose2 ahead{written.scenario.ego.center_offset, 0.0, 0.0};
  for (const McapMessage& message : contents.of(names::kTf)) {
    for (const auto& transform : messageIn<tf2_msgs::TFMessage>(message).transforms) {
      const Pose2 base = fromMessage(transform.transform);
      add({transform.header.stamp.toSec(), compose(base, ahead)}, read.ego);
    }
  }
  for (const McapMessage& message : contents.of(bagTopic(names::kAgents))) {
    for (const Track& agent : fromMessage(messageIn<collision_forge::AgentArray>(message))) {
      if (agent.id == written.attacker.id) add(agent.states.front(), read.attacker);
    }
  }
  return read;
}

TEST(BagsReadBack, AnMcapFileHasTheAttackAndShowsTheSameCrash) {
  Bags bags;
  const Config& config = embeddedConfig();
  const LaneArcs no_arcs;
  forAttackedBags([&](Random& /*random*/, const AskedMoment& asked, const Scenario& scenario) {
    const CrashRecord record =
        crashRecord(scenario, 1, config.exports.history,
                    {*asked.recording, no_arcs, config.exports, config.attack.verification});
    const std::string path = bags.path("attacked.mcap");
    exportToMcap(bags.inject(scenario, asked, AfterContact::kStop), path, config);
    const McapContents contents(contentOf(path));
    const auto attack =
        messageIn<collision_forge::Attack>(contents.of(bagTopic(names::kAttack)).at(0));
    expectSameVerdict(fromMessage(attack.trajectory), scenario.answer.trajectory, asked);
    expectSameCrash(crashIn(contents, record), record, asked);
  });
}

}  // namespace
}  // namespace forge
