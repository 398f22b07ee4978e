#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/base/scene/manoeuvre.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// kHistory: only what was observed up to now. kReplay: the recorded future may be used. kAdaptive:
/// as kHistory, and the attacker looks again at every frame that comes.
enum class Mode { kHistory, kReplay, kAdaptive };
const char* toString(Mode mode);
std::optional<Mode> modeFromString(const std::string& name);

/// Who may attack where no attacker is named: kExisting the recorded vehicles, kNew one that is
/// added, kAny either, an existing one where it is as sure.
enum class AttackerChoice { kAny, kExisting, kNew };
const char* toString(AttackerChoice choice);
std::optional<AttackerChoice> attackerChoiceFromString(const std::string& name);

/// Ends included.
struct Range {
  double min = 0.0;
  double max = 0.0;
};

struct CollisionRequest {
  CollisionType type = CollisionType::kRearEnd;
  double tta = 4.0;                     ///< time to accident, seconds from now
  std::optional<std::string> attacker;  ///< agent id; whom `choice` allows when empty
  AttackerChoice choice = AttackerChoice::kAny;
  Mode mode = Mode::kHistory;
  std::uint64_t seed = 0;
  int alternatives = 1;  ///< attacks asked for, which differ in attacker or manoeuvre
  // What the attack is to be beyond type and time; anything where empty.
  std::optional<AgentClass> attacker_class;
  std::optional<Manoeuvre> manoeuvre;
  std::optional<Side> ego_side;       ///< of the ego's box, where the attacker's touches it
  std::optional<Range> impact_speed;  ///< m/s, of CollisionReport::impact_speed
  std::optional<Range> overlap;       ///< [0, 1], of CollisionReport::overlap
  CrashDefinition crash;  ///< what counts as the crash; filled in where the request is answered

  /// Of the request's type. Throws std::out_of_range where `crash` is not filled in.
  const TypeDefinition& bands() const { return crash.types.at(type); }
};

/// A request at one instant of one scene, as it stands in a list of requests.
struct SceneRequest {
  std::string scene;         ///< name
  double now = 0.0;          ///< seconds on the scene's clock; the time of a frame
  CollisionRequest request;  ///< the mode is not part of a list
};

/// Outcome of a request; the numbers are those of GenerateCollision.srv.
enum class StatusCode : std::uint8_t {
  kOk = 0,
  kUnknownType = 1,
  kTtaOutOfRange = 2,
  kUnknownAttacker = 3,  ///< no agent of that id in the frames held
  kAbsentAttacker = 4,   ///< the agent is known, but not there now, or cannot attack
  kTooLittleHistory = 5,
  kNoCandidate = 6,           ///< nobody in reach comes from where the type wants it
  kNoAttackWithinLimits = 7,  ///< candidates exist, none can be driven into the ego as asked
  kNoScene = 8,               ///< no agents, map or ego pose received yet
  kNoRecording = 9,           ///< replay mode without a recording, or it has an attack
  kBeyondRecording = 10,      ///< the recording ends before the impact
  kInvalidInput = 11,         ///< unknown mode, a pose that is not a number, a box without size
  kNodeUnavailable = 12,      ///< a node of the suite did not answer
  kLowConfidence = 13,        ///< the best attack promises less than min_confidence
  kNotBelievable = 14,        ///< attacks exist, but no driver would drive so
  kRoadDoesNotAllow = 15,     ///< no lane of the type's direction passes the ego's place then
  kStaleScene = 16,           ///< no scene has come for longer than allowed
  kInternalError = 17,        ///< a fault of this package, whatever was asked
};
const char* toString(StatusCode code);
/// The scene does not allow it, or not at that instant; another may.
bool isOfTheScene(StatusCode code);
/// Empty for an unknown name; names are those of toString(), in capitals.
std::optional<StatusCode> statusCodeFromString(const std::string& name);

struct Status {
  StatusCode code = StatusCode::kOk;
  std::string message;  ///< for people: names the field and the value
};

}  // namespace forge
