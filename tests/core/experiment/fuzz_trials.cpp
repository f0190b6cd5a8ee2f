// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the table of an experiment's trials.
#include "experiment_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_trials)
