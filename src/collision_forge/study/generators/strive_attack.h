#pragma once

#include <memory>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/study/generators/strive_network.h"

namespace forge {

/// STRIVE's search for a collision in the latent space of its traffic model (Rempe et al., CVPR
/// 2022, arXiv 2112.05077, Sec. 3.2), of the attacker asked for, at the time and with the relative
/// heading asked for. What is otherwise is named in the source. Without an attacker in the request
/// as bestOfCandidates(). No random numbers are drawn. The method throws std::runtime_error where
/// the search leaves the finite numbers.
std::unique_ptr<const AttackMethod> makeStriveAttack(std::shared_ptr<StriveNetwork> network,
                                                     const StriveOptions& model,
                                                     const StriveAttackOptions& attack,
                                                     const TrafficOptions& traffic,
                                                     const AttackOptions& options);

}  // namespace forge
