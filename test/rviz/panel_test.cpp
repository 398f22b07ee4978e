#include <collision_forge/Seek.h>
#include <collision_forge/TestPlanner.h>
#include <gmock/gmock.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>

#include <chrono>
#include <mutex>

#include "collision_forge/ros/rviz/generate_panel.h"
#include "collision_forge/ros/rviz/possible_table.h"

namespace forge {
namespace {

using collision_forge::GenerateCollision;
using collision_forge::ListCollisions;
using collision_forge::Seek;
using collision_forge::TestPlanner;
using testing::HasSubstr;

constexpr std::chrono::seconds kPatience{20};
const ros::Time kListed(1234.5);  // the instant of the list

collision_forge::Attack attackBy(const std::string& attacker, const std::string& manoeuvre) {
  collision_forge::Attack attack;
  attack.header.stamp = ros::Time::now();
  attack.pattern.collision_type = "lane_change";
  attack.trajectory.attacker_id = attacker;
  attack.trajectory.points.resize(1);
  attack.trajectory.points[0].stamp = attack.header.stamp + ros::Duration(200.0);
  attack.report.contact = attack.report.believable = true;
  attack.report.contact_time = attack.header.stamp + ros::Duration(100.0);
  attack.report.manoeuvre = manoeuvre;
  return attack;
}

/// Answers what the panel calls, in a thread of its own, and keeps what was asked.
class Suite {
 public:
  Suite() {
    node_.setCallbackQueue(&queue_);
    attack_ = node_.advertise<collision_forge::Attack>("attack", 1, true);
    paused_ = node_.advertise<std_msgs::Bool>("player/paused", 1, true);
    position_ = node_.advertise<std_msgs::Float64>("player/position", 1, true);
    length_ = node_.advertise<std_msgs::Float64>("player/length", 1, true);
    seek_ = node_.advertiseService("player/seek", &Suite::seek, this);
    test_planner_ = node_.advertiseService("test_planner", &Suite::testPlanner, this);
    length_.publish(seconds(20.0));
    position_.publish(seconds(5.0));
    generate_ = node_.advertiseService("generate_collision", &Suite::generate, this);
    list_ = node_.advertiseService("list_collisions", &Suite::list, this);
    pause_ = node_.advertiseService("player/pause", &Suite::pause, this);
    step_ = node_.advertiseService("player/step", &Suite::step, this);
    setPaused(false);
    spinner_.start();
  }
  ~Suite() { spinner_.stop(); }

  GenerateCollision::Request asked() {
    const std::lock_guard<std::mutex> guard(lock_);
    return asked_;
  }
  collision_forge::CollisionRequest listed() {
    const std::lock_guard<std::mutex> guard(lock_);
    return listed_;
  }
  double sought() {
    const std::lock_guard<std::mutex> guard(lock_);
    return sought_;
  }
  std::string tested() {
    const std::lock_guard<std::mutex> guard(lock_);
    return tested_;
  }

 private:
  static std_msgs::Float64 seconds(double value) {
    std_msgs::Float64 message;
    message.data = value;
    return message;
  }

  bool seek(Seek::Request& request, Seek::Response& response) {
    const std::lock_guard<std::mutex> guard(lock_);
    sought_ = request.instant;
    position_.publish(seconds(request.instant));
    response.success = true;
    return true;
  }

  bool testPlanner(TestPlanner::Request& request, TestPlanner::Response& response) {
    const std::lock_guard<std::mutex> guard(lock_);
    tested_ = request.planner;
    response.outcome.planner = request.planner;
    response.outcome.failure = "none";
    response.outcome.collided = response.outcome.is_attacker = true;
    response.outcome.contact_time = response.outcome.header.stamp + ros::Duration(3.5);
    response.outcome.impact_speed = 7.0;
    return true;
  }

  bool generate(GenerateCollision::Request& request, GenerateCollision::Response& response) {
    const std::lock_guard<std::mutex> guard(lock_);
    asked_ = request;
    if (request.seed == 13) return false;
    response.attack = attackBy("a1", "cut_in");
    response.alternatives = {attackBy("b2", "merge")};
    attack_.publish(response.attack);
    return true;
  }

  bool list(ListCollisions::Request& request, ListCollisions::Response& response) {
    const std::lock_guard<std::mutex> guard(lock_);
    listed_ = request.request;
    response.now = kListed;
    if (request.request.seed == 7) {
      response.message = "nothing is possible; no road\nsecond line";
      return true;
    }
    response.collisions.resize(2);
    response.collisions[0].alternative = response.collisions[1].alternative = 1;
    response.collisions[0].collision_type = "rear_end";
    response.collisions[0].attacker_id = "a1";
    response.collisions[0].confidence = 0.5;
    response.collisions[1].confidence = 0.75;
    response.collisions[1].collision_type = "lane_change";
    response.collisions[1].tta = 3.0;
    response.collisions[1].manoeuvre = "merge";
    response.collisions[1].attacker_id = "b2";
    return true;
  }

