// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/xmp_value.hpp"

#include <pugixml.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// Which namespaces the prefixes stand for at an element. Lives at most as long as the scope around it.
class XmpScope {
public:
    XmpScope(const XmpScope* around, pugi::xml_node element);

    /// The full name behind "prefix:name"; none where the prefix stands for nothing.
    std::optional<XmpName> resolve(std::string_view qualified) const;
    /// The URI that a prefix stands for; empty where nothing.
    std::string_view uri_of(std::string_view prefix) const;
    /// A prefix that stands for the URI here; none where there is none.
    std::optional<std::string> prefix_of(std::string_view uri) const;

private:
    const XmpScope* around_;
    std::map<std::string, std::string, std::less<>> uris_; ///< prefix → URI, of this element alone
};

} // namespace tp
