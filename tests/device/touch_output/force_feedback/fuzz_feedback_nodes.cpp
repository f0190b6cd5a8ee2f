// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as what a kernel shows of an input device.
#include "fuzz_target.hpp"
#include "nodes_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_input_device)
