#pragma once

#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <string>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// One file of inputs and outputs of a published implementation (test/parity/README.md).
class ParityFixture {
 public:
  /// `name` is that of a file in FORGE_PARITY_DIR where that is set, else in test/parity/fixtures.
  /// Throws std::runtime_error for a file that is no JSON.
  explicit ParityFixture(const std::string& name);

  /// False where there is no such file.
  bool isThere() const { return is_there_; }
  const std::string& path() const { return path_; }
  const rapidjson::Value& at(const char* member) const;
  /// A list of cases; empty where the file has none of that name.
  std::vector<const rapidjson::Value*> cases(const char* member) const;

 private:
  std::string path_;
  bool is_there_ = false;
  rapidjson::Document document_;
};

/// `"inf"` is infinity.
double numberOf(const rapidjson::Value& value);
std::vector<double> numbersOf(const rapidjson::Value& value);
/// The member of an object; throws std::runtime_error without one.
const rapidjson::Value& memberOf(const rapidjson::Value& object, const char* name);
double numberOf(const rapidjson::Value& object, const char* name);
std::string textOf(const rapidjson::Value& object, const char* name);
/// [x, y, heading].
Pose2 poseOf(const rapidjson::Value& value);

/// A car of the member `vehicles`.
struct ParityVehicle {
  EgoVehicle ego;
  double wheelbase = 0.0;
};
ParityVehicle vehicleOf(const ParityFixture& fixture, const std::string& name);
/// One of a case's `agents`: its state at `time`, on a track of its own.
Track agentOf(const rapidjson::Value& value, double time);

}  // namespace forge

/// Leaves the test, with the file's name, where the fixture is not there.
#define SKIP_WITHOUT(fixture) \
  if (!(fixture).isThere()) GTEST_SKIP() << "parity data missing: " << (fixture).path()
