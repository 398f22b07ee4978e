#include "collision_forge/attack/forecast/speed_clusters.h"

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

void expectMeans(const Eigen::MatrixXd& points, const Clusters& clusters) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(clusters.centers.rows(), points.cols());
  Eigen::VectorXd members = Eigen::VectorXd::Zero(clusters.centers.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Index cluster = clusters.member[static_cast<std::size_t>(i)];
    ASSERT_LT(cluster, clusters.centers.rows());
    sums.row(cluster) += points.row(i);
    members[cluster] += 1.0;
  }
  ASSERT_GE(members.minCoeff(), 1.0);
  EXPECT_TRUE(clusters.centers.isApprox(members.cwiseInverse().asDiagonal() * sums, 1e-12));
}

TEST(ClusterPoints, CentersAreTheMeansOfTheirMembers) {
  expectMeans(threeGroups(), clusterPoints(threeGroups(), 10, 7, 1));
}

// A center may lose its last member to others that move towards it.
TEST(ClusterPoints, ClustersWithoutMembersGo) {
  int fewer = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    std::mt19937_64 engine(seed);
    Eigen::MatrixXd points(20, 1);
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      points(i) = static_cast<double>(engine() % 1000) / 1000.0;
    }
    for (int rounds = 1; rounds <= 10; ++rounds) {
      const Clusters clusters = clusterPoints(points, 6, rounds, seed);
      expectMeans(points, clusters);
      fewer += clusters.centers.rows() < 6;
    }
  }
  EXPECT_GT(fewer, 0);
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
