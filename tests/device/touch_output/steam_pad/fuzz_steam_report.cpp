// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as an input report of a controller with Steam pads.
#include "fuzz_target.hpp"
#include "report_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_steam_report)
