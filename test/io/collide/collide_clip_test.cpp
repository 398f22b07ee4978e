#include "collision_forge/io/collide/collide_clip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "base/scene/shipped_limits.h"
#include "io/collide/collide_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::HasSubstr;

const char* const kName =
    "data_hcis_v4.6_trainval_singapore-onenorth_LTAP_scene-0911_2-14-0.08333333333333333-9_92.4_"
    "f00d.csv";

/// Ten frames of ego, attacker and a third vehicle that is present only in frame 8.
std::string smallFile() {
  std::ostringstream text;
  text << "TRACK_ID,TIMESTAMP,V,X,Y,YAW\n";
  const auto row = [&text](const char* id, int frame, const std::string& values) {
    text << id << ',' << 1542800668198393 + 500000LL * frame << ',' << values << '\n';
  };
  for (int frame = 0; frame < 10; ++frame) {
    row("aaaa", frame, frame == 8 ? "2.5,1.25,-7.5,90.0" : "0.0,0.0,0.0,0.0");
  }
  for (int frame = 0; frame < 10; ++frame) row("ego", frame, "5.0,100.5,-200.25,-45.0");
  for (int frame = 0; frame < 10; ++frame) row("f00d", frame, "6.5,110.5,-190.25,179.5");
  return text.str();
}

/// Returns the error message of reading; "" if it succeeds.
std::string complaint(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  try {
    readCollideClip(folder.write(name, text), shippedLimits());
  } catch (const CollideError& error) {
    return error.what();
  }
  return "";
}

/// Returns the error message for smallFile() with the first `from` replaced.
std::string complaintAfter(const std::string& from, const std::string& to) {
  std::string text = smallFile();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return complaint(kName, text.replace(at, from.size(), to));
}

/// Returns the error message for smallFile() under a name with the first `from` replaced.
std::string complaintAboutName(const std::string& from, const std::string& to) {
  std::string name = kName;
  const std::size_t at = name.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return complaint(name.replace(at, from.size(), to), smallFile());
}

/// Returns smallFile() without the lines that contain `part`.
std::string without(const std::string& part) {
  std::istringstream lines(smallFile());
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(part) == std::string::npos) text += line + "\n";
  }
  return text;
}

TEST(CollideClip, NameGivesItsFields) {
  const CollideName name = parseCollideName(std::string("/some/folder/") + kName);
  EXPECT_EQ(name.batch, "v4.6");
  EXPECT_EQ(name.city, "singapore-onenorth");
  EXPECT_EQ(name.type, CollisionType::kLtap);
  EXPECT_EQ(name.scene, "scene-0911");
  EXPECT_EQ(name.placement, 2);
  EXPECT_EQ(name.variant, 14);
  EXPECT_EQ(name.collision_frame, 9);
  EXPECT_NEAR(name.angle, 92.4 * M_PI / 180.0, 1e-12);
  EXPECT_EQ(name.attacker_id, "f00d");
}

TEST(CollideClip, ComposedNameIsTheOneParsed) {
  EXPECT_EQ(composeCollideName(parseCollideName(kName)), kName);
  CollideName name = parseCollideName(kName);
  name.collision_frame = 8;
  name.type = CollisionType::kOppositeDirection;
  name.angle = M_PI;
  EXPECT_EQ(composeCollideName(name),
            "data_hcis_v4.6_trainval_singapore-onenorth_HO_scene-0911_2-14-0.0-8_180.0_f00d.csv");
  name.city = "no_city";
  EXPECT_THROW(composeCollideName(name), std::invalid_argument);
}

