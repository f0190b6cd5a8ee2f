// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a scene that is made ready to be felt.
#include "fuzz_target.hpp"
#include "scene_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_scene)
