// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/recording.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A text in several languages: BCP 47 tag → UTF-8; "x-default" is for everybody (XMP specification part
/// 1, 8.2.2.4).
using LanguageTexts = std::map<std::string, std::string>;

/// Where a photograph was taken, WGS 84.
struct Place {
    double latitude = 0.0;  ///< degrees, north positive, -90 … 90
    double longitude = 0.0; ///< degrees, east positive, -180 … 180
    bool operator==(const Place&) const = default;
};

/// A face that somebody marked, MWG regions 2.0: centre and size, 0 … 1 of the stored, unrotated picture, y
/// down.
struct FaceRegion {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    std::string name; ///< empty: nobody said who it is
    bool operator==(const FaceRegion&) const = default;
};

/// A recording attached to a photograph, as its sidecar lists it.
struct Tag {
    std::string file; ///< its name in IMG_1.jpg.tags/; never a path
    RecordingLabel label;
    double duration_s = 0.0;
    double gain_db = 0.0; ///< by which playback is evened out (EBU R 128)
    int order = 0;        ///< place in a person's own order, from 1; 0: by kind
    bool operator==(const Tag&) const = default;
};

/// What is known of a photograph from its own metadata and its sidecars. All texts are UTF-8.
struct PhotoRecord {
    int orientation = 1;             ///< EXIF, 1 … 8
    long long width = 0, height = 0; ///< px as stored; 0 where unknown
    std::string taken;               ///< ISO 8601, with its offset where the camera knew it; empty: unknown
    std::optional<Place> place;
    std::string place_name;    ///< city, region, country as far as given, separated by ", "
    LanguageTexts alt_text;    ///< Iptc4xmpCore:AltTextAccessibility
    LanguageTexts description; ///< Iptc4xmpCore:ExtDescrAccessibility, else dc:description
    std::vector<FaceRegion> faces;
    std::vector<std::string> persons;  ///< Iptc4xmpExt:PersonInImage
    std::vector<std::string> keywords; ///< dc:subject
    std::vector<Tag> tags;
    std::string content_hash; ///< what the sidecar says the photograph's SHA-256 was, hexadecimal; or empty
    std::vector<std::string> problems; ///< sentences: what could not be read or made no sense

    bool operator==(const PhotoRecord&) const = default;
};

} // namespace tp
