// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/xmp_value.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>

/// The namespaces and properties that the album reads or writes.
namespace tp::xmp {

inline const std::string xml_uri = "http://www.w3.org/XML/1998/namespace";
inline const std::string rdf_uri = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
inline const std::string meta_uri = "adobe:ns:meta/";

/// Ours. It ends in a slash because the readers of others add one where there is none.
inline const std::string tp_uri = "urn:touchphoto:1.0/";
inline const std::string dc_uri = "http://purl.org/dc/elements/1.1/";
inline const std::string xmp_uri = "http://ns.adobe.com/xap/1.0/";
inline const std::string exif_uri = "http://ns.adobe.com/exif/1.0/";
inline const std::string photoshop_uri = "http://ns.adobe.com/photoshop/1.0/";
inline const std::string iptc_core_uri = "http://iptc.org/std/Iptc4xmpCore/1.0/xmlns/";
inline const std::string iptc_ext_uri = "http://iptc.org/std/Iptc4xmpExt/2008-02-29/";
inline const std::string regions_uri = "http://www.metadataworkinggroup.com/schemas/regions/";
inline const std::string area_uri = "http://ns.adobe.com/xmp/sType/Area#";
inline const std::string dimensions_uri = "http://ns.adobe.com/xap/1.0/sType/Dimensions#";
inline const std::string microsoft_uri = "http://ns.microsoft.com/photo/1.2/";
inline const std::string microsoft_info_uri = "http://ns.microsoft.com/photo/1.2/t/RegionInfo#";
inline const std::string microsoft_region_uri = "http://ns.microsoft.com/photo/1.2/t/Region#";
inline const std::string digikam_uri = "http://www.digikam.org/ns/1.0/";
inline const std::string lightroom_uri = "http://ns.adobe.com/lightroom/1.0/";

/// The prefixes by which people know them, for namespaces that a file does not name yet.
inline const std::array<std::pair<std::string_view, std::string_view>, 16> usual_prefixes = {{
    {rdf_uri, "rdf"},
    {tp_uri, "tp"},
    {dc_uri, "dc"},
    {xmp_uri, "xmp"},
    {exif_uri, "exif"},
    {photoshop_uri, "photoshop"},
    {iptc_core_uri, "Iptc4xmpCore"},
    {iptc_ext_uri, "Iptc4xmpExt"},
    {regions_uri, "mwg-rs"},
    {area_uri, "stArea"},
    {dimensions_uri, "stDim"},
    {microsoft_uri, "MP"},
    {microsoft_info_uri, "MPRI"},
    {microsoft_region_uri, "MPReg"},
    {digikam_uri, "digiKam"},
    {lightroom_uri, "lr"},
}};

inline const XmpName language{xml_uri, "lang"};

inline const XmpName alt_text{iptc_core_uri, "AltTextAccessibility"};
inline const XmpName extended_description{iptc_core_uri, "ExtDescrAccessibility"};
inline const XmpName description{dc_uri, "description"};
inline const XmpName keywords{dc_uri, "subject"};
inline const XmpName persons{iptc_ext_uri, "PersonInImage"};

inline const XmpName date_taken{exif_uri, "DateTimeOriginal"};
inline const XmpName date_created{photoshop_uri, "DateCreated"};
inline const XmpName create_date{xmp_uri, "CreateDate"};
inline const XmpName latitude{exif_uri, "GPSLatitude"};
inline const XmpName longitude{exif_uri, "GPSLongitude"};
inline const XmpName location_created{iptc_ext_uri, "LocationCreated"};
inline const XmpName location_city{iptc_ext_uri, "City"};
inline const XmpName location_region{iptc_ext_uri, "ProvinceState"};
inline const XmpName location_country{iptc_ext_uri, "CountryName"};
inline const XmpName city{photoshop_uri, "City"};
inline const XmpName region{photoshop_uri, "State"};
inline const XmpName country{photoshop_uri, "Country"};
inline const XmpName sidecar_extension{photoshop_uri, "SidecarForExtension"};

inline const XmpName regions{regions_uri, "Regions"};
inline const XmpName region_list{regions_uri, "RegionList"};
inline const XmpName region_name{regions_uri, "Name"};
inline const XmpName region_type{regions_uri, "Type"};
inline const XmpName region_area{regions_uri, "Area"};
inline const XmpName applied_to{regions_uri, "AppliedToDimensions"};
inline const XmpName area_x{area_uri, "x"};
inline const XmpName area_y{area_uri, "y"};
inline const XmpName area_width{area_uri, "w"};
inline const XmpName area_height{area_uri, "h"};
inline const XmpName area_diameter{area_uri, "d"};
inline const XmpName area_unit{area_uri, "unit"};
inline const XmpName dimensions_width{dimensions_uri, "w"};
inline const XmpName dimensions_height{dimensions_uri, "h"};
inline const XmpName dimensions_unit{dimensions_uri, "unit"};

inline const XmpName microsoft_regions{microsoft_uri, "RegionInfo"};
inline const XmpName microsoft_list{microsoft_info_uri, "Regions"};
inline const XmpName microsoft_rectangle{microsoft_region_uri, "Rectangle"};
inline const XmpName microsoft_name{microsoft_region_uri, "PersonDisplayName"};

inline const XmpName digikam_tags{digikam_uri, "TagsList"};
inline const XmpName lightroom_tags{lightroom_uri, "hierarchicalSubject"};

inline const XmpName tags{tp_uri, "tags"};
inline const XmpName tag_file{tp_uri, "file"};
inline const XmpName tag_kind{tp_uri, "kind"};
inline const XmpName tag_person{tp_uri, "person"};
inline const XmpName tag_speaker{tp_uri, "speaker"};
inline const XmpName tag_language{tp_uri, "language"};
inline const XmpName tag_recorded{tp_uri, "recorded"};
inline const XmpName tag_transcript{tp_uri, "transcript"};
inline const XmpName tag_duration{tp_uri, "duration"};
inline const XmpName tag_gain{tp_uri, "gain"};
inline const XmpName tag_order{tp_uri, "order"};
inline const XmpName content_hash{tp_uri, "contentHash"};

} // namespace tp::xmp
