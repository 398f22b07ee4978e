#include "collision_forge/study/evaluation/clip_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "collision_forge/io/collide/collide_clip.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

std::string pathOf(CollisionType type, int last_frame, int variant) {
  CollideClip clip = straightClip(type, 0.0, last_frame, 5.0, {}, 5.0);
  clip.variant = variant;
  return "clips/val/" + composeCollideName(clip);
}

/// Four clips of each type except LTAP; the first of each type is too short by 0.5 s.
std::vector<std::string> somePaths() {
  std::vector<std::string> paths;
  for (const CollisionType type : kCollisionTypes) {
    if (type == CollisionType::kLtap) continue;
    for (int variant = 0; variant < 4; ++variant) {
      paths.push_back(pathOf(type, variant == 0 ? 10 : 11 + variant, variant));
    }
  }
  return paths;
}

std::vector<CollisionType> typesOf(const std::vector<std::string>& paths) {
  std::vector<CollisionType> types;
  for (const std::string& path : paths) types.push_back(parseCollideName(path).type);
  return types;
}

std::string errorOf(const std::vector<std::string>& paths, const std::string& name) {
  try {
    clipNamed(paths, name);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(DrawClips, DrawsOneOfEachTypeInTurn) {
  const std::vector<CollisionType> first = {
      CollisionType::kLaneChange, CollisionType::kOppositeDirection, CollisionType::kRearEnd,
      CollisionType::kJunctionCrossing, CollisionType::kLaneChange};
  EXPECT_EQ(typesOf(drawClips(somePaths(), 5, 2.0, 0)), first);
}

TEST(DrawClips, IsDeterministicAndASmallerCountIsAPrefix) {
  const std::vector<std::string> paths = somePaths();
  const std::vector<std::string> drawn = drawClips(paths, 8, 2.0, 1);
  EXPECT_EQ(drawClips(paths, 8, 2.0, 1), drawn);
  const std::vector<std::string> fewer = drawClips(paths, 3, 2.0, 1);
  EXPECT_TRUE(std::equal(fewer.begin(), fewer.end(), drawn.begin()));
  std::set<std::string> firsts;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    firsts.insert(drawClips(paths, 1, 2.0, seed).front());
  }
  EXPECT_EQ(firsts.size(), 3u);
}

TEST(DrawClips, TooFewClipsAreReportedWithTheirNumber) {
  try {
    drawClips(somePaths(), 13, 2.0, 0);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "only 12 of 16 clips in clips/val are long enough; 13 requested");
  }
}

TEST(ClipNamed, AcceptsAFullNameOrAUniquePart) {
  const std::vector<std::string> paths = {pathOf(CollisionType::kRearEnd, 11, 1),
                                          pathOf(CollisionType::kRearEnd, 12, 2),
                                          pathOf(CollisionType::kLtap, 12, 2)};
  const std::string name = paths[1].substr(paths[1].rfind('/') + 1);
  EXPECT_EQ(clipNamed(paths, name), paths[1]);
  EXPECT_EQ(clipNamed(paths, name.substr(0, name.size() - 4)), paths[1]);
  EXPECT_EQ(clipNamed(paths, "LTAP_scene-0001"), paths[2]);
}

TEST(ClipNamed, UnknownAndAmbiguousNamesAreRejectedWithExamples) {
  const std::vector<std::string> paths = {"val/a1.csv", "val/a2.csv", "val/b.csv"};
  EXPECT_EQ(errorOf(paths, "c"), "\"c\" matches none of 3 clips in val; names look like a1");
  EXPECT_EQ(errorOf(paths, "a"),
            "\"a\" matches 2 clips, e.g. a1 and a2; give a longer part of the name");
}

}  // namespace
}  // namespace forge
