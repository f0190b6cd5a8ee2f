// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a FLAC file's head, and as a block of comments.
#include "flac_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_flac)