  bool pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
    setPaused(request.data);
    response.success = true;
    return true;
  }

  bool step(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    response.message = "nothing left to step to";
    return true;
  }

  void setPaused(bool is_paused) {
    std_msgs::Bool message;
    message.data = is_paused;
    paused_.publish(message);
  }

  ros::NodeHandle node_;
  ros::CallbackQueue queue_;
  ros::Publisher attack_;
  ros::Publisher paused_;
  ros::Publisher position_;
  ros::Publisher length_;
  ros::ServiceServer seek_;
  ros::ServiceServer test_planner_;
  ros::ServiceServer generate_;
  ros::ServiceServer list_;
  ros::ServiceServer pause_;
  ros::ServiceServer step_;
  std::mutex lock_;
  GenerateCollision::Request asked_;
  collision_forge::CollisionRequest listed_;
  double sought_ = 0.0;
  std::string tested_;
  ros::AsyncSpinner spinner_{2, &queue_};
};

class PanelTest : public testing::Test {
 protected:
  /// As RViz does, until it holds.
  template <typename Condition>
  bool comes(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!condition() && std::chrono::steady_clock::now() < end) {
      ros::spinOnce();
      QApplication::processEvents(QEventLoop::AllEvents, 10);
    }
    return condition();
  }

  QPushButton* button(const char* name) { return panel_.findChild<QPushButton*>(name); }
  std::string text(const char* name) {
    return panel_.findChild<QLabel*>(name)->text().toStdString();
  }
  bool says(const char* name, const char* words) {
    return comes([&] { return text(name).find(words) != std::string::npos; });
  }
  PossibleTable& table() { return *panel_.findChild<PossibleTable*>("possible"); }

  Suite suite_;
  GeneratePanel panel_;
};

TEST_F(PanelTest, ListsCollisionsDuringAPauseAndRequestsTheSelectedRow) {
  ASSERT_TRUE(comes([&] { return button("pause")->isEnabled(); }));
  button("list")->click();
  ASSERT_TRUE(comes([&] { return table().rowCount() == 2; })) << text("status");
  EXPECT_TRUE(comes([&] { return button("pause")->text() == "Play"; }));
  table().selectRow(1);
  button("generate")->click();
  ASSERT_TRUE(says("status", "2 attacks"));
  EXPECT_EQ(suite_.asked().collision_type, "lane_change");
  EXPECT_EQ(suite_.asked().tta, 3.0);
  EXPECT_EQ(suite_.asked().alternative, 1U);
  EXPECT_EQ(suite_.asked().attacker_id, suite_.listed().attacker_id)
      << "nothing that the list did not";
  EXPECT_EQ(suite_.asked().manoeuvre, suite_.listed().manoeuvre);
  EXPECT_EQ(suite_.asked().stamp, kListed);
  // The answer had two attacks, which are the rows now.
  table().selectRow(1);
  button("generate")->click();
  EXPECT_TRUE(comes([&] { return suite_.asked().alternative == 2U; }));
  EXPECT_EQ(suite_.asked().collision_type, "lane_change");
  EXPECT_EQ(suite_.asked().tta, 3.0);
}

TEST_F(PanelTest, ShowsWhyNothingIsPossibleWithTheFullReasonInTheTooltip) {
  panel_.findChild<QSpinBox*>("seed")->setValue(7);
  button("list")->click();
  ASSERT_TRUE(says("status", "no road"));
  EXPECT_EQ(text("status"), "nothing is possible; no road");
  EXPECT_THAT(panel_.findChild<QLabel*>("status")->toolTip().toStdString(),
              HasSubstr("second line"));
}

TEST_F(PanelTest, ListsCollisionsOfAnyTypeTimeAttackerAndManoeuvre) {
  panel_.findChild<QComboBox*>("type")->setCurrentText("lane_change");
  panel_.findChild<QComboBox*>("manoeuvre")->setCurrentText("merge");
  button("list")->click();
  ASSERT_TRUE(comes([&] { return table().rowCount() == 2; }));
  EXPECT_EQ(suite_.listed().collision_type, "");
  EXPECT_EQ(suite_.listed().tta, 0.0);
  EXPECT_EQ(suite_.listed().manoeuvre, "");
  EXPECT_EQ(suite_.listed().believable, "true");
}

