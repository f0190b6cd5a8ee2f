// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/decode/picture_file.hpp"

#include <functional>

namespace tp {

/// Whether these are the bytes of a camera's raw file. By its first bytes: CR2 ("CR" at byte 8 of a TIFF),
/// CR3 (the brand "crx "), ORF ("IIRO", "IIRS", "MMOR" where a TIFF has "II*" or "MM"), RW2 ("IIU" and a zero
/// byte). By its first directory: DNG (it has tag 0xC612, DNGVersion), NEF and ARW (made by Nikon or Sony,
/// and the directory's picture is a reduced one: NewSubfileType 1), so that a TIFF that somebody made of such
/// a photograph stays one.
bool is_raw(const Bytes& bytes);

/// A picture that the camera put into its raw file to be shown.
struct RawPreview {
    Bytes bytes;         ///< a file of its own, mostly JPEG
    int orientation = 1; ///< EXIF, 1 … 8: the raw file's, for a preview that states none
};

/// Shows the previews that Exiv2 finds in a raw file to `enough`, the largest first, until it says that it is
/// content. One that cannot be had is left out. Throws nothing but what `enough` throws and std::bad_alloc.
void look_at_previews(const Bytes& raw, const std::function<bool(const RawPreview&)>& enough);

} // namespace tp
