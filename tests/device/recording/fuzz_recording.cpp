// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the recording of a force device.
#include "fuzz_target.hpp"
#include "recording_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_recording)
