// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a photograph that may have a video in it.
#include "fuzz_target.hpp"
#include "motion_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_motion)
