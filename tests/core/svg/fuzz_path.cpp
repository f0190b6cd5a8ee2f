// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the path data of an SVG element.
#include "fuzz_target.hpp"
#include "path_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_path)
