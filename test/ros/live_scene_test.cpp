#include "collision_forge/ros/markers/live_scene.h"

#include <collision_forge/Agent.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/markers/label_places.h"
#include "collision_forge/ros/markers/marker_colors.h"

namespace forge {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

collision_forge::AgentTrack track(const std::string& id, std::uint8_t agent_class, double x,
                                  double y) {
  collision_forge::AgentTrack track;
  track.id = id;
  track.agent_class = agent_class;
  track.size.x = 4.6;
  track.size.y = 1.9;
  for (int i = 0; i < 3; ++i) {
    collision_forge::TrackState state;
    state.stamp = ros::Time(11.0 + 0.5 * i);
    state.pose.x = x + 4.0 * (i - 2);
    state.pose.y = y;
    state.velocity_x = 8.0;
    track.states.push_back(state);
  }
  return track;
}

/// The newest frame is of 12 s, the attack of 10 s to 15 s with its contact at 13 s.
class LiveSceneTest : public testing::Test {
 protected:
  LiveSceneTest() {
    scene_.header.frame_id = "map";
    scene_.header.stamp = ros::Time(12.0);
    scene_.ego = track("ego", collision_forge::Agent::CAR, 0.0, 0.0);
    scene_.agents = {track("0123456789abcdef", collision_forge::Agent::CAR, 10.0, 10.0),
                     track("walker", collision_forge::Agent::PEDESTRIAN, 20.0, 20.0)};
    attack_.header.stamp = tested_.header.stamp = ros::Time(10.0);
    attack_.trajectory.attacker_id = tested_.attacker_id = scene_.agents[0].id;
    attack_.trajectory.size = attack_.pattern.ego_size = scene_.ego.size;
    for (int i = 0; i <= 5; ++i) {
      attack_.trajectory.points.emplace_back();
      attack_.trajectory.points.back().stamp = ros::Time(10.0 + i);
      attack_.trajectory.points.back().pose.position.x = 40.0 - 8.0 * i;
      attack_.trajectory.points.back().pose.orientation.z = 1.0;
    }
    attack_.report.contact = tested_.contact = true;
    attack_.report.contact_time = tested_.contact_time = ros::Time(13.0);
    attack_.report.attacker_at_contact.x = tested_.attacker_at_contact.x = 14.0;
    tested_.ego_at_contact.x = 9.4;
    live_.scene = &scene_;
    live_.now = ros::Time(12.25);
  }

  /// The ego at rest, hit from ahead by the attacker with 8 m/s at 13 s.
  void showCrash(double now) {
    const SeverityOptions severity =
        loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack.verification.severity;
    const BoxSize size{4.6, 1.9};
    live_.attack = &attack_;
    live_.now = ros::Time(now);
    live_.crash.emplace(
        CrashedVehicle{AgentClass::kCar, size, {13.0, {9.4, 0.0, 0.0}, {0.0, 0.0}}},
        CrashedVehicle{AgentClass::kCar, size, {13.0, {14.0, 0.0, M_PI}, {-8.0, 0.0}}}, severity);
  }

  std::vector<Marker> shown(const std::string& name) const {
    const MarkerArray array = liveMarkers(live_);
    EXPECT_EQ(array.markers[0].action, Marker::DELETEALL);
    std::vector<Marker> found;
    std::copy_if(array.markers.begin(), array.markers.end(), std::back_inserter(found),
                 [&](const Marker& marker) { return marker.ns == name; });
    return found;
  }

