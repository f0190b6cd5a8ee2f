// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a bundle, and as a list of what a bundle holds.
#include "bundle_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_bundle)
