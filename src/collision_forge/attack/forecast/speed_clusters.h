#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace forge {

/// Points grouped around the means of the groups.
struct Clusters {
  Eigen::MatrixXd centers;           ///< a row a cluster that has members
  std::vector<Eigen::Index> member;  ///< for each point the row of its cluster
};

/// k-means: `rounds` rounds from `count` starting points that are drawn far apart (k-means++), or
/// from all distinct ones when these are fewer. `points`: a row a point, at least one. The same
/// arguments give the same clusters.
Clusters clusterPoints(const Eigen::MatrixXd& points, int count, int rounds, std::uint64_t seed);

}  // namespace forge
