// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/xmp_packet.hpp"

#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_rdf.hpp"
#include "app/album/metadata/xmp_scope.hpp"
#include "app/album/metadata/xmp_text.hpp"
#include "core/base/utf8.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr int most_depth = 100;              // elements in each other; real sidecars: about 12
constexpr std::size_t most_entries = 10'000; // properties; Lightroom's develop settings: some hundreds
/// Of "<", and of "=". Lightroom writes every dab of a brush as an element: 35 bytes with two of them.
constexpr std::ptrdiff_t most_marks = 1'000'000;
/// In one list of those that are compared with each other; of other programs' own there may be more.
constexpr std::ptrdiff_t most_listed = 10'000;
constexpr const char* too_many = "it has more entries than any program writes.";

/// Nothing is translated on the way in or out, so that what nobody changes comes out as it was.
constexpr unsigned parse_options = pugi::parse_pi | pugi::parse_comments | pugi::parse_declaration |
                                   pugi::parse_doctype | pugi::parse_cdata | pugi::parse_ws_pcdata |
                                   pugi::parse_fragment;
constexpr unsigned write_options = pugi::format_raw | pugi::format_no_escapes | pugi::format_no_declaration;

constexpr std::string_view empty_packet =
    "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
    "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
    " <rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
    "  <rdf:Description rdf:about=\"\">\n"
    "  </rdf:Description>\n"
    " </rdf:RDF>\n"
    "</x:xmpmeta>\n"
    "<?xpacket end=\"w\"?>\n";

bool too_deep(pugi::xml_node document) {
    int depth = 0;
    pugi::xml_node node = document;
    while (true) {
        if (node.first_child()) {
            node = node.first_child();
            if (++depth > most_depth)
                return true;
            continue;
        }
        while (!node.next_sibling()) {
            if (depth-- == 0)
                return false;
            node = node.parent();
        }
        node = node.next_sibling();
    }
}

/// Without escapes a quotation mark inside an attribute that was written in apostrophes would end it.
void escape_quotation_marks(pugi::xml_node document) {
    struct Walker final : pugi::xml_tree_walker {
        bool for_each(pugi::xml_node& node) override {
            for (pugi::xml_attribute attribute : node.attributes()) {
                const std::string_view value = attribute.value();
                if (value.find('"') == std::string_view::npos)
                    continue;
                std::string escaped;
                for (const char letter : value)
                    letter == '"' ? escaped += "&quot;" : escaped += letter;
                attribute.set_value(escaped.c_str());
            }
            return true;
        }
    } walker;
    document.traverse(walker);
}

/// Counted before there is a tree, which is thirty times as large as the shortest element.
bool has_too_many_marks(std::string_view bytes) {
    return std::count(bytes.begin(), bytes.end(), '<') > most_marks ||
           std::count(bytes.begin(), bytes.end(), '=') > most_marks;
}

bool is_compared(const XmpName& name) {
    const auto names = {&xmp::alt_text,          &xmp::extended_description,
                        &xmp::description,       &xmp::persons,
                        &xmp::keywords,          &xmp::regions,
                        &xmp::microsoft_regions, &xmp::tags,
                        &xmp::digikam_tags,      &xmp::lightroom_tags};
    return std::any_of(names.begin(), names.end(), [&](const XmpName* one) { return *one == name; });
}

bool lists_too_much(pugi::xml_node element) {
    const auto inner = element.children();
    return std::distance(inner.begin(), inner.end()) > 2 * most_listed || // white space between them
           std::any_of(inner.begin(), inner.end(), lists_too_much);
}

bool is_blank(pugi::xml_node node) {
    return node.type() == pugi::node_pcdata &&
           std::string_view(node.value()).find_first_not_of(" \t\r\n") == std::string_view::npos;
}

/// What comes out is UTF-8, whatever went in; a reader may take any word of the declaration for an encoding.
void declare_utf8(pugi::xml_node document) {
    for (pugi::xml_node child : document.children())
        if (child.type() == pugi::node_declaration) {
            while (child.remove_attribute(child.first_attribute())) {
            }
            child.append_attribute("version").set_value("1.0");
            child.append_attribute("encoding").set_value("UTF-8");
        }
}

} // namespace

struct XmpPacket::Tree {
    struct Property {
        XmpName name;
        pugi::xml_node description;
        pugi::xml_node element;        ///< where it is one
        pugi::xml_attribute attribute; ///< else this
    };

    pugi::xml_document document;
    std::deque<XmpScope> scopes; ///< from the document's element to rdf:RDF; each the next one's surroundings
    pugi::xml_node rdf;
    std::vector<Property> properties;

    std::string read(std::string_view bytes);
    std::string list_properties();
    XmpScope scope_of(pugi::xml_node description) const { return {&scopes.back(), description}; }

private:
    bool find_rdf(pugi::xml_node parent, const XmpScope* around, int depth);
    void list_properties(pugi::xml_node description);
};

bool XmpPacket::Tree::find_rdf(pugi::xml_node parent, const XmpScope* around, int depth) {
    for (const pugi::xml_node child : parent.children()) {
        if (child.type() != pugi::node_element)
            continue;
        const XmpScope& scope = scopes.emplace_back(around, child);
        if (const auto name = scope.resolve(child.name());
            name && name->uri == xmp::rdf_uri && name->name == "RDF") {
            rdf = child;
            return true;
        }
        if (depth > 0 && find_rdf(child, &scope, depth - 1))
            return true;
        scopes.pop_back();
    }
    return false;
}

