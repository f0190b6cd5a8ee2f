// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as what a camera gives, and tells of it.
#include "frame_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_frame)
