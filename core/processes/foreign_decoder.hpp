// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/processes/helper.hpp"

#include <filesystem>

namespace tp {

/// Helpers that decode what strangers made. Each kind loads its own libraries, so that none waits for those
/// of another.
struct ForeignDecoders {
    /// Of a program such as touchphoto-decoder, whose words these are.
    explicit ForeignDecoders(const std::filesystem::path& program, HelperPatience patience = {});

    HelperPool heif;     ///< HEIC and AVIF
    HelperPool jpegs;    ///< JPEG
    HelperPool pictures; ///< PNG, WebP, TIFF, BMP, JPEG 2000, raw files
    HelperPool metadata; ///< what photographs say of themselves
    HelperPool videos;   ///< their sound
    HelperPool films;    ///< the pictures of videos
};

/// From now on this program decodes what strangers made in these and not by itself. A program that does not
/// ask for it, as most tests do not, decodes by itself. Null: by itself again. They must outlive whatever
/// decodes.
void decode_in_helpers(ForeignDecoders* decoders);

/// Those; null where this program decodes by itself.
ForeignDecoders* foreign_decoders();

/// Processes of touchphoto-decoder, where helper_program() finds it. They last as long as the program does.
ForeignDecoders& touchphoto_decoders();

} // namespace tp
