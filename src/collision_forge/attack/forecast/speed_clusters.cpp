#include "collision_forge/attack/forecast/speed_clusters.h"

#include <random>

namespace forge {
namespace {

double uniform(std::mt19937_64& engine) {
  return (static_cast<double>(engine() >> 11) + 0.5) * 0x1.0p-53;
}

/// Returns the squared distance of each row of `points` to the point `to`.
Eigen::VectorXd squaredDistances(const Eigen::MatrixXd& points, const Eigen::RowVectorXd& to) {
  return (points.rowwise() - to).rowwise().squaredNorm();
}

/// Draws a point with probability proportional to its share of `sum`.
Eigen::Index draw(const Eigen::VectorXd& shares, double sum, std::mt19937_64& engine) {
  const double wanted = uniform(engine) * sum;
  double reached = 0.0;
  Eigen::Index last = 0;
  for (Eigen::Index i = 0; i < shares.size(); ++i) {
    if (shares[i] == 0.0) continue;
    last = i;
    reached += shares[i];
    if (reached >= wanted) break;
  }
  return last;
}

Eigen::MatrixXd startingPoints(const Eigen::MatrixXd& points, int count, std::mt19937_64& engine) {
  Eigen::MatrixXd centers(count, points.cols());
  Eigen::VectorXd distances = Eigen::VectorXd::Ones(points.rows());
  for (int i = 0; i < count; ++i) {
    const double sum = distances.sum();
    if (sum == 0.0) return centers.topRows(i);
    centers.row(i) = points.row(draw(distances, sum, engine));
    const Eigen::VectorXd to_new = squaredDistances(points, centers.row(i));
    distances = i == 0 ? to_new : distances.cwiseMin(to_new).eval();
  }
  return centers;
}

std::vector<Eigen::Index> nearestCenters(const Eigen::MatrixXd& points,
                                         const Eigen::MatrixXd& centers) {
  const Eigen::VectorXd half_norms = 0.5 * centers.rowwise().squaredNorm();
  std::vector<Eigen::Index> nearest(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    (half_norms - centers * points.row(i).transpose())
        .minCoeff(&nearest[static_cast<std::size_t>(i)]);
  }
  return nearest;
}

/// Returns the clusters' means and drops empty clusters.
Clusters meansOf(const Eigen::MatrixXd& points, std::vector<Eigen::Index> member,
                 Eigen::Index count) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(count, points.cols());
  std::vector<Eigen::Index> sizes(static_cast<std::size_t>(count), 0);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    sums.row(member[static_cast<std::size_t>(i)]) += points.row(i);
    ++sizes[static_cast<std::size_t>(member[static_cast<std::size_t>(i)])];
  }
  std::vector<Eigen::Index> place(static_cast<std::size_t>(count), 0);
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index size = sizes[static_cast<std::size_t>(i)];
    if (size == 0) continue;
    sums.row(kept) = sums.row(i) / static_cast<double>(size);
    place[static_cast<std::size_t>(i)] = kept++;
  }
  for (Eigen::Index& cluster : member) cluster = place[static_cast<std::size_t>(cluster)];
  return {sums.topRows(kept), std::move(member)};
}

}  // namespace

Clusters clusterPoints(const Eigen::MatrixXd& points, int count, int rounds, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  Clusters clusters{startingPoints(points, count, engine), {}};
  for (int round = 0; round < rounds; ++round) {
    clusters = meansOf(points, nearestCenters(points, clusters.centers), clusters.centers.rows());
  }
  return clusters;
}

}  // namespace forge
