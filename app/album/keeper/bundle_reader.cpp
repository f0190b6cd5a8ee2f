// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/path_text.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <string_view>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::ptrdiff_t most_folders = 64;        // in each other; a name could otherwise make thousands
constexpr std::uintmax_t always_allowed = 1 << 20; // bytes, whatever the growth

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
    const QString written = QString::fromStdString(name);
    const auto decoded =
        written.startsWith(QStringLiteral("%:")) ? tp::path_of(written) : Result<fs::path>(fs::path(name));
    if (!decoded || !stays_below(*decoded) || name.find('\\') != std::string::npos)
        return Error{"it holds " + quoted(fs::path(name)) + ", which would lie outside the album."};
    if (std::distance(decoded->begin(), decoded->end()) > most_folders)
        return Error{"it holds a file in more folders than any album has."};
    return *decoded;
}

/// Packed as every program packs a ZIP file. Of the other ways LZMA alone may ask for 4 GiB of memory, in 25 bytes.
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
        std::error_code error;
        size_ = fs::file_size(bundle_, error);
        if (error || !fs::is_regular_file(bundle_, error))
            return "there is no such file.";
        archive_read_support_format_zip_seekable(zip_.get());
        if (archive_read_open_filename(zip_.get(), bundle_.c_str(), 1 << 16) != ARCHIVE_OK)
            return "it is not a bundle, or it is damaged.";
        archive_entry* entry = nullptr;
        std::size_t files = 0;
        while (true) {
            const int next = archive_read_next_header(zip_.get(), &entry);
            if (next == ARCHIVE_EOF)
                return files > 0 ? std::string{} : "it is empty.";
            if (next < ARCHIVE_WARN)
                return files > 0 ? "it is damaged." : "it is not a bundle, or it is damaged.";
            if (++files > limits_.most_files)
                return "it holds more files than any album.";
            if (std::string problem = unpack_one(entry); !problem.empty())
                return problem;
        }
    }

private:
    std::string unpack_one(archive_entry* entry) {
        const auto path = path_of(entry);
        if (!path)
            return path.error();
        if (archive_entry_is_encrypted(entry))
            return "it is locked with a password.";
        if (!is_packed_as_usual(zip_.get()))
            return "it holds " + quoted(*path) + ", which is packed in an unusual way. Pack it again as an ordinary ZIP file.";
        if (archive_entry_filetype(entry) == AE_IFDIR)
            return make_folder(folder_ / *path, Readers::owner_only);
        if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry))
            return "it holds " + quoted(*path) + ", which is not a plain file.";
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
    Archive zip_{archive_read_new(), archive_read_free};
    std::uintmax_t size_ = 0, done_ = 0;
};

} // namespace

std::string unpack_bundle(const fs::path& bundle, const fs::path& folder, const BundleLimits& limits,
                          const BundleProgress& report, std::stop_token stop) {
    std::error_code error;
    if (std::string reason = make_folder(folder, Readers::owner_only); !reason.empty())
        return "The bundle cannot be unpacked: " + reason;
    if (!fs::is_empty(folder, error))
        return "The bundle cannot be unpacked, because " + quoted(folder) + " is not empty.";
    const std::string reason = BundleReader(bundle, folder, limits, report, std::move(stop)).unpack();
    return reason.empty() ? reason : "The bundle " + quoted(bundle) + " cannot be used: " + reason;
}

} // namespace tp
