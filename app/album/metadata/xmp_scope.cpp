// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/xmp_scope.hpp"

#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_text.hpp"

namespace tp {

namespace {

/// Whether it can stand before or after the colon of a name.
bool is_plain(std::string_view part) { return !part.empty() && part.find(':') == std::string_view::npos; }

/// Whether an element's name can begin with it. As what is declared ("xmlns:-lr") the parser takes more than it
/// takes at an element's beginning, which XML 1.0, 2.3: NameStartChar, names.
bool begins_names(std::string_view prefix) {
    if (!is_plain(prefix))
        return false;
    const char first = prefix.front();
    return (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z') || first == '_' ||
           static_cast<unsigned char>(first) >= 0x80;
}

} // namespace

XmpScope::XmpScope(const XmpScope* around, pugi::xml_node element) : around_(around) {
    if (around == nullptr)
        uris_.emplace("xml", xmp::xml_uri);
    for (const pugi::xml_attribute attribute : element.attributes()) {
        const std::string_view name = attribute.name();
        if (name == "xmlns")
            uris_.emplace("", unescaped(attribute.value()));
        else if (name.starts_with("xmlns:") && begins_names(name.substr(6)))
            uris_.emplace(name.substr(6), unescaped(attribute.value()));
    }
}

std::string_view XmpScope::uri_of(std::string_view prefix) const {
    for (const XmpScope* scope = this; scope != nullptr; scope = scope->around_)
        if (const auto found = scope->uris_.find(prefix); found != scope->uris_.end())
            return found->second;
    return {};
}

std::optional<XmpName> XmpScope::resolve(std::string_view qualified) const {
    const std::size_t colon = qualified.find(':');
    const bool plain = colon == std::string_view::npos;
    const std::string_view uri = uri_of(plain ? std::string_view{} : qualified.substr(0, colon));
    const std::string_view local = plain ? qualified : qualified.substr(colon + 1);
    if (uri.empty() || !is_plain(local))
        return std::nullopt;
    return XmpName{std::string(uri), std::string(local)};
}

std::optional<std::string> XmpScope::prefix_of(std::string_view uri) const {
    for (const XmpScope* scope = this; scope != nullptr; scope = scope->around_)
        for (const auto& [prefix, candidate] : scope->uris_)
            if (candidate == uri && !prefix.empty() && uri_of(prefix) == uri)
                return prefix;
    return std::nullopt;
}

} // namespace tp
