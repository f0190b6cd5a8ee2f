// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as what a decoder of videos answers, with memory for 10 x 10 pixels.
#include "film_answer_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_film_answer)