TEST_F(PanelTest, RequestsForTheNewestSceneOnceTheRowIsDeselected) {
  ASSERT_TRUE(comes([&] { return button("step")->isEnabled(); }));
  const auto choose = [&] {
    button("list")->click();
    ASSERT_TRUE(comes([&] { return button("list")->isEnabled(); }));
    table().clearSelection();
    table().selectRow(1);
  };
  const auto asked = [&] {
    button("generate")->click();
    EXPECT_TRUE(comes([&] { return button("generate")->isEnabled(); }));
    return suite_.asked().stamp;
  };
  choose();
  panel_.findChild<QDoubleSpinBox*>()->setValue(2.5);
  EXPECT_EQ(asked(), ros::Time()) << "another time";
  choose();
  button("step")->click();
  EXPECT_EQ(asked(), ros::Time()) << "the player went on";
  choose();
  EXPECT_EQ(asked(), kListed);
}

TEST_F(PanelTest, RequestsTheMostConfidentCollisionUnlessATypeIsChosen) {
  ASSERT_TRUE(comes([&] { return button("pause")->isEnabled(); }));
  button("generate")->click();
  ASSERT_TRUE(says("status", "2 attacks"));
  EXPECT_EQ(suite_.asked().collision_type, "lane_change");
  EXPECT_EQ(suite_.asked().stamp, kListed);
}

TEST_F(PanelTest, ShowsAndSetsThePositionOfThePlayer) {
  auto* slider = panel_.findChild<QSlider*>("position");
  ASSERT_TRUE(comes([&] { return slider->value() == 50; }));
  EXPECT_TRUE(says("clock", "5.0 s of 20.0 s"));
  slider->setSliderDown(true);
  slider->setSliderPosition(125);
  slider->setSliderDown(false);
  EXPECT_TRUE(comes([&] { return suite_.sought() == 12.5; }));
  EXPECT_TRUE(says("clock", "12.5 s of 20.0 s"));
}

TEST_F(PanelTest, TestsAPlannerInTheNewestAttackAndShowsTheOutcome) {
  EXPECT_FALSE(button("test_planner")->isEnabled()) << "there is no attack yet";
  button("generate")->click();
  ASSERT_TRUE(says("attack", "by the recorded car a1"));
  panel_.findChild<QComboBox*>("planner")->setCurrentText("pdm");
  button("test_planner")->click();
  EXPECT_TRUE(says("status", "touches the attacker after 3.50 s, 7.0 m/s, not at fault"))
      << text("status");
  EXPECT_EQ(suite_.tested(), "pdm");
}

TEST_F(PanelTest, KeepsItsButtonsInPlaceForAnyStatusText) {
  panel_.resize(300, 900);
  panel_.show();
  ASSERT_TRUE(comes([&] { return button("step")->isEnabled(); }));
  const auto places = [this] {
    std::vector<QRect> rectangles;
    for (const QPushButton* one : panel_.findChildren<QPushButton*>()) {
      rectangles.push_back(one->geometry());
    }
    return rectangles;
  };
  QApplication::processEvents();
  const auto before = places();
  for (const char* name : {"status", "player_says", "crash", "attack"}) {
    panel_.findChild<QLabel*>(name)->setText(QString("words ").repeated(40));
  }
  button("pause")->setText("Play");
  QApplication::processEvents();
  const auto after = places();
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_TRUE(after[i] == before[i])
        << i << ": " << before[i].y() << " and " << before[i].height() << " high -> "
        << after[i].y() << " and " << after[i].height();
  }
}

TEST_F(PanelTest, ShowsTheAttackItsAlternativesAndTheCountdown) {
  button("generate")->click();
  ASSERT_TRUE(says("attack", "by the recorded car a1"));
  EXPECT_TRUE(says("crash", "contact in 9")) << text("crash");
  ASSERT_TRUE(comes([&] { return table().rowCount() == 2; }));
  EXPECT_TRUE(button("generate")->isEnabled());
}

TEST_F(PanelTest, ReportsAServiceThatDoesNotRespond) {
  rviz::Config config;
  config.mapSetValue("Seed", 13);
  panel_.load(config);
  button("generate")->click();
  EXPECT_TRUE(says("status", "No response"));
  EXPECT_TRUE(button("generate")->isEnabled());
}

TEST_F(PanelTest, PausesStepsAndPlaysIfThereIsAPlayer) {
  ASSERT_TRUE(comes([&] { return button("step")->isEnabled(); }));
  button("pause")->click();
  ASSERT_TRUE(says("player_says", "Paused."));
  ASSERT_TRUE(comes([&] { return button("pause")->text() == "Play"; }));
  button("step")->click();
  ASSERT_TRUE(says("status", "nothing left to step to"));
  button("pause")->click();
  ASSERT_TRUE(comes([&] { return button("pause")->text() == "Pause"; }));
}

}  // namespace
}  // namespace forge
