#pragma once

namespace forge {

/// How the published network tells the ego's place at the crash (arXiv 2510.12206, Sec. 3.3).
enum class PublishedHead { kRegionProposal, kTargetPoints, kRegression };

}  // namespace forge
