#include "collision_forge/io/scenarios/request_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;

CollisionRequest everything() {
  CollisionRequest request;
  request.choice = AttackerChoice::kNew;
  request.crash.believable = false;
  request.crash.limits = LimitSet::kStrict;
  request.attacker_class = AgentClass::kEmergencyVehicle;
  request.manoeuvre = Manoeuvre::kLeadBrakes;
  request.ego_side = Side::kFront;
  request.impact_speed = Range{2.5, 12.0};
  request.overlap = Range{0.25, 0.5};
  request.alternatives = 3;
  return request;
}

const char* const kEverything =
    R"({"choice":"new","believable":false,"limits":"strict","attacker_class":"emergency_vehicle",)"
    R"("manoeuvre":"lead_brakes","ego_side":"front","impact_speed":{"min":2.5,"max":12},)"
    R"("overlap":{"min":0.25,"max":0.5},"alternatives":3})";

std::string lineOf(const CollisionRequest& request, const CrashDefinition* defaults = nullptr) {
  JsonLineWriter writer;
  writer.beginObject();
  writeControls(writer, request, defaults);
  writer.endObject();
  return writer.line();
}

CollisionRequest readFrom(const std::string& line, bool may_lack) {
  const JsonLine parsed("here", line);
  JsonObject object = parsed.root();
  CollisionRequest request;
  readControls(object, request, may_lack);
  object.finish();
  return request;
}

std::string complaintAbout(const std::string& line, bool may_lack = true) {
  try {
    readFrom(line, may_lack);
  } catch (const JsonLineError& error) {
    return error.what();
  }
  return "";
}

TEST(RequestFields, RoundTrip) {
  EXPECT_EQ(lineOf(everything()), kEverything);
  for (const bool may_lack : {false, true}) {
    EXPECT_EQ(lineOf(readFrom(kEverything, may_lack)), kEverything);
  }
}

TEST(RequestFields, AreNullOrLeftOutForAnyValue) {
  const CrashDefinition defaults;
  EXPECT_EQ(lineOf({}), R"({"choice":"any","believable":true,"limits":"drivable",)"
                        R"("attacker_class":null,"manoeuvre":null,"ego_side":null,)"
                        R"("impact_speed":null,"overlap":null,"alternatives":1})");
  EXPECT_EQ(lineOf({}, &defaults), "{}");
  EXPECT_EQ(lineOf(everything(), &defaults), kEverything);
  EXPECT_EQ(lineOf(readFrom(lineOf({}), false)), lineOf({}));
  EXPECT_EQ(lineOf(readFrom("{}", true)), lineOf({}));
}

TEST(RequestFields, AreRequiredUnlessOptional) {
  EXPECT_THAT(complaintAbout("{}", false), HasSubstr("choice is missing"));
  EXPECT_EQ(complaintAbout("{}", true), "");
}

TEST(RequestFields, ErrorsNameUnknownValues) {
  EXPECT_THAT(complaintAbout(R"({"choice":"old"})"), AllOf(HasSubstr("choice"), HasSubstr("old")));
  EXPECT_THAT(complaintAbout(R"({"believable":1})"), HasSubstr("believable = 1"));
  EXPECT_THAT(complaintAbout(R"({"limits":"none"})"), HasSubstr("limits = \"none\""));
  EXPECT_THAT(complaintAbout(R"({"attacker_class":"van"})"), HasSubstr("attacker_class = \"van\""));
  EXPECT_THAT(complaintAbout(R"({"manoeuvre":"swerve"})"), HasSubstr("manoeuvre = \"swerve\""));
  EXPECT_THAT(complaintAbout(R"({"ego_side":"top"})"), HasSubstr("ego_side = \"top\""));
  EXPECT_THAT(complaintAbout(R"({"impact_speed":{"min":1}})"),
              HasSubstr("impact_speed.max is missing"));
  EXPECT_THAT(complaintAbout(R"({"impact_speed":{"min":1,"max":2,"mean":1}})"),
              HasSubstr("impact_speed.mean"));
  EXPECT_THAT(complaintAbout(R"({"overlap":0.5})"), HasSubstr("overlap = 0.5"));
  EXPECT_THAT(complaintAbout(R"({"alternatives":-1})"), HasSubstr("alternatives = -1"));
  EXPECT_THAT(complaintAbout(R"({"alternatives":4294967296})"), HasSubstr("too large"));
}

}  // namespace
}  // namespace forge
