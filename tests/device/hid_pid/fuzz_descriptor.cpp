// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a HID device's report descriptor and, where they describe a stick, its
// reports.
#include "descriptor_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_descriptor)
