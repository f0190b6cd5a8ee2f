// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a photograph, decoded and searched for faces.
#include "fuzz_target.hpp"
#include "picture_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_picture)