void XmpPacket::Tree::list_properties(pugi::xml_node description) {
    const XmpScope scope = scope_of(description);
    for (const pugi::xml_attribute attribute : description.attributes())
        if (std::string_view(attribute.name()).find(':') != std::string_view::npos)
            if (auto name = scope.resolve(attribute.name());
                name && name->uri != xmp::rdf_uri && name->uri != xmp::xml_uri)
                properties.push_back({*std::move(name), description, {}, attribute});
    for (const pugi::xml_node child : description.children())
        if (child.type() == pugi::node_element && properties.size() <= most_entries) {
            const XmpScope inner(&scope, child);
            if (auto name = inner.resolve(child.name()))
                properties.push_back({*std::move(name), description, child, {}});
        }
}

std::string XmpPacket::Tree::list_properties() {
    properties.clear();
    for (const pugi::xml_node child : rdf.children()) {
        if (child.type() != pugi::node_element)
            continue;
        list_properties(child);
        if (properties.size() > most_entries)
            return too_many;
    }
    for (const Property& property : properties)
        if (is_compared(property.name) && lists_too_much(property.element))
            return "it lists more people, words or recordings than any photograph has.";
    return {};
}

std::string XmpPacket::Tree::read(std::string_view bytes) {
    if (bytes.size() > most_bytes)
        return "it is larger than " + std::to_string(most_bytes >> 20) + " MB.";
    if (has_too_many_marks(bytes))
        return too_many;
    const pugi::xml_parse_result parsed =
        document.load_buffer(bytes.data(), bytes.size(), parse_options, pugi::encoding_auto);
    if (parsed.status == pugi::status_out_of_memory)
        return "there is not enough memory for it.";
    if (!parsed)
        return "it is not whole XML.";
    if (too_deep(document))
        return "it is nested more deeply than any program writes.";
    if (!find_rdf(document, nullptr, 2))
        return "it is not XMP.";
    if (std::string fault = list_properties(); !fault.empty())
        return fault;
    escape_quotation_marks(document);
    declare_utf8(document);
    return {};
}

XmpPacket::XmpPacket(std::unique_ptr<Tree> tree) : tree_(std::move(tree)) {}
XmpPacket::XmpPacket(XmpPacket&&) noexcept = default;
XmpPacket& XmpPacket::operator=(XmpPacket&&) noexcept = default;
XmpPacket::~XmpPacket() = default;

XmpPacket::XmpPacket() : tree_(std::make_unique<Tree>()) { tree_->read(empty_packet); }

Result<XmpPacket> XmpPacket::from(std::string_view bytes) {
    auto tree = std::make_unique<Tree>();
    if (std::string fault = tree->read(bytes); !fault.empty())
        return Error{std::move(fault)};
    XmpPacket packet(std::move(tree));
    if (!is_utf8(packet.bytes()))
        return Error{"its letters are in an encoding that XMP does not allow."};
    return packet;
}

std::vector<XmpName> XmpPacket::names() const {
    std::vector<XmpName> names;
    for (const Tree::Property& property : tree_->properties)
        names.push_back(property.name);
    return names;
}

std::optional<XmpValue> XmpPacket::value(const XmpName& name) const {
    const auto found = std::find_if(tree_->properties.begin(), tree_->properties.end(),
                                    [&](const Tree::Property& property) { return property.name == name; });
    if (found == tree_->properties.end())
        return std::nullopt;
    if (found->attribute)
        return XmpValue::of(unescaped(found->attribute.value()));
    return read_property(found->element, tree_->scope_of(found->description));
}

void XmpPacket::remove(const XmpName& name) {
    std::erase_if(tree_->properties, [&](Tree::Property& property) {
        if (property.name != name)
            return false;
        if (property.attribute) {
            property.description.remove_attribute(property.attribute);
        } else {
            if (const pugi::xml_node before = property.element.previous_sibling(); is_blank(before))
                property.description.remove_child(before); // its indentation
            property.description.remove_child(property.element);
        }
        return true;
    });
}

void XmpPacket::set(const XmpName& name, const XmpValue& value) {
    remove(name);
    pugi::xml_node description =
        tree_->rdf.find_child([](pugi::xml_node child) { return child.type() == pugi::node_element; });
    if (!description) {
        const std::string rdf = tree_->scopes.back().prefix_of(xmp::rdf_uri).value_or("rdf");
        description = tree_->rdf.append_child((rdf + ":Description").c_str());
        description.append_attribute((rdf + ":about").c_str()).set_value("");
    }
    description.append_child(pugi::node_pcdata).set_value("\n   ");
    write_property(description, tree_->scope_of(description), name, value);
    tree_->properties.push_back({name, description, description.last_child(), {}});
}

std::string XmpPacket::bytes() const {
    struct Writer final : pugi::xml_writer {
        void write(const void* data, std::size_t size) override {
            text.append(static_cast<const char*>(data), size);
        }
        std::string text;
    } writer;
    tree_->document.save(writer, "", write_options, pugi::encoding_utf8);
    return std::move(writer.text);
}

} // namespace tp
