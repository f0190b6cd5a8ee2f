// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as a sound file of another program, and as a video with sound and pictures.
#include "fuzz_target.hpp"
#include "sound_check.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_sound)
