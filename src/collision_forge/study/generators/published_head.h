#pragma once

namespace forge {

/// The head of the published network that predicts the ego's position at the crash (arXiv
/// 2510.12206, Sec. 3.3).
enum class PublishedHead { kRegionProposal, kTargetPoints, kRegression };

}  // namespace forge
