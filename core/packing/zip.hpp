// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace tp {

/// A zip file without times, owners and system: the same files in the same order give the same bytes with the same libarchive.
class ZipWriter {
public:
    /// Takes the next bytes; the reason why not, else empty.
    using Sink = std::function<std::string(std::string_view bytes)>;

    explicit ZipWriter(Sink sink);
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;
    ~ZipWriter();

    // Each returns empty when done, else why not, the end of a sentence; the file is then none.

    /// `name` with `/` between folders, UTF-8. What is packed already is stored as it is.
    std::string add(const std::string& name, std::string_view bytes, bool is_packed = false);
    /// Writes its directory; it is whole.
    std::string close();

private:
    struct Open;
    std::unique_ptr<Open> open_;
};

} // namespace tp
