// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/xmp_scope.hpp"
#include "app/album/metadata/xmp_value.hpp"

#include <pugixml.hpp>

namespace tp {

/// What a property's element says, in any of the spellings that RDF allows (XMP specification part 1, 7.4 to
/// 7.9). `around` is the scope of the element's parent. Recurses as deep as the element.
XmpValue read_property(pugi::xml_node element, const XmpScope& around);

/// Appends a property to an rdf:Description, whose scope is `scope`, in the one spelling that every reader
/// knows.
void write_property(pugi::xml_node description, const XmpScope& scope, const XmpName& name,
                    const XmpValue& value);

} // namespace tp
