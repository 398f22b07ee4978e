#pragma once

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// A vehicle that is there now, was there in the frame before, and is within candidate_radius.
bool isCandidate(const Track& agent, const Snapshot& snapshot, const PredictionOptions& options);

/// As many attacks may be asked for at once.
inline constexpr int kMaxAlternatives = 16;

/// The request with its attacker's id in full, where its beginning was given: kShortId letters or
/// more that name nobody else.
CollisionRequest withFullId(CollisionRequest request, const Snapshot& snapshot);

/// What a request says against itself: an attacker's id with the choice of a new one, a class that
/// cannot attack, a manoeuvre of another type, an impact speed or an overlap that none can
/// have, less than one attack or more than kMaxAlternatives, believable attacks within the strict
/// limits (these are those of no vehicle that drives).
Status checkControls(const CollisionRequest& request);

/// What can be said against a request before any search: TTA out of range or not a number,
/// checkControls(), too little history or a NaN in it, an ego without a size, an unknown, absent or
/// unfit attacker.
Status checkRequest(const CollisionRequest& request, const Snapshot& snapshot,
                    const PredictionOptions& options);

}  // namespace forge
