// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the file of the sticks' scales.
#include "fuzz_target.hpp"
#include "joystick_scale_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_joystick_scales)
