// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as what a speech-dispatcher sends.
#include "fuzz_target.hpp"
#include "ssip_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_ssip)
