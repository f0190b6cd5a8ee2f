// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/xmp_value.hpp"
#include "core/base/result.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// XMP as it stands in a sidecar or a photograph, readable and changeable property by property. Whatever is
/// not changed comes out as it was written, foreign namespaces, comments and processing instructions
/// included. No entity but XML's own five is ever expanded.
class XmpPacket {
public:
    /// Above this a packet is not read.
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;

    /// One that says nothing.
    XmpPacket();
    XmpPacket(XmpPacket&&) noexcept;
    XmpPacket& operator=(XmpPacket&&) noexcept;
    ~XmpPacket();

    /// UTF-8, or UTF-16 or UTF-32 with a byte order mark or recognised by their first characters. An error is
    /// the end of a sentence, such as "it is not XMP.".
    static Result<XmpPacket> from(std::string_view bytes);

    std::vector<XmpName> names() const;
    /// A property's value; none where the packet does not have it.
    std::optional<XmpValue> value(const XmpName& name) const;
    void set(const XmpName& name, const XmpValue& value);
    void remove(const XmpName& name);

    /// The whole packet as UTF-8.
    std::string bytes() const;

private:
    struct Tree;
    explicit XmpPacket(std::unique_ptr<Tree> tree);
    std::unique_ptr<Tree> tree_;
};

} // namespace tp
