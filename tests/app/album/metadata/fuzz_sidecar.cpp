// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a sidecar, read, changed, written and read again.
#include "fuzz_target.hpp"
#include "sidecar_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_sidecar)
