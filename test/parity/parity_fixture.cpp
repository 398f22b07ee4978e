#include "parity/parity_fixture.h"

#include <rapidjson/error/en.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace forge {
namespace {

std::string folder() {
  const char* given = std::getenv("FORGE_PARITY_DIR");
  return given && *given ? given : COLLISION_FORGE_SOURCE_DIR "/test/parity/fixtures";
}

AgentClass classOf(const std::string& type) {
  if (type == "vehicle") return AgentClass::kCar;
  if (type == "bicycle") return AgentClass::kBicycle;
  if (type == "pedestrian") return AgentClass::kPedestrian;
  return AgentClass::kStaticObject;
}

}  // namespace

ParityFixture::ParityFixture(const std::string& name) : path_(folder() + "/" + name) {
  std::ifstream file(path_);
  if (!file) return;
  std::ostringstream text;
  text << file.rdbuf();
  document_.Parse<rapidjson::kParseFullPrecisionFlag>(text.str().c_str());
  if (document_.HasParseError()) {
    throw std::runtime_error(path_ + ": " + rapidjson::GetParseError_En(document_.GetParseError()));
  }
  is_there_ = true;
}

const rapidjson::Value& ParityFixture::at(const char* member) const {
  return memberOf(document_, member);
}

std::vector<const rapidjson::Value*> ParityFixture::cases(const char* member) const {
  std::vector<const rapidjson::Value*> cases;
  if (!document_.IsObject() || !document_.HasMember(member)) return cases;
  for (const auto& value : document_[member].GetArray()) cases.push_back(&value);
  return cases;
}

double numberOf(const rapidjson::Value& value) {
  if (value.IsNumber()) return value.GetDouble();
  if (value.IsString() && value.GetString() == std::string("inf")) {
    return std::numeric_limits<double>::infinity();
  }
  throw std::runtime_error("a number of the parity data is none");
}

std::vector<double> numbersOf(const rapidjson::Value& value) {
  std::vector<double> numbers;
  for (const auto& entry : value.GetArray()) numbers.push_back(numberOf(entry));
  return numbers;
}

const rapidjson::Value& memberOf(const rapidjson::Value& object, const char* name) {
  const auto member = object.FindMember(name);
  if (member == object.MemberEnd())
    throw std::runtime_error(std::string("parity data lack ") + name);
  return member->value;
}

double numberOf(const rapidjson::Value& object, const char* name) {
  return numberOf(memberOf(object, name));
}

std::string textOf(const rapidjson::Value& object, const char* name) {
  return memberOf(object, name).GetString();
}

Pose2 poseOf(const rapidjson::Value& value) {
  return {numberOf(value[0]), numberOf(value[1]), numberOf(value[2])};
}

ParityVehicle vehicleOf(const ParityFixture& fixture, const std::string& name) {
  const rapidjson::Value& vehicle = memberOf(fixture.at("vehicles"), name.c_str());
  ParityVehicle result;
  result.ego.size = {numberOf(vehicle, "length"), numberOf(vehicle, "width")};
  result.ego.center_offset = numberOf(vehicle, "rear_axle_to_center");
  result.wheelbase = numberOf(vehicle, "wheel_base");
  return result;
}

Track agentOf(const rapidjson::Value& value, double time) {
  Track track;
  track.id = textOf(value, "id");
  track.agent_class = classOf(textOf(value, "type"));
  track.size = {numberOf(value, "length"), numberOf(value, "width")};
  track.states.push_back({time,
                          {numberOf(value, "x"), numberOf(value, "y"), numberOf(value, "heading")},
                          {numberOf(value, "vx"), numberOf(value, "vy")}});
  return track;
}

}  // namespace forge