  collision_forge::SceneSnapshot scene_;
  collision_forge::Attack attack_;
  collision_forge::CollisionReport tested_;
  LiveScene live_;
};

TEST_F(LiveSceneTest, ShowsShortIdsOfPossibleAttackersNearTheEgo) {
  ASSERT_EQ(shown("ids").size(), 1U);
  EXPECT_EQ(shown("ids")[0].text, "012345");
  for (auto& state : scene_.agents[0].states) state.pose.x += 100.0;
  EXPECT_TRUE(shown("ids").empty());
}

TEST_F(LiveSceneTest, ShowsNoAgentThatLeftOrHasNoExtent) {
  scene_.agents[0].states.pop_back();
  scene_.agents[1].states.back().pose.theta = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(shown("agents").empty());
  scene_ = {};
  EXPECT_EQ(liveMarkers(live_).markers.size(), 1U);
  EXPECT_FALSE(shownArea(live_));
}

TEST_F(LiveSceneTest, ShowsSupportVehiclesOfARunningAttackOnceAndInTheirColour) {
  for (const char* id : {"walker", "parked-1"}) {
    auto& support = attack_.supports.emplace_back();
    support.motion = attack_.trajectory;
    support.motion.attacker_id = id;
  }
  EXPECT_TRUE(shown("supports").empty()) << "before the attack";
  EXPECT_EQ(shown("agents").size(), 2U);
  live_.attack = &attack_;
  ASSERT_EQ(shown("supports").size(), 2U);
  EXPECT_EQ(shown("supports")[0].color, colors::toMessage(colors::kSupport));
  EXPECT_NEAR(shown("supports")[0].pose.position.x, 40.0 - 8.0 * 2.25, 1e-6);
  EXPECT_TRUE(shown("agents").empty()) << "neither the attacker nor a support vehicle";
  live_.now = ros::Time(16.0);
  EXPECT_EQ(shown("supports").size(), 2U) << "they stand after the last point";
  attack_.supports[0].motion.points.back().speed = 5.0;
  EXPECT_EQ(shown("supports").size(), 1U) << "one drove on";
}

TEST_F(LiveSceneTest, ShowsTheDrivenAttackerAndItsRecordedGhost) {
  live_.attack = &attack_;
  ASSERT_EQ(shown("attacker").size(), 1U);
  EXPECT_NEAR(shown("attacker")[0].pose.position.x, 22.0, 1e-6);
  EXPECT_EQ(shown("attacker")[0].color.r, colors::kAttacker.red);
  ASSERT_EQ(shown("recorded").size(), 1U);
  EXPECT_NEAR(shown("recorded")[0].pose.position.x, 12.0, 1e-6);
  EXPECT_LT(shown("recorded")[0].color.a, 0.5);
  EXPECT_EQ(shown("agents").size(), 1U);
  ASSERT_EQ(shown("words").size(), 1U);
  EXPECT_EQ(shown("words")[0].text.substr(0, 12), "contact in 0");
}

TEST_F(LiveSceneTest, ShowsTheCrashFromTheContactOnEvenBeforeTheVerdict) {
  showCrash(13.2);
  EXPECT_NEAR(shown("attacker")[0].pose.position.x, live_.crash->attackerAt(13.2).pose.x, 1e-6);
  EXPECT_NEAR(shown("ego")[0].pose.position.x, live_.crash->egoAt(13.2).pose.x, 1e-6);
  EXPECT_LT(shown("ego")[0].pose.position.x, 9.4 - 0.1) << "pushed back";
  EXPECT_EQ(shown("recorded").size(), 2U) << "ego and attacker";
  EXPECT_EQ(shown("contact").size(), 1U);
  EXPECT_EQ(shown("words")[0].text, "contact; verification follows");
}

TEST_F(LiveSceneTest, KeepsTheContactMarkAndTheTextInPlaceAfterTheContact) {
  showCrash(13.0);
  const Marker disc = shown("contact")[0];
  const Marker words = shown("words")[0];
  live_.now = ros::Time(13.6);
  EXPECT_EQ(shown("contact")[0].pose, disc.pose);
  EXPECT_EQ(shown("words")[0].pose, words.pose);
}

TEST_F(LiveSceneTest, KeepsTheTextInPlaceWhileOtherAgentsPass) {
  live_.attack = &attack_;
  const auto place_of_words = [this] {
    const auto position = shown("words")[0].pose.position;
    return std::pair(position.x, position.y);
  };
  const auto before = place_of_words();
  for (auto& state : scene_.agents[1].states) {
    state.pose.x = before.first;
    state.pose.y = before.second;
    state.velocity_x = 0.0;
  }
  EXPECT_EQ(place_of_words(), before);
}

TEST_F(LiveSceneTest, PlacesTheVerdictBesideThePathsOfOtherAgents) {
  showCrash(13.2);
  live_.verdict = &tested_;
  const auto place = [this] {
    const Marker words = shown("words_plate")[0];
    return OrientedBox{{words.pose.position.x, words.pose.position.y, 0.0},
                       {words.scale.x, words.scale.y}};
  };
  scene_.agents[1] = track("passing", collision_forge::Agent::CAR, -10.0, place().center.y);
  scene_.header.stamp = ros::Time(12.0);
  EXPECT_TRUE(overlaps(place(), {{14.0, place().center.y, 0.0}, {60.0, 1.9}}));
  live_.words_obstacles = coveredByOthers(live_);
  for (const OrientedBox& covered : live_.words_obstacles) {
    EXPECT_FALSE(overlaps(place(), covered));
  }
  EXPECT_EQ(live_.words_obstacles.size(), 1U) << "the attacker is no other";
}

TEST_F(LiveSceneTest, ShowsEgoAttackerAndContact) {
  attack_.report.attacker_at_contact.x = 74.0;
  attack_.report.ego_at_contact.x = 69.0;
  live_.attack = &attack_;
  const ShownArea area = *shownArea(live_);
  for (double x : {2.0, 22.0, 69.0, 74.0}) {
    EXPECT_GT(x, area.lowest.x());
    EXPECT_LT(x, area.highest.x());
  }
  const Marker words = shown("words")[0];
  EXPECT_LT(words.pose.position.y + words.scale.z, area.highest.y());
  EXPECT_GT(words.pose.position.y - words.scale.z, area.lowest.y());
  const double half = textSize(words.text, words.scale.z).length / 2;
  EXPECT_LT(words.pose.position.x + half, area.highest.x());
  EXPECT_GT(words.pose.position.x - half, area.lowest.x());
}

}  // namespace
}  // namespace forge
