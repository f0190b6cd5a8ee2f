// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any text as the properties of a sidecar, face regions above all.
#include "fuzz_target.hpp"
#include "sidecar_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_regions)
