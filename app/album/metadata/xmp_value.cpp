// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/xmp_value.hpp"

#include "app/album/metadata/xmp_names.hpp"

#include <algorithm>
#include <utility>

namespace tp {

bool XmpValue::operator==(const XmpValue& other) const {
    return form == other.form && text == other.text && fields == other.fields && items == other.items &&
           qualifiers == other.qualifiers;
}

bool XmpField::operator==(const XmpField& other) const { return name == other.name && value == other.value; }

XmpValue XmpValue::of(std::string_view text) {
    XmpValue value;
    value.text = text;
    return value;
}

const XmpValue* XmpValue::field(const XmpName& name) const {
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const XmpField& candidate) { return candidate.name == name; });
    return found == fields.end() ? nullptr : &found->value;
}

std::string XmpValue::language() const {
    for (const XmpField& qualifier : qualifiers)
        if (qualifier.name == xmp::language)
            return qualifier.value.text;
    return {};
}

void XmpValue::set_field(const XmpName& name, XmpValue value) {
    for (XmpField& candidate : fields)
        if (candidate.name == name) {
            candidate.value = std::move(value);
            return;
        }
    fields.push_back({name, std::move(value)});
}

void XmpValue::remove_field(const XmpName& name) {
    std::erase_if(fields, [&](const XmpField& candidate) { return candidate.name == name; });
}

} // namespace tp
