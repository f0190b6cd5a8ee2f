// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the file of a name's language.
#include "fuzz_target.hpp"
#include "name_language_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_name_language)
