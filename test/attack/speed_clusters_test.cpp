#include "attack/speed_clusters.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace forge {
namespace {

/// 40 points each about (0, 0), (100, 0) and (0, 100), in turn.
Eigen::MatrixXd threeGroups() {
  Eigen::MatrixXd points(120, 2);
  std::mt19937_64 engine(3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    points(i, 0) = (i % 3 == 1 ? 100.0 : 0.0) + static_cast<double>(engine() % 100) / 100.0;
    points(i, 1) = (i % 3 == 2 ? 100.0 : 0.0) + static_cast<double>(engine() % 100) / 100.0;
  }
  return points;
}

TEST(ClusterPoints, GroupsThatAreApartAreFoundForEverySeed) {
  const Eigen::MatrixXd points = threeGroups();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Clusters clusters = clusterPoints(points, 3, 5, seed);
    ASSERT_EQ(clusters.centers.rows(), 3) << seed;
    for (std::size_t i = 3; i < clusters.member.size(); ++i) {
      ASSERT_EQ(clusters.member[i], clusters.member[i % 3]) << seed;
    }
    EXPECT_EQ(std::set<Eigen::Index>(clusters.member.begin(), clusters.member.end()).size(), 3u);
  }
}

TEST(ClusterPoints, CentersAreTheMeansOfTheirMembers) {
  const Eigen::MatrixXd points = threeGroups();
  const Clusters clusters = clusterPoints(points, 10, 7, 1);
  for (Eigen::Index cluster = 0; cluster < clusters.centers.rows(); ++cluster) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(2);
    int members = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (clusters.member[static_cast<std::size_t>(i)] != cluster) continue;
      sum += points.row(i);
      ++members;
    }
    ASSERT_GT(members, 0);
    EXPECT_TRUE(clusters.centers.row(cluster).isApprox(sum / members, 1e-12));
  }
}

TEST(ClusterPoints, EqualPointsAreOneCluster) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Ones(9, 2);
  points.row(4) << 2.0, 5.0;
  const Clusters clusters = clusterPoints(points, 6, 3, 0);
  ASSERT_EQ(clusters.centers.rows(), 2);
  EXPECT_NE(clusters.member[4], clusters.member[0]);
  EXPECT_EQ(clusters.member[8], clusters.member[0]);
}

TEST(ClusterPoints, TheSameSeedGivesTheSameClusters) {
  const Eigen::MatrixXd points = threeGroups();
  const Clusters a = clusterPoints(points, 12, 4, 7);
  EXPECT_EQ(a.centers, clusterPoints(points, 12, 4, 7).centers);
  EXPECT_NE(a.centers, clusterPoints(points, 12, 4, 8).centers);
}

}  // namespace
}  // namespace forge
