#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace forge {

/// Result of k-means.
struct Clusters {
  Eigen::MatrixXd centers;           ///< one row per non-empty cluster: its mean
  std::vector<Eigen::Index> member;  ///< one per point: row of its cluster in `centers`
};

/// Clusters the rows of `points` (at least one) by k-means (Euclidean distance) with `rounds`
/// iterations (at least one). Starts from `count` (at least one) points chosen by k-means++, or
/// from all distinct points if there are fewer. A column of `points` is a coordinate. May return
/// fewer than `count` clusters: a cluster that loses all points is dropped. Deterministic in its
/// arguments.
Clusters clusterPoints(const Eigen::MatrixXd& points, int count, int rounds, std::uint64_t seed);

}  // namespace forge
