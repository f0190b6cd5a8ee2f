// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a board's answers, and as what a board is sent.
#include "board_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_board_bytes)
