// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a Haar cascade.
#include "fuzz_target.hpp"
#include "model_file_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_haar_file)
