// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a photograph whose metadata is read.
#include "fuzz_target.hpp"
#include "photo_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_photo)
