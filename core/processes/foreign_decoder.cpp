// SPDX-License-Identifier: Apache-2.0
#include "core/processes/foreign_decoder.hpp"

#include "core/processes/our_programs.hpp"

#include <atomic>

namespace tp {
namespace {

std::atomic<ForeignDecoders*> in_use{nullptr};

} // namespace

ForeignDecoders::ForeignDecoders(const std::filesystem::path& program, HelperPatience patience)
    : heif(program, {"heif"}, patience), jpegs(program, {"jpegs"}, patience),
      pictures(program, {"pictures"}, patience), metadata(program, {"metadata"}, patience),
      videos(program, {"videos"}, patience), films(program, {"films"}, patience) {}

void decode_in_helpers(ForeignDecoders* decoders) { in_use = decoders; }

ForeignDecoders* foreign_decoders() { return in_use; }

ForeignDecoders& touchphoto_decoders() {
    // Never destroyed: a thread that the program's end leaves behind may still ask.
    static ForeignDecoders& decoders = *new ForeignDecoders(helper_program("touchphoto-decoder"));
    return decoders;
}

} // namespace tp
