// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a report descriptor of a device with haptics, and a report of it.
#include "fuzz_target.hpp"
#include "layout_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_haptics)
