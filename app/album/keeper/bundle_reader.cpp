// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/bundle_bytes.hpp"
#include "app/album/keeper/bundle_names.hpp"
#include "app/album/keeper/bundle_parts.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::ptrdiff_t most_folders = 64;        // in each other; a name could otherwise make thousands
constexpr std::uintmax_t always_allowed = 1 << 20; // bytes, whatever the growth

constexpr const char* too_many_files = "it holds more files than any album.";
/// Of a file, its name and what programs add to it; ours take about 100.
constexpr std::uintmax_t most_directory_bytes = 512;

using Archive = std::unique_ptr<archive, decltype(&archive_read_free)>;

/// The path that an entry's name stands for; an error where it has none, or leads out of the folder.
Result<fs::path> path_of(archive_entry* entry) {
    const char* text = archive_entry_pathname_utf8(entry);
    const char* bytes = text ? text : archive_entry_pathname(entry);
    if (!bytes)
        return Error{"it holds a file without a name."};
    std::string name = bytes;
    while (name.ends_with('/'))
        name.pop_back();
    const auto decoded = path_in_bundle(name);
    if (!decoded)
        return decoded;
    if (std::distance(decoded->begin(), decoded->end()) > most_folders)
        return Error{"it holds a file in more folders than any album has."};
    return *decoded;
}

/// Packed as every program packs a ZIP file. Of the other ways LZMA alone may ask for 4 GiB of memory, in 25
/// bytes.
bool is_packed_as_usual(archive* zip) {
    const std::string_view format = archive_format_name(zip); // "ZIP 2.0 (deflation)", of the last header
    return format.ends_with("(uncompressed)") || format.ends_with("(deflation)");
}

class BundleReader {
public:
    BundleReader(const fs::path& bundle, const fs::path& folder, const BundleLimits& limits,
                 const BundleProgress& report, std::stop_token stop)
        : bundle_(bundle), folder_(folder), limits_(limits), report_(report), stop_(std::move(stop)) {}

    std::string unpack() {
        const Utf8Names names;
        std::error_code error;
        size_ = fs::file_size(bundle_, error);
        if (error || !fs::is_regular_file(bundle_, error))
            return "there is no such file.";
        std::string problem = each_entry([this](archive_entry* entry) { return look_at(entry); });
        if (!problem.empty())
            return problem;
        if (names_.empty())
            return "it is empty.";
        if (!parts_.has_photo())
            return "it holds no photograph.";
        return each_entry([this](archive_entry* entry) { return unpack_one(entry); });
    }

private:
    /// Ends at the first problem.
    template <typename Visit>
    std::string each_entry(Visit visit) {
        zip_.reset(); // which reads the bytes
        bytes_.emplace(bundle_, always_allowed + most_directory_bytes * limits_.most_files);
        zip_.reset(archive_read_new());
        archive_read_support_format_zip_seekable(zip_.get());
        if (bytes_->open_in(zip_.get()) != ARCHIVE_OK)
            return "it is not a bundle, or it is damaged.";
        archive_entry* entry = nullptr;
        for (std::size_t entries = 0;;) {
            const int next = archive_read_next_header(zip_.get(), &entry);
            if (bytes_->is_directory_too_large())
                return too_many_files;
            bytes_->directory_is_read();
            if (next == ARCHIVE_EOF)
                return {};
            if (next < ARCHIVE_WARN)
                return entries > 0 ? "it is damaged." : "it is not a bundle, or it is damaged.";
            if (++entries > limits_.most_files)
                return too_many_files;
            if (stop_.stop_requested())
                return "it was stopped.";
            if (std::string problem = visit(entry); !problem.empty())
                return problem;
        }
    }

    /// What would be wrong with an entry, be it part of the bundle or not.
    std::string look_at(archive_entry* entry) {
        const auto path = path_of(entry);
        if (!path)
            return path.error();
        if (archive_entry_is_encrypted(entry))
            return "it is locked with a password.";
        if (!is_packed_as_usual(zip_.get()))
            return "it holds " + quoted(*path) +
                   ", which is packed in an unusual way. Pack it again as an ordinary ZIP file.";
        const bool folder = archive_entry_filetype(entry) == AE_IFDIR;
        if (!folder && (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry)))
            return "it holds " + quoted(*path) + ", which is not a plain file.";
        const auto [name, is_new] = names_.emplace(*path, folder);
        if (!is_new && !(folder && name->second))
            return "it holds " + quoted(*path) + " twice.";
        if (!folder)
            parts_.add(*path);
        return {};
    }

    std::string unpack_one(archive_entry* entry) {
        const auto path = path_of(entry);
        if (!path)
            return path.error();
        if (archive_entry_filetype(entry) != AE_IFREG || !parts_.hold(*path))
            return {};
        std::string reason = make_folder((folder_ / *path).parent_path(), Readers::owner_only);
        if (!reason.empty())
            return reason;
        auto file = NewFile::beside(folder_ / *path, Readers::owner_only);
        if (!file)
            return file.error();
        reason = copy_to(*file, *path);
        if (reason.empty() && (reason = file->take_place(Existing::kept)).empty())
            return {};
        return quoted(*path) + ": " + reason;
    }

    std::string copy_to(NewFile& file, const fs::path& path) {
        std::array<char, 1 << 16> block;
        while (true) {
            const la_ssize_t count = archive_read_data(zip_.get(), block.data(), block.size());
            if (count == 0)
                return {};
            if (count < 0)
                return "it is damaged there.";
            if (stop_.stop_requested())
                return "it was stopped.";
            done_ += static_cast<std::uintmax_t>(count);
            if (done_ > limits_.most_bytes ||
                (done_ > always_allowed &&
                 static_cast<double>(done_) > limits_.most_growth * static_cast<double>(size_)))
                return "it would become too large (" + quoted(path) + ").";
            if (std::string reason = file.write({block.data(), static_cast<std::size_t>(count)});
                !reason.empty())
                return reason;
            if (report_)
                report_(static_cast<std::uintmax_t>(archive_filter_bytes(zip_.get(), -1)), size_);
        }
    }

    const fs::path& bundle_;
    const fs::path& folder_;
    const BundleLimits& limits_;
    const BundleProgress& report_;
    std::stop_token stop_;
    std::optional<BundleBytes> bytes_;
    Archive zip_{nullptr, archive_read_free}; ///< reads them, so it goes first
    std::map<fs::path, bool> names_;          ///< of all entries; whether it is a folder
    BundleParts parts_;
    std::uintmax_t size_ = 0, done_ = 0;
};

} // namespace

std::string unpack_bundle(const fs::path& bundle, const fs::path& folder, const BundleLimits& limits,
                          const BundleProgress& report, std::stop_token stop) {
    if (std::string reason = make_folder(folder, Readers::owner_only); !reason.empty())
        return "The bundle cannot be unpacked: " + reason;
    if (!entries_of(folder).empty())
        return "The bundle cannot be unpacked, because " + quoted(folder) + " is not empty.";
    const std::string reason = BundleReader(bundle, folder, limits, report, std::move(stop)).unpack();
    return reason.empty() ? reason : "The bundle " + quoted(bundle) + " cannot be used: " + reason;
}

} // namespace tp
