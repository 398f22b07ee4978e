#pragma once

#include <Eigen/Core>

namespace forge {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace forge
