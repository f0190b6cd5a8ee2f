// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the file of calibrations.
#include "calibration_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_calibrations)
