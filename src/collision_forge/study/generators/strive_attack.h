#pragma once

#include <memory>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/study/generators/strive_network.h"

namespace forge {

/// Creates the method strive_optimised: STRIVE's search for a collision in the latent space of its
/// traffic model (Rempe et al., CVPR 2022, arXiv 2112.05077, Sec. 3.2), with the requested
/// attacker, TTA and relative heading. For a request without attacker, tries all candidates; see
/// bestOfCandidates(). Deterministic. The method throws std::runtime_error for values that are not
/// finite. The .cpp lists deviations.
std::unique_ptr<const AttackMethod> makeStriveAttack(std::shared_ptr<StriveNetwork> network,
                                                     const StriveOptions& model,
                                                     const StriveAttackOptions& attack,
                                                     const TrafficOptions& traffic,
                                                     const AttackOptions& options);

}  // namespace forge
