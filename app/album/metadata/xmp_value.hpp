// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// A property's full name: the URI of its namespace, and its name there.
struct XmpName {
    std::string uri;
    std::string name;
    bool operator==(const XmpName&) const = default;
};

struct XmpField;

/// What a property of XMP holds (XMP specification part 1, 6.3): a text, or others. All texts are UTF-8.
struct XmpValue {
    enum class Form { text, link, structure, bag, seq, alt };

    Form form = Form::text;
    std::string text;                 ///< of a text or a link
    std::vector<XmpField> fields;     ///< of a structure
    std::vector<XmpValue> items;      ///< of a list: bag, seq or alt
    std::vector<XmpField> qualifiers; ///< what is said about the value, xml:lang above all

    static XmpValue of(std::string_view text);
    /// A structure's field; null where there is none or this is no structure.
    const XmpValue* field(const XmpName& name) const;
    /// The qualifier xml:lang; empty where there is none.
    std::string language() const;
    bool is_list() const { return form == Form::bag || form == Form::seq || form == Form::alt; }

    /// Gives a field this value, making it where it is missing.
    void set_field(const XmpName& name, XmpValue value);
    void remove_field(const XmpName& name);

    bool operator==(const XmpValue& other) const; // written out: Clang 14 crashes on a recursive default
};

struct XmpField {
    XmpName name;
    XmpValue value;
    bool operator==(const XmpField& other) const;
};

} // namespace tp
