// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a file of contours placed by hand.
#include "fuzz_target.hpp"
#include "placed_truth_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_placed_truth)
