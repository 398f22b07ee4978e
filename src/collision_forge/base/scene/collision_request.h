#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/base/scene/manoeuvre.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// Information that a request may use.
enum class Mode {
  kHistory,  ///< the frames up to t0
  kReplay,   ///< also the recorded future
  kAdaptive  ///< as kHistory; the attacker replans at every later frame
};
/// Returns "history", "replay" or "adaptive".
const char* toString(Mode mode);
/// Returns the mode of a name of toString(), ignoring case; nullopt for another name.
std::optional<Mode> modeFromString(const std::string& name);

/// Which vehicles may attack if the request names none.
enum class AttackerChoice {
  kAny,       ///< recorded and added vehicles; a recorded one wins if its confidence is equal
  kExisting,  ///< recorded vehicles
  kNew        ///< a vehicle that is added to the scene
};
/// Returns "any", "existing" or "new".
const char* toString(AttackerChoice choice);
/// Returns the choice of a name of toString(), ignoring case; nullopt for another name.
std::optional<AttackerChoice> attackerChoiceFromString(const std::string& name);

/// Vehicle that hides the attacker from the ego.
enum class Hider {
  kParkedVehicle,  ///< stands from t0 to the contact
  kLeader          ///< drives in the ego's direction
};
/// Returns "parked_vehicle" or "leader".
const char* toString(Hider hider);
/// Returns the value of a name of toString(), ignoring case; nullopt for another name.
std::optional<Hider> hiderFromString(const std::string& name);

/// A closed interval.
struct Range {
  double min = 0.0;  ///< at most `max`
  double max = 0.0;
};

/// A request for an attack on the ego.
struct CollisionRequest {
  CollisionType type = CollisionType::kRearEnd;
  double tta = 4.0;                     ///< s from t0 to the requested contact, above 0
  std::optional<std::string> attacker;  ///< agent id; empty: any vehicle that `choice` allows
  AttackerChoice choice = AttackerChoice::kAny;  ///< matters if `attacker` is empty
  Mode mode = Mode::kHistory;
  std::uint64_t seed = 0;  ///< of all random draws; the same request and seed give the same attack
  /// Largest number of attacks wanted, which differ in attacker or manoeuvre; 1: only the best.
  int alternatives = 1;
  // Further constraints on the attack; an empty field allows any value.
  std::optional<AgentClass> attacker_class;  ///< class that the attacker must have
  std::optional<Manoeuvre> manoeuvre;  ///< that the attacker must use, CollisionReport::manoeuvre
  std::optional<Side> ego_side;        ///< side of the ego's box that the attacker touches
  std::optional<Range> impact_speed;   ///< m/s, of CollisionReport::impact_speed
  std::optional<Range> overlap;        ///< share 0..1, of CollisionReport::overlap
  /// Vehicle that must turn; kEgo only with a type of mayAskForEgoTurn().
  Turning turning = Turning::kAttacker;
  std::optional<Side> from_side;  ///< kLeft or kRight, ContactConditions::from_side: side of the
                                  ///< ego from which the attacker comes
  /// Kind of vehicle that must hide the attacker, ContactConditions::hidden_by.
  std::optional<Hider> hidden_by;
  /// True: a second vehicle must stand ahead of the attacker, which stands in its lane
  /// (kLeadStopped, type kRearEnd). False: not required.
  bool queue = false;
  std::optional<Range> attacker_speed;  ///< m/s; this field and the next seven bound the
  std::optional<Range> deceleration;    ///< m/s2; fields of the same names in ContactConditions
  std::optional<Range> gap;             ///< m
  std::optional<Range> headway;         ///< s
  std::optional<Range> lateral_speed;   ///< m/s
  /// Share of the ego's width from the left edge of its front.
  std::optional<Range> impact_location;
  std::optional<Range> departure_time;  ///< s after t0; the attacker stands until then
  std::optional<Range> visible_for;     ///< s
  CrashDefinition crash;                ///< set by the code that handles the request, not by users

  /// Returns true if the attacker must reverse (Manoeuvre::kBackOut).
  bool reverses() const { return manoeuvre == Manoeuvre::kBackOut; }
  /// Returns bandsOf() the requested type and `turning`. Throws std::out_of_range if `crash` is not
  /// set or `type` is kAny.
  TypeDefinition bands() const { return bandsOf(type, turning, crash); }
};

/// A request at a time t0 of a scene, one entry of a request list.
struct SceneRequest {
  std::string scene;         ///< name of the scene
  double now = 0.0;          ///< t0, s on the scene's clock; the time of a frame
  CollisionRequest request;  ///< request lists do not hold its `mode`
  std::string name = {};  ///< name of the catalogue cell (CatalogueCell) that the request is for;
                          ///< empty without a catalogue
};

/// Outcome of a request; the values equal the constants of GenerateCollision.srv.
enum class StatusCode : std::uint8_t {
  kOk = 0,               ///< solved: an attack was found
  kUnknownType = 1,      ///< the collision type is unknown, or kAny where one type is needed
  kTtaOutOfRange = 2,    ///< TTA outside PredictionOptions::min_tta to max_tta
  kUnknownAttacker = 3,  ///< no agent of that id in the snapshot
  kAbsentAttacker = 4,   ///< the agent is not present at t0, or its class cannot attack
  /// Ego or attacker was not observed in two frames up to t0, at most kMaxGap apart.
  kTooLittleHistory = 5,
  kNoCandidate = 6,           ///< no vehicle in range approaches as the requested type needs
  kNoAttackWithinLimits = 7,  ///< no candidate can hit the ego as requested within the limits
  kNoScene = 8,               ///< no agents, map or ego pose received yet
  kNoRecording = 9,           ///< replay mode without a recording, or one with an attack in it
  kBeyondRecording = 10,      ///< the recording ends before the impact
  kInvalidInput = 11,         ///< a malformed field, for instance an unknown mode or a NaN pose
  kNodeUnavailable = 12,      ///< another node of the package did not respond
  kLowConfidence = 13,        ///< the best attack's confidence is below min_confidence
  kNotBelievable = 14,        ///< attacks exist, but none is plausible
  kRoadDoesNotAllow = 15,     ///< no lane of the type's direction passes the ego's place at impact
  kStaleScene = 16,           ///< the newest scene is older than LiveOptions::max_scene_age
  kInternalError = 17,        ///< a fault of this package, whatever the request
};
/// Returns the name of the constant in GenerateCollision.srv, for instance "NO_CANDIDATE".
const char* toString(StatusCode code);
/// Returns true for codes that depend on the scene or t0, so that the request may succeed at
/// another t0 or in another scene: kNoCandidate, kNoAttackWithinLimits, kBeyondRecording,
/// kLowConfidence, kNotBelievable and kRoadDoesNotAllow.
bool dependsOnScene(StatusCode code);
/// Returns the code of a name as toString() spells it (upper case); nullopt for an unknown name.
std::optional<StatusCode> statusCodeFromString(const std::string& name);

/// Outcome of a request with a message.
struct Status {
  StatusCode code = StatusCode::kOk;
  /// Reason for people, which names the field and its value; usually empty with kOk.
  std::string message;
};

}  // namespace forge
