// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the lines of a finger's path.
#include "fuzz_target.hpp"
#include "study_folder_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_path_text)
