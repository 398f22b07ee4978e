#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace forge {

enum class CollisionType { kLaneChange, kOppositeDirection, kRearEnd, kJunctionCrossing, kLtap };

inline constexpr CollisionType kCollisionTypes[] = {
    CollisionType::kLaneChange, CollisionType::kOppositeDirection, CollisionType::kRearEnd,
    CollisionType::kJunctionCrossing, CollisionType::kLtap};

/// "lane_change", "opposite_direction", "rear_end", "junction_crossing" or "ltap".
const char* toString(CollisionType type);
/// Takes those names and the paper's short ones (LC, OD, HO, RE, JC, LTAP), in any case.
std::optional<CollisionType> collisionTypeFromString(const std::string& name);

/// kHistory: only what was observed up to now. kReplay: the recorded future may be used.
enum class Mode { kHistory, kReplay };
const char* toString(Mode mode);
std::optional<Mode> modeFromString(const std::string& name);

struct CollisionRequest {
  CollisionType type = CollisionType::kRearEnd;
  double tta = 4.0;                     ///< time to accident, seconds from now
  std::optional<std::string> attacker;  ///< agent id; any agent when empty
  Mode mode = Mode::kHistory;
  std::uint64_t seed = 0;
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
  kNoAttackWithinBounds = 7,  ///< candidates exist, none can be driven into the ego as asked
  kNoScene = 8,               ///< no agents, map or ego pose received yet
  kNoRecording = 9,           ///< replay mode without a recording
  kBeyondRecording = 10,      ///< replay mode and the recording ends before the impact
  kInvalidInput = 11,         ///< unknown mode, a pose that is not a number, a box without size
  kNodeUnavailable = 12,      ///< a node of the suite did not answer
  kLowConfidence = 13,        ///< the best attack promises less than min_confidence
};
const char* toString(StatusCode code);
/// Empty for an unknown name; names are those of toString(), in capitals.
std::optional<StatusCode> statusCodeFromString(const std::string& name);

struct Status {
  StatusCode code = StatusCode::kOk;
  std::string message;  ///< for people: names the field and the value
};

}  // namespace forge
