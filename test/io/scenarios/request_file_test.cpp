#include "collision_forge/io/scenarios/request_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/scene/shipped_limits.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const char* const kLine =
    R"({"scene":"scene-0001","now":1531883530.949817,"type":"ltap","tta":4.5,"attacker":"a1","seed":18446744073709551615})";

SceneRequest request() {
  SceneRequest request;
  request.scene = "scene-0001";
  request.now = 1531883530.949817;
  request.request.type = CollisionType::kLtap;
  request.request.tta = 4.5;
  request.request.attacker = "a1";
  request.request.seed = 18446744073709551615u;
  return request;
}

std::string complaintAbout(std::string line, const std::string& from, const std::string& to) {
  replaceIn(line, from, to);
  try {
    readRequestLine("list.jsonl: line 5", line);
  } catch (const JsonLineError& error) {
    return error.what();
  }
  return "";
}

std::string complaintAboutFile(const std::string& path) {
  try {
    readRequests(path, {"scene-0001"}, shippedLimits());
  } catch (const JsonLineError& error) {
    return error.what();
  }
  return "";
}

TEST(RequestFile, ALineHasTheDocumentedForm) {
  EXPECT_EQ(requestLine(request()), kLine);
  SceneRequest any = request();
  any.request.attacker.reset();
  EXPECT_THAT(requestLine(any), HasSubstr(R"("attacker":null)"));
}

TEST(RequestFile, FingerprintsDistinguishLists) {
  SceneRequest other = request();
  other.request.seed = 0;
  const std::string both = fingerprintOf({request(), other});
  EXPECT_EQ(both.substr(0, 2), "2 ");
  EXPECT_EQ(fingerprintOf({request(), other}), both);
  EXPECT_NE(fingerprintOf({other, request()}), both);
  EXPECT_NE(fingerprintOf({request(), request()}), both);
}

TEST(RequestFile, TheRequestOverridesTheConfiguration) {
  CrashDefinition configured;
  configured.believable = false;
  configured.time_tolerance = 0.25;
  EXPECT_FALSE(readRequestLine("", kLine, configured).request.crash.believable);
  EXPECT_EQ(readRequestLine("", kLine, configured).request.crash.time_tolerance, 0.25);
  std::string line = kLine;
  replaceIn(line, "\"seed\"", "\"believable\":true,\"seed\"");
  const SceneRequest read = readRequestLine("", line, configured);
  EXPECT_TRUE(read.request.crash.believable);
  EXPECT_THAT(requestLine(read, configured), HasSubstr("\"believable\":true"));
  EXPECT_EQ(requestLine(read), kLine);
}

TEST(RequestFile, ConditionsAreReadBack) {
  SceneRequest asked = request();
  asked.request.turning = Turning::kEgo;
  asked.request.from_side = Side::kRight;
  double value = 0.25;
  for (const RangeControl& control : kRangeControls) {
    asked.request.*control.asked = Range{value, value + 0.125};
    value += 0.25;
  }
  const std::string line = requestLine(asked);
  const CollisionRequest read = readRequestLine("", line).request;
  EXPECT_EQ(read.turning, Turning::kEgo);
  EXPECT_EQ(read.from_side, Side::kRight);
  for (const RangeControl& control : kRangeControls) {
    EXPECT_EQ((read.*control.asked)->min, (asked.request.*control.asked)->min) << control.name;
    EXPECT_EQ((read.*control.asked)->max, (asked.request.*control.asked)->max) << control.name;
  }
  EXPECT_EQ(requestLine(readRequestLine("", line)), line);
}

TEST(RequestFile, TheNameInACatalogueIsReadBack) {
  SceneRequest request{"scene-0001", 100.5, {}, "euro_ncap_2026/CCRb deceleration=2"};
  EXPECT_EQ(readRequestLine("list", requestLine(request)).name, request.name);
  request.name.clear();
  EXPECT_EQ(requestLine(request).find("name"), std::string::npos);
}

TEST(RequestFile, ShortTypeNamesAndNullAreRead) {
  std::string line = kLine;
  replaceIn(line, "ltap", "JC");
  replaceIn(line, "\"a1\"", "null");
  const SceneRequest read = readRequestLine("", line);
  EXPECT_EQ(read.request.type, CollisionType::kJunctionCrossing);
  EXPECT_FALSE(read.request.attacker);
}

TEST(RequestFile, MalformedFieldsAreNamed) {
  const auto field = [](const std::string& name) {
    return AllOf(HasSubstr("list.jsonl: line 5"), HasSubstr("field " + name));
  };
  EXPECT_THAT(complaintAbout(kLine, "\"ltap\"", "\"drift\""),
              AllOf(field("type"), HasSubstr("drift")));
  EXPECT_THAT(complaintAbout(kLine, "\"scene-0001\"", "1"), field("scene"));
  EXPECT_THAT(complaintAbout(kLine, "1531883530.949817", "\"soon\""), field("now"));
  EXPECT_THAT(complaintAbout(kLine, "4.5", "null"), field("tta"));
  EXPECT_THAT(complaintAbout(kLine, "\"a1\"", "17"), field("attacker"));
  EXPECT_THAT(complaintAbout(kLine, "18446744073709551615", "-1"), field("seed"));
  EXPECT_THAT(complaintAbout(kLine, "\"seed\"", "\"sead\""), field("seed is missing"));
  EXPECT_THAT(complaintAbout(kLine, "\"seed\"", "\"mode\":\"replay\",\"seed\""), field("mode"));
  EXPECT_THAT(complaintAbout(kLine, "\"seed\"", "\"tta\":4.5,\"seed\""), field("tta"));
  EXPECT_THAT(complaintAbout(kLine, "\"seed\"", "\"choice\":\"none\",\"seed\""), field("choice"));
}

TEST(RequestFile, RoundTripsAFile) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/requests.jsonl";
  SceneRequest second = request();
  second.request.attacker.reset();
  writeRequests(path, {request(), second});
  const auto read = readRequests(path, {"scene-0001"}, shippedLimits());
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(requestLine(read[0]), kLine);
  EXPECT_EQ(requestLine(read[1]), requestLine(second));
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(RequestFile, ErrorsNameFileAndLine) {
  const TemporaryFolder folder;
  const std::string good = std::string(kLine) + "\n";
  std::string absent = good;
  replaceIn(absent, "scene-0001", "scene-0002");
  EXPECT_THAT(complaintAboutFile(folder.path() + "/none"),
              AllOf(HasSubstr(folder.path() + "/none"), HasSubstr("cannot be opened")));
  EXPECT_THAT(complaintAboutFile(folder.write("empty", "")), HasSubstr("has no request"));
  EXPECT_THAT(complaintAboutFile(folder.write("absent", good + absent)),
              AllOf(HasSubstr("absent: line 2: field scene"), HasSubstr("scene-0002")));
  EXPECT_THAT(complaintAboutFile(folder.write("gap", good + "\n" + good)),
              HasSubstr("gap: line 2: is empty"));
  EXPECT_THAT(complaintAboutFile(folder.write("cut", good + good.substr(0, 40))),
              HasSubstr("cut: line 2: invalid JSON"));
  EXPECT_EQ(complaintAboutFile(folder.write("no_line_end", kLine)), "");
}

}  // namespace
}  // namespace forge
