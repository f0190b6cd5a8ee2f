// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as what a decoder answers, with memory for 10 x 10 pixels.
#include "fuzz_target.hpp"
#include "picture_answer_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_picture_answer)
