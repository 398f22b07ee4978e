#pragma once

#include <Eigen/Core>

namespace forge {

/// Dense row-major matrix of 4-byte floats.
using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace forge
