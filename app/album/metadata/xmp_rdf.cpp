// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/xmp_rdf.hpp"

#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_text.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace tp {

namespace {

const XmpName rdf_value{xmp::rdf_uri, "value"};
const XmpName rdf_resource{xmp::rdf_uri, "resource"};

bool is_rdf(const std::optional<XmpName>& name, std::string_view local) {
    return name && name->uri == xmp::rdf_uri && name->name == local;
}

/// Attributes that say something: not declarations, nor what RDF says of its own spelling.
bool is_field(const std::optional<XmpName>& name, std::string_view qualified) {
    if (!name || qualified.find(':') == std::string_view::npos || qualified.starts_with("xmlns:"))
        return false;
    if (name->uri == xmp::rdf_uri)
        return name->name == "value" || name->name == "resource";
    return name->uri != xmp::xml_uri;
}

pugi::xml_node first_element(pugi::xml_node parent) {
    return parent.find_child([](pugi::xml_node child) { return child.type() == pugi::node_element; });
}

std::string text_of(pugi::xml_node element) {
    std::string text;
    for (const pugi::xml_node child : element.children()) {
        if (child.type() == pugi::node_pcdata)
            text += unescaped(child.value());
        else if (child.type() == pugi::node_cdata)
            text += holdable(child.value());
    }
    return text;
}

void add_attributes(XmpValue& structure, pugi::xml_node element, const XmpScope& scope) {
    for (const pugi::xml_attribute attribute : element.attributes())
        if (auto name = scope.resolve(attribute.name()); is_field(name, attribute.name()))
            structure.fields.push_back({*std::move(name), XmpValue::of(unescaped(attribute.value()))});
}

void add_children(XmpValue& structure, pugi::xml_node element, const XmpScope& scope) {
    for (const pugi::xml_node child : element.children())
        if (child.type() == pugi::node_element)
            if (auto name = scope.resolve(child.name()))
                structure.fields.push_back({*std::move(name), read_property(child, scope)});
}

/// A structure with rdf:value is that value, and its other fields are said about it.
XmpValue with_qualifiers(XmpValue structure) {
    const auto found = std::find_if(structure.fields.begin(), structure.fields.end(),
                                    [](const XmpField& field) { return field.name == rdf_value; });
    if (found == structure.fields.end())
        return structure;
    XmpValue value = std::move(found->value);
    structure.fields.erase(found);
    std::move(structure.fields.begin(), structure.fields.end(), std::back_inserter(value.qualifiers));
    return value;
}

XmpValue read_structure(pugi::xml_node element, const XmpScope& scope) {
    XmpValue structure;
    structure.form = XmpValue::Form::structure;
    add_attributes(structure, element, scope);
    add_children(structure, element, scope);
    return with_qualifiers(std::move(structure));
}

XmpValue read_list(XmpValue::Form form, pugi::xml_node container, const XmpScope& scope) {
    XmpValue list;
    list.form = form;
    for (const pugi::xml_node child : container.children())
        if (child.type() == pugi::node_element)
            list.items.push_back(read_property(child, scope));
    return list;
}

XmpValue read_without_language(pugi::xml_node element, const XmpScope& scope) {
    for (const pugi::xml_attribute attribute : element.attributes())
        if (is_rdf(scope.resolve(attribute.name()), "parseType") &&
            std::string_view(attribute.value()) == "Resource")
            return read_structure(element, scope);
    if (const pugi::xml_node child = first_element(element)) {
        const XmpScope inner(&scope, child);
        const auto name = inner.resolve(child.name());
        if (is_rdf(name, "Bag"))
            return read_list(XmpValue::Form::bag, child, inner);
        if (is_rdf(name, "Seq"))
            return read_list(XmpValue::Form::seq, child, inner);
        if (is_rdf(name, "Alt"))
            return read_list(XmpValue::Form::alt, child, inner);
        return read_structure(child, inner);
    }
    XmpValue attributes;
    add_attributes(attributes, element, scope);
    if (attributes.fields.empty())
        return XmpValue::of(text_of(element));
    attributes.form = XmpValue::Form::structure;
    if (const XmpValue* link = attributes.field(rdf_resource)) {
        XmpValue value = *link;
        value.form = XmpValue::Form::link;
        attributes.remove_field(rdf_resource);
        value.qualifiers = std::move(attributes.fields);
        return value;
    }
    return with_qualifiers(std::move(attributes));
}

/// The prefixes that one property is written with; what the file does not name yet is declared at the
/// property.
class Prefixes {
public:
    Prefixes(const XmpScope& scope, pugi::xml_node property) : scope_(scope), property_(property) {}

