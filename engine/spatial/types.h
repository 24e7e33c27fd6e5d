#pragma once

// Short names for the fixed-size vectors and matrices used everywhere.

#include <Eigen/Core>

namespace hazumi {

template <typename T>
using Vec3Of = Eigen::Matrix<T, 3, 1>;
template <typename T>
using Mat3Of = Eigen::Matrix<T, 3, 3>;

using Vec3 = Vec3Of<double>;
using Mat3 = Mat3Of<double>;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using VecX = Eigen::VectorXd;
using MatX = Eigen::MatrixXd;

}  // namespace hazumi
