// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>

#include <archive.h>
#include <archive_entry.h>
#include <filesystem>
#include <string>
#include <vector>

namespace tp::test {

struct ZipEntry {
    std::string name;
    std::string bytes{"x"};
    unsigned type = AE_IFREG;
    std::string link{};
};

/// A zip file of these entries, as a foreign program would write it.
inline void write_zip(const std::filesystem::path& file, const std::vector<ZipEntry>& entries,
                      const char* options = "zip:compression=deflate", const char* password = nullptr) {
    archive* zip = archive_write_new();
    archive_write_set_format_zip(zip);
    archive_write_set_options(zip, options);
    if (password)
        archive_write_set_passphrase(zip, password);
    if (archive_write_open_filename(zip, file.c_str()) != ARCHIVE_OK)
        qFatal("%s", archive_error_string(zip));
    for (const ZipEntry& one : entries) {
        archive_entry* entry = archive_entry_new();
        archive_entry_set_pathname(entry, one.name.c_str());
        archive_entry_set_filetype(entry, one.type);
        archive_entry_set_perm(entry, 0666);
        if (!one.link.empty())
            archive_entry_set_symlink(entry, one.link.c_str());
        archive_entry_set_size(entry, static_cast<la_int64_t>(one.bytes.size()));
        archive_write_header(zip, entry);
        archive_write_data(zip, one.bytes.data(), one.bytes.size());
        archive_entry_free(entry);
    }
    archive_write_close(zip);
    archive_write_free(zip);
}

} // namespace tp::test