TEST(CollideClip, RowsBecomeTracksInRadiansAndSeconds) {
  const TemporaryFolder folder;
  const CollideClip clip = readCollideClip(folder.write(kName, smallFile()), shippedLimits());
  EXPECT_EQ(clip.name + ".csv", kName);
  ASSERT_EQ(clip.times.size(), 10u);
  EXPECT_DOUBLE_EQ(clip.times[0], 1542800668.198393);
  EXPECT_NEAR(clip.tta(), 1.0, 1e-6);
  EXPECT_EQ(clip.nominalTta(), 1.0);
  ASSERT_EQ(clip.tracks.size(), 3u);
  EXPECT_EQ(clip.attacker().id, "f00d");
  const CollideState& ego = *clip.ego().frames[9];
  EXPECT_EQ(ego.pose.x, 100.5);
  EXPECT_EQ(ego.pose.y, -200.25);
  EXPECT_NEAR(ego.pose.yaw, -M_PI / 4.0, 1e-15);
  EXPECT_EQ(ego.speed, 5.0);
  EXPECT_THROW(clip.track("nobody"), std::out_of_range);
}

TEST(CollideClip, RowsOfZerosAreMissingFrames) {
  const TemporaryFolder folder;
  const CollideClip clip = readCollideClip(folder.write(kName, smallFile()), shippedLimits());
  const CollideTrack& track = clip.track("aaaa");
  for (std::size_t frame = 0; frame < 10; ++frame) {
    EXPECT_EQ(track.frames[frame].has_value(), frame == 8) << frame;
  }
  EXPECT_NEAR(track.frames[8]->pose.yaw, M_PI / 2.0, 1e-15);
}

TEST(CollideClip, RoundTripsEveryNumber) {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 3.21, 20, 7.1, {-31.3, 0.2, 0.3}, 9.7);
  for (CollideTrack& track : clip.tracks) {
    double noise = 0.1234567890123456;
    for (auto& state : track.frames) {
      noise = std::fmod(noise * 997.0, 1.0);
      state->pose.x += 1e3 * noise;
      state->pose.yaw = 2.0 * M_PI * (noise - 0.5);
      state->speed = 1e-5 * noise;
    }
  }
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/" + composeCollideName(clip);
  writeCollideClip(path, clip);
  const CollideClip copy = readCollideClip(path, shippedLimits());
  EXPECT_EQ(copy.name, clip.name);
  EXPECT_DOUBLE_EQ(copy.angle, clip.angle);
  EXPECT_EQ(copy.times, clip.times);
  ASSERT_EQ(copy.tracks.size(), clip.tracks.size());
  for (std::size_t i = 0; i < clip.tracks.size(); ++i) {
    EXPECT_EQ(copy.tracks[i].id, clip.tracks[i].id);
    for (std::size_t frame = 0; frame < clip.times.size(); ++frame) {
      const CollideState& expected = *clip.tracks[i].frames[frame];
      const CollideState& actual = *copy.tracks[i].frames[frame];
      EXPECT_EQ(actual.pose.x, expected.pose.x);
      EXPECT_EQ(actual.pose.y, expected.pose.y);
      EXPECT_NEAR(actual.pose.yaw, expected.pose.yaw, 1e-15);
      EXPECT_EQ(actual.speed, expected.speed);
    }
  }
}

TEST(CollideClip, NameErrorsNameTheField) {
  EXPECT_THAT(complaintAboutName("_f00d", ""), HasSubstr("ten parts"));
  EXPECT_THAT(complaintAboutName("hcis", "hcos"), HasSubstr("\"hcos\" is not \"hcis\""));
  EXPECT_THAT(complaintAboutName("LTAP", "XY"), HasSubstr("type = \"XY\""));
  EXPECT_THAT(complaintAboutName("scene-0911", ""), HasSubstr("scene = \"\""));
  EXPECT_THAT(complaintAboutName("_2-14-", "_6-14-"), HasSubstr("placement = \"6\""));
  EXPECT_THAT(complaintAboutName("_2-14-", "_2-x-"), HasSubstr("variant = \"x\""));
  EXPECT_THAT(complaintAboutName("_2-14-", "_2-"), HasSubstr("four parts"));
  EXPECT_THAT(complaintAboutName("-9_", "-7_"), HasSubstr("frame = \"7\""));
  EXPECT_THAT(complaintAboutName("-9_", "-10_"), HasSubstr("n = \"0.08333333333333333\""));
  EXPECT_THAT(complaintAboutName("_92.4_", "_nan_"), HasSubstr("angle = \"nan\""));
  EXPECT_THAT(complaintAboutName("_92.4_", "_180.5_"), HasSubstr("angle = \"180.5\""));
  EXPECT_THAT(complaintAboutName(".csv", ".txt"), HasSubstr("is not .csv"));
}

