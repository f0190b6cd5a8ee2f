// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// How likely it is that the range of `means` ≥ 2 means of one normal distribution is at least `q` ≥ 0 times their standard error,
/// which was estimated with `df` ≥ 1 degrees of freedom: Tukey's honestly significant difference. About twelve digits, small
/// probabilities too (Miller, Simultaneous Statistical Inference, 1981, ch. 2; by the trapezoidal rule, which converges
/// exponentially for what is analytic and dies out on both sides: Trefethen and Weideman, SIAM Review 56, 2014).
double studentized_range_above(double q, int means, double df);

} // namespace tp
