// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a recording that a crash left.
#include "fuzz_target.hpp"
#include "wav_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_wav)
