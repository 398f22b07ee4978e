#include "collision_forge/base/scene/collision_request.h"

#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/geometry/enum_words.h"

namespace forge {
namespace {

constexpr EnumWord<Mode> kModeWords[] = {
    {Mode::kHistory, "history"},
    {Mode::kReplay, "replay"},
    {Mode::kAdaptive, "adaptive"},
};

constexpr EnumWord<AttackerChoice> kAttackerWords[] = {
    {AttackerChoice::kAny, "any"},
    {AttackerChoice::kExisting, "existing"},
    {AttackerChoice::kNew, "new"},
};

constexpr EnumWord<Hider> kHiderWords[] = {
    {Hider::kParkedVehicle, "parked_vehicle"},
    {Hider::kLeader, "leader"},
};

constexpr EnumWord<StatusCode> kStatusWords[] = {
    {StatusCode::kOk, "OK"},
    {StatusCode::kUnknownType, "UNKNOWN_TYPE"},
    {StatusCode::kTtaOutOfRange, "TTA_OUT_OF_RANGE"},
    {StatusCode::kUnknownAttacker, "UNKNOWN_ATTACKER"},
    {StatusCode::kAbsentAttacker, "ABSENT_ATTACKER"},
    {StatusCode::kTooLittleHistory, "TOO_LITTLE_HISTORY"},
    {StatusCode::kNoCandidate, "NO_CANDIDATE"},
    {StatusCode::kNoAttackWithinLimits, "NO_ATTACK_WITHIN_LIMITS"},
    {StatusCode::kNoScene, "NO_SCENE"},
    {StatusCode::kNoRecording, "NO_RECORDING"},
    {StatusCode::kBeyondRecording, "BEYOND_RECORDING"},
    {StatusCode::kInvalidInput, "INVALID_INPUT"},
    {StatusCode::kNodeUnavailable, "NODE_UNAVAILABLE"},
    {StatusCode::kLowConfidence, "LOW_CONFIDENCE"},
    {StatusCode::kNotBelievable, "NOT_BELIEVABLE"},
    {StatusCode::kRoadDoesNotAllow, "ROAD_DOES_NOT_ALLOW"},
    {StatusCode::kStaleScene, "STALE_SCENE"},
    {StatusCode::kInternalError, "INTERNAL_ERROR"},
};

}  // namespace

const char* toString(Mode mode) { return wordOf(kModeWords, mode); }

std::optional<Mode> modeFromString(const std::string& name) {
  return valueOf(kModeWords, lowered(name));
}

const char* toString(AttackerChoice choice) { return wordOf(kAttackerWords, choice); }

std::optional<AttackerChoice> attackerChoiceFromString(const std::string& name) {
  return valueOf(kAttackerWords, lowered(name));
}

const char* toString(Hider hider) { return wordOf(kHiderWords, hider); }

std::optional<Hider> hiderFromString(const std::string& name) {
  return valueOf(kHiderWords, lowered(name));
}

const char* toString(StatusCode code) { return wordOf(kStatusWords, code, "UNKNOWN"); }

bool dependsOnScene(StatusCode code) {
  switch (code) {
    case StatusCode::kNoCandidate:
    case StatusCode::kNoAttackWithinLimits:
    case StatusCode::kBeyondRecording:
    case StatusCode::kLowConfidence:
    case StatusCode::kNotBelievable:
    case StatusCode::kRoadDoesNotAllow:
      return true;
    default:
      return false;
  }
}

std::optional<StatusCode> statusCodeFromString(const std::string& name) {
  return valueOf(kStatusWords, name);
}

}  // namespace forge
