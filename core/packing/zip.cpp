// SPDX-License-Identifier: Apache-2.0
#include "core/packing/zip.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <cstddef>
#include <utility>

namespace tp {

struct ZipWriter::Open {
    explicit Open(Sink to) : sink(std::move(to)) {}

    Sink sink;
    std::string refused; ///< what the sink said
    std::unique_ptr<archive, decltype(&archive_write_free)> zip{archive_write_new(), archive_write_free};
    bool begun = false;

    std::string why() const {
        const char* const words = archive_error_string(zip.get());
        return !refused.empty() ? refused
                                : (words ? std::string(words) : std::string("it cannot be written")) + ".";
    }
    std::string begin() {
        begun = true;
        archive_write_set_format_zip(zip.get());
        archive_write_set_options(zip.get(), "zip:hdrcharset=UTF-8");
        archive_write_set_bytes_in_last_block(zip.get(), 1);
        const auto take = [](archive*, void* self, const void* bytes, std::size_t count) -> la_ssize_t {
            auto& open = *static_cast<Open*>(self);
            open.refused = open.sink({static_cast<const char*>(bytes), count});
            return open.refused.empty() ? static_cast<la_ssize_t>(count) : -1;
        };
        return archive_write_open(zip.get(), this, nullptr, take, nullptr) == ARCHIVE_OK ? std::string{}
                                                                                         : why();
    }
};

ZipWriter::ZipWriter(Sink sink) : open_(std::make_unique<Open>(std::move(sink))) {}

ZipWriter::~ZipWriter() = default;

std::string ZipWriter::add(const std::string& name, std::string_view bytes, bool is_packed) {
    archive* const zip = open_->zip.get();
    if (!open_->begun)
        if (std::string reason = open_->begin(); !reason.empty())
            return reason;
    if ((is_packed ? archive_write_zip_set_compression_store(zip)
                   : archive_write_zip_set_compression_deflate(zip)) != ARCHIVE_OK)
        return open_->why();
    const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(),
                                                                              archive_entry_free);
    archive_entry_set_pathname_utf8(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    if (archive_write_header(zip, entry.get()) < ARCHIVE_WARN)
        return open_->why();
    if (archive_write_data(zip, bytes.data(), bytes.size()) != static_cast<la_ssize_t>(bytes.size()))
        return open_->why();
    return {};
}

std::string ZipWriter::close() {
    return archive_write_close(open_->zip.get()) == ARCHIVE_OK ? std::string{} : open_->why();
}

} // namespace tp
