// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as what the decoder answers about a photograph's metadata, in a message and in memory.
#include "fuzz_target.hpp"
#include "metadata_answer_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_metadata_answer)
