// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <archive.h>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace tp {

/// A bundle's bytes for libarchive, which reads the whole directory at its end into memory before it gives
/// the first file: four times as much as the directory takes, so no more of that is handed out than an album
/// may have.
class BundleBytes {
public:
    BundleBytes(const std::filesystem::path& bundle, std::uintmax_t most_of_directory)
        : stream_(bundle, std::ios::binary), most_of_directory_(most_of_directory) {}

    int open_in(archive* zip) {
        archive_read_set_callback_data(zip, this);
        archive_read_set_read_callback(zip, [](archive*, void* self, const void** bytes) {
            return static_cast<BundleBytes*>(self)->read(*bytes);
        });
        archive_read_set_seek_callback(zip, [](archive*, void* self, la_int64_t offset, int whence) {
            return static_cast<BundleBytes*>(self)->seek(offset, whence);
        });
        return archive_read_open1(zip);
    }
    void directory_is_read() { in_directory_ = false; }
    bool is_directory_too_large() const { return in_directory_ && read_ > most_of_directory_; }

private:
    la_ssize_t read(const void*& bytes) {
        if (is_directory_too_large())
            return ARCHIVE_FATAL;
        stream_.read(block_.data(), static_cast<std::streamsize>(block_.size()));
        bytes = block_.data();
        read_ += static_cast<std::uintmax_t>(stream_.gcount());
        return stream_.bad() ? ARCHIVE_FATAL : static_cast<la_ssize_t>(stream_.gcount());
    }
    la_int64_t seek(la_int64_t offset, int whence) {
        stream_.clear();
        stream_.seekg(offset, whence == SEEK_SET   ? std::ios::beg
                              : whence == SEEK_CUR ? std::ios::cur
                                                   : std::ios::end);
        return stream_ ? static_cast<la_int64_t>(stream_.tellg()) : ARCHIVE_FATAL;
    }

    std::ifstream stream_;
    std::uintmax_t most_of_directory_, read_ = 0;
    bool in_directory_ = true;
    std::array<char, 1 << 16> block_{};
};

} // namespace tp
