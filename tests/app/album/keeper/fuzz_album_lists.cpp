// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes as the list of a deletion, of an import, and as a note.
#include "album_list_check.hpp"
#include "fuzz_target.hpp"

TP_FUZZ_TARGET(tp::test::complaint_about_album_lists)
