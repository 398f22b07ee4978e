#pragma once

#include <optional>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Returns true if the agent may attack: a motor vehicle, or an agent of the class `wanted`, with a
/// size, present at t0 (to 1 us) and in a frame at most kMaxGap before, with finite poses, at most
/// options.candidate_radius from the ego (box centres), and not hitchedTo() another agent, which
/// would be left behind.
bool isCandidate(const Track& agent, const Snapshot& snapshot, const PredictionOptions& options,
                 const std::optional<AgentClass>& wanted = std::nullopt);

/// Returns true if the agent is slower than kStandstillSpeed (or reverses) at the newest state of
/// its track, which must have one.
bool stands(const Track& agent);

/// Returns true if the request names a class on foot (isOnFoot()) or, without a class, a person on
/// foot of the snapshot as attacker.
bool asksForPedestrian(const CollisionRequest& request, const Snapshot& snapshot);

/// Maximum number of attacks per request.
inline constexpr int kMaxAlternatives = 16;

/// Returns the request with its attacker's full id if it gives a prefix of at least kShortId
/// characters that is unique in the snapshot, else unchanged (also if it is a full id already).
CollisionRequest withFullId(CollisionRequest request, const Snapshot& snapshot);

/// Returns kInvalidInput, naming the field, if the request contradicts itself: an attacker id with
/// choice = new, a class that cannot attack, a manoeuvre of another type, an impossible range of
/// impact speed, overlap or one of kRangeControls, a turning ego in a type without one, fields
/// that exclude each other (`from_side`, `ego_side`, `impact_location`, speeds, times), a number of
/// attacks outside 1 to kMaxAlternatives, plausible or adaptive attackers with strict limits,
/// several adaptive attacks, adaptive attacks with `hidden_by` or `queue`, `queue` with another
/// type than rear_end or another manoeuvre than lead_stopped, or back_out by a recorded vehicle, on
/// a cycle or on foot, adaptively or with believable = false. Returns kOk otherwise.
Status checkControls(const CollisionRequest& request);

/// Returns the first reason to reject a request before any search, else kOk: TTA out of range or
/// NaN, checkControls(), an adaptive person on foot (asksForPedestrian()), too short or NaN
/// history, an ego without size, an unknown, absent, unfit or hitched attacker, one that moves at
/// t0 with a `departure_time`. The attacker must be named by its full id; see withFullId().
Status checkRequest(const CollisionRequest& request, const Snapshot& snapshot,
                    const PredictionOptions& options);

}  // namespace forge
