// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the setup beside a recording.
#include "fuzz_target.hpp"
#include "lab_setup_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_setup)
