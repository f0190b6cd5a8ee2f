// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exiv2/exiv2.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace tp::test {

/// The smallest files of each kind that readers of metadata take for a picture of that size.
std::string jpeg_bytes(int width, int height);
std::string png_bytes(int width, int height);
std::string tiff_bytes(int width, int height);
std::string webp_bytes(); ///< 1 by 1
/// With a packet of XMP as its second item, as phones write it.
std::string heic_bytes(int width, int height, std::string_view xmp);

void write_bytes(const std::filesystem::path& file, std::string_view bytes);
std::string bytes_of(const std::filesystem::path& file);

/// What a photograph's own metadata is to be; the file is written by Exiv2.
struct MadeMetadata {
    Exiv2::ExifData exif;
    Exiv2::IptcData iptc;
    std::string xmp; ///< a packet
};
void add_metadata(const std::filesystem::path& photo, const MadeMetadata& metadata);

/// A packet whose rdf:Description holds these attributes and elements; all usual namespaces are declared.
std::string packet(std::string_view attributes, std::string_view elements);

} // namespace tp::test
