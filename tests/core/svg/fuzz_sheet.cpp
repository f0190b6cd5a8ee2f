// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes through reader, writer and reader again.
#include "fuzz_target.hpp"
#include "sheet_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about)
