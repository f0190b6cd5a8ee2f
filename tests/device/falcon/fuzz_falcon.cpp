// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as what comes from a Falcon, or to one.
#include "falcon_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_falcon_bytes)
