#include "collision_forge/base/scene/collision_request.h"

#include "collision_forge/base/scene/request_words.h"

namespace forge {
const char* toString(Mode mode) {
  switch (mode) {
    case Mode::kHistory:
      return "history";
    case Mode::kReplay:
      return "replay";
    case Mode::kAdaptive:
      break;
  }
  return "adaptive";
}

std::optional<Mode> modeFromString(const std::string& name) {
  const std::string key = lowered(name);
  for (const Mode mode : kModes) {
    if (key == toString(mode)) return mode;
  }
  return std::nullopt;
}

const char* toString(AttackerChoice choice) {
  switch (choice) {
    case AttackerChoice::kAny:
      return "any";
    case AttackerChoice::kExisting:
      return "existing";
    case AttackerChoice::kNew:
      return "new";
  }
  return "";
}

std::optional<AttackerChoice> attackerChoiceFromString(const std::string& name) {
  const std::string key = lowered(name);
  for (const AttackerChoice choice :
       {AttackerChoice::kAny, AttackerChoice::kExisting, AttackerChoice::kNew}) {
    if (key == toString(choice)) return choice;
  }
  return std::nullopt;
}

const char* toString(StatusCode code) {
  switch (code) {
    case StatusCode::kOk:
      return "OK";
    case StatusCode::kUnknownType:
      return "UNKNOWN_TYPE";
    case StatusCode::kTtaOutOfRange:
      return "TTA_OUT_OF_RANGE";
    case StatusCode::kUnknownAttacker:
      return "UNKNOWN_ATTACKER";
    case StatusCode::kAbsentAttacker:
      return "ABSENT_ATTACKER";
    case StatusCode::kTooLittleHistory:
      return "TOO_LITTLE_HISTORY";
    case StatusCode::kNoCandidate:
      return "NO_CANDIDATE";
    case StatusCode::kNoAttackWithinLimits:
      return "NO_ATTACK_WITHIN_LIMITS";
    case StatusCode::kNoScene:
      return "NO_SCENE";
    case StatusCode::kNoRecording:
      return "NO_RECORDING";
    case StatusCode::kBeyondRecording:
      return "BEYOND_RECORDING";
    case StatusCode::kInvalidInput:
      return "INVALID_INPUT";
    case StatusCode::kNodeUnavailable:
      return "NODE_UNAVAILABLE";
    case StatusCode::kLowConfidence:
      return "LOW_CONFIDENCE";
    case StatusCode::kNotBelievable:
      return "NOT_BELIEVABLE";
    case StatusCode::kRoadDoesNotAllow:
      return "ROAD_DOES_NOT_ALLOW";
    case StatusCode::kStaleScene:
      return "STALE_SCENE";
    case StatusCode::kInternalError:
      return "INTERNAL_ERROR";
  }
  return "UNKNOWN";
}

bool isOfTheScene(StatusCode code) {
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
  for (auto number = static_cast<int>(StatusCode::kOk);
       number <= static_cast<int>(StatusCode::kInternalError); ++number) {
    const auto code = static_cast<StatusCode>(number);
    if (name == toString(code)) return code;
  }
  return std::nullopt;
}

}  // namespace forge
