// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a sentence of a room without languages.
#include "fuzz_target.hpp"
#include "sentences_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_sentence)