    std::string qualified(const XmpName& name) {
        if (name.uri == xmp::xml_uri)
            return "xml:" + name.name;
        const auto known = prefixes_.find(name.uri);
        return (known != prefixes_.end() ? known->second : add(name.uri)) + ":" + name.name;
    }
    std::string rdf(std::string_view local) { return qualified({xmp::rdf_uri, std::string(local)}); }

private:
    std::string add(const std::string& uri) {
        const auto here = scope_.prefix_of(uri);
        std::string prefix = here && free(*here) ? *here : "";
        if (prefix.empty()) {
            const std::string wish = usual(uri);
            prefix = wish;
            for (int i = 2; !free(prefix) || !scope_.uri_of(prefix).empty(); ++i)
                prefix = wish + std::to_string(i);
            property_.append_attribute(("xmlns:" + prefix).c_str()).set_value(escaped(uri).c_str());
        }
        prefixes_.emplace(uri, prefix);
        return prefix;
    }

    bool free(const std::string& prefix) const {
        return std::none_of(prefixes_.begin(), prefixes_.end(),
                            [&](const auto& taken) { return taken.second == prefix; });
    }

    static std::string usual(const std::string& uri) {
        for (const auto& [known, prefix] : xmp::usual_prefixes)
            if (known == uri)
                return std::string(prefix);
        return "ns";
    }

    const XmpScope& scope_;
    pugi::xml_node property_;
    std::map<std::string, std::string> prefixes_; ///< URI → prefix
};

void write_value(pugi::xml_node element, const XmpValue& value, Prefixes& prefixes);

void write_field(pugi::xml_node structure, const XmpField& field, Prefixes& prefixes) {
    write_value(structure.append_child(prefixes.qualified(field.name).c_str()), field.value, prefixes);
}

void write_list(pugi::xml_node element, const char* kind, const XmpValue& list, Prefixes& prefixes) {
    pugi::xml_node container = element.append_child(prefixes.rdf(kind).c_str());
    for (const XmpValue& item : list.items)
        write_value(container.append_child(prefixes.rdf("li").c_str()), item, prefixes);
}

void set_text(pugi::xml_node element, const std::string& text) {
    if (!text.empty())
        element.append_child(pugi::node_pcdata).set_value(escaped(text).c_str());
}

void write_without_qualifiers(pugi::xml_node element, const XmpValue& value, Prefixes& prefixes) {
    const auto attribute = [&](const std::string& name, const std::string& text) {
        element.append_attribute(name.c_str()).set_value(text.c_str());
    };
    switch (value.form) {
    case XmpValue::Form::text:
        set_text(element, value.text);
        break;
    case XmpValue::Form::link:
        attribute(prefixes.rdf("resource"), escaped(value.text));
        break;
    case XmpValue::Form::structure:
        attribute(prefixes.rdf("parseType"), "Resource");
        for (const XmpField& field : value.fields)
            write_field(element, field, prefixes);
        break;
    case XmpValue::Form::bag:
        write_list(element, "Bag", value, prefixes);
        break;
    case XmpValue::Form::seq:
        write_list(element, "Seq", value, prefixes);
        break;
    case XmpValue::Form::alt:
        write_list(element, "Alt", value, prefixes);
        break;
    }
}

void write_value(pugi::xml_node element, const XmpValue& value, Prefixes& prefixes) {
    std::vector<XmpField> others;
    for (const XmpField& qualifier : value.qualifiers) {
        if (qualifier.name == xmp::language)
            element.append_attribute("xml:lang").set_value(escaped(qualifier.value.text).c_str());
        else
            others.push_back(qualifier);
    }
    if (others.empty()) {
        write_without_qualifiers(element, value, prefixes);
        return;
    }
    element.append_attribute(prefixes.rdf("parseType").c_str()).set_value("Resource");
    write_without_qualifiers(element.append_child(prefixes.rdf("value").c_str()), value, prefixes);
    for (const XmpField& qualifier : others)
        write_field(element, qualifier, prefixes);
}

} // namespace

XmpValue read_property(pugi::xml_node element, const XmpScope& around) {
    const XmpScope scope(&around, element);
    XmpValue value = read_without_language(element, scope);
    if (const pugi::xml_attribute language = element.attribute("xml:lang"))
        value.qualifiers.push_back({xmp::language, XmpValue::of(unescaped(language.value()))});
    return value;
}

void write_property(pugi::xml_node description, const XmpScope& scope, const XmpName& name,
                    const XmpValue& value) {
    pugi::xml_node property = description.append_child(pugi::node_element);
    Prefixes prefixes(scope, property);
    property.set_name(prefixes.qualified(name).c_str());
    write_value(property, value, prefixes);
}

} // namespace tp
