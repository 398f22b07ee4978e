#include "collision_forge/ros/messages/posed_frames.h"

#include <collision_forge/AgentArray.h>
#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

namespace forge {
namespace {

constexpr double kStart = 1000.0;  // s

ros::Time at(double seconds) { return ros::Time(kStart + seconds); }

/// The ego's base at x = 10 * seconds.
tf2_msgs::TFMessage poseAt(double seconds) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = at(seconds);
  transform.header.frame_id = "map";
  transform.child_frame_id = "base_link";
  transform.transform.translation.x = 10.0 * seconds;
  transform.transform.rotation.w = 1.0;
  tf2_msgs::TFMessage message;
  message.transforms = {transform};
  return message;
}

class PosedFramesTest : public testing::Test {
 protected:
  void pose(double seconds) { frames_.addTransforms(poseAt(seconds), false); }

  void frame(double seconds) {
    auto agents = boost::make_shared<collision_forge::AgentArray>();
    agents->header.stamp = at(seconds);
    frames_.addFrame(agents);
  }

  /// Seconds of the frames that are ready, each of which has to have its own pose.
  std::vector<double> ready() {
    std::vector<double> times;
    while (const auto found = frames_.next()) {
      const double seconds = (found->message->header.stamp - at(0.0)).toSec();
      EXPECT_NEAR(found->pose.translation.x, 10.0 * seconds, 1e-6);
      dropped_ += found->dropped;
      times.push_back(seconds);
    }
    return times;
  }

  using Times = std::vector<double>;
  PosedFrames<collision_forge::AgentArray> frames_;
  std::size_t dropped_ = 0;
};

TEST_F(PosedFramesTest, AFrameWaitsForItsPose) {
  frame(0.0);
  EXPECT_EQ(ready(), Times());
  pose(0.0);
  EXPECT_EQ(ready(), Times({0.0}));
  EXPECT_EQ(ready(), Times()) << "once";
  pose(0.4);
  frame(0.5);
  EXPECT_EQ(ready(), Times());
  pose(0.6);
  EXPECT_EQ(ready(), Times({0.5})) << "between two poses";
}

TEST_F(PosedFramesTest, NoFrameIsLostAtARestartOfTheReplay) {
  // Longer than tf2 remembers, so that what is left of the replay before would hide the new poses.
  for (const bool frames_first : {false, true}) {
    pose(0.0);
    frame(20.0);
    pose(20.0);
    EXPECT_EQ(ready(), Times({20.0}));
    for (const double time : {0.0, 0.5}) {
      if (frames_first) frame(time);
      pose(time);
      if (!frames_first) frame(time);
      EXPECT_EQ(ready(), Times({time}));
    }
  }
  EXPECT_EQ(dropped_, 0u);
}

TEST_F(PosedFramesTest, FramesOfThePreviousReplayAreDropped) {
  pose(20.0);
  frame(20.5);
  frame(0.0);
  pose(0.0);
  EXPECT_EQ(ready(), Times({0.0}));
  pose(20.5);
  EXPECT_EQ(ready(), Times());
}

TEST_F(PosedFramesTest, StaticTransformsSurviveARestart) {
  tf2_msgs::TFMessage fixed = poseAt(0.0);
  fixed.transforms[0].header.frame_id = "world";
  fixed.transforms[0].child_frame_id = "map";
  frames_.addTransforms(fixed, true);
  pose(20.0);
  pose(0.0);
  frame(0.0);
  EXPECT_EQ(ready(), Times({0.0}));
}

TEST_F(PosedFramesTest, FindsTheTransformsThatMoveTheEgo) {
  const auto from = [](const char* parent, const char* child, double seconds) {
    tf2_msgs::TFMessage message = poseAt(seconds);
    message.transforms[0].header.frame_id = parent;
    message.transforms[0].child_frame_id = child;
    return message;
  };
  const tf2_msgs::TFMessage moving = from("map", "base_footprint", 20.0);
  EXPECT_TRUE(frames_.movesEgo(poseAt(0.0).transforms[0]));
  EXPECT_FALSE(frames_.movesEgo(moving.transforms[0])) << "not as far as is known yet";
  frames_.addTransforms(from("base_footprint", "base_link", 0.0), true);
  EXPECT_TRUE(frames_.movesEgo(moving.transforms[0]));
  EXPECT_FALSE(frames_.movesEgo(poseAt(0.0).transforms[0]));
  frames_.addTransforms(moving, false);
  frame(20.5);
  frames_.addTransforms(from("map", "base_footprint", 0.0), false);
  frames_.addTransforms(from("map", "base_footprint", 20.5), false);
  frame(10.0);
  EXPECT_EQ(ready(), Times({10.0})) << "the replay started again";
}

TEST_F(PosedFramesTest, NoMoreThanAThousandFramesWait) {
  for (int i = 0; i < 1500; ++i) frame(0.1 * i);
  pose(0.0);
  pose(80.0);
  std::size_t count = ready().size();
  EXPECT_EQ(count, 301u) << "the 501st at 50 s is the oldest, the last with a pose is at 80 s";
}

}  // namespace
}  // namespace forge