TEST(CollideClip, RowErrorsNameLineColumnAndValue) {
  EXPECT_THAT(complaintAfter(",YAW", ""), HasSubstr("line 1: column YAW is missing"));
  EXPECT_THAT(complaintAfter("2.5,1.25", "2.5,east"),
              HasSubstr("line 10: X = \"east\" is not a number"));
  EXPECT_THAT(complaintAfter("-7.5,90.0", "nan,90.0"),
              HasSubstr("line 10: Y = \"nan\" is not finite"));
  EXPECT_THAT(complaintAfter("2.5,1.25", "2.5,1e9"),
              HasSubstr("line 10: X = \"1e9\" is outside -100000 to 100000"));
  EXPECT_THAT(complaintAfter("2.5,1.25", "-1e308,1.25"),
              HasSubstr("line 10: V = \"-1e308\" is outside -150 to 150"));
  EXPECT_THAT(complaintAfter("2.5,1.25", "2.5"),
              HasSubstr("line 10: 5 values, but the header has 6"));
  EXPECT_THAT(complaintAfter("1542800668198393", "1.5e9"),
              HasSubstr("line 2: TIMESTAMP = \"1.5e9\""));
  EXPECT_THAT(complaintAfter("aaaa,", ","), HasSubstr("line 2: TRACK_ID = \"\" is empty"));
}

TEST(CollideClip, TimestampsMustIncreaseAndAgree) {
  EXPECT_THAT(complaintAfter("aaaa,1542800668698393", "aaaa,1542800668198393"),
              HasSubstr("line 3: TIMESTAMP = \"1542800668198393\" is not after"));
  EXPECT_THAT(
      complaintAfter("ego,1542800669198393", "ego,1542800669198394"),
      HasSubstr("line 14: TIMESTAMP = \"1542800669198394\" differs from the timestamp of frame 2"));
}

TEST(CollideClip, EveryTrackMustHaveARowAFrame) {
  EXPECT_THAT(complaintAfter("aaaa,1542800672698393,0.0,0.0,0.0,0.0\n", ""),
              HasSubstr("TRACK_ID = \"aaaa\" has 9 rows, not the 10"));
  EXPECT_THAT(complaint(kName, smallFile() + "ego,1542800673198393,5.0,100.5,-200.25,-45.0\n"),
              HasSubstr("line 32: TRACK_ID = \"ego\" has more rows than the 10"));
}

TEST(CollideClip, EgoAndAttackerMustBeThereInEveryFrame) {
  EXPECT_THAT(complaint(kName, without("ego,")), HasSubstr("TRACK_ID = \"ego\" is missing"));
  EXPECT_THAT(complaint(kName, without("f00d,")), HasSubstr("TRACK_ID = \"f00d\" is missing"));
  EXPECT_THAT(complaintAfter("5.0,100.5,-200.25,-45.0", "0.0,0.0,0.0,0.0"),
              HasSubstr("line 12: TRACK_ID = \"ego\" is missing in frame 0"));
  EXPECT_THAT(complaintAfter("6.5,110.5,-190.25,179.5", "0.0,0.0,0.0,0.0"),
              HasSubstr("line 22: TRACK_ID = \"f00d\" is missing in frame 0"));
}

}  // namespace
}  // namespace forge
