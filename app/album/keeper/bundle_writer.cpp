// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/bundle_names.hpp"
#include "app/album/keeper/import_sources.hpp"
#include "app/album/keeper/path_text.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/new_file.hpp"

#include <algorithm>
#include <archive.h>
#include <archive_entry.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <memory>

namespace tp {

namespace fs = std::filesystem;

namespace {

struct Packed {
    fs::path file;
    fs::path name; ///< in the bundle
};

/// The photograph and its companions, recordings one by one; the end of a sentence where a folder of theirs cannot be listed.
Result<std::vector<Packed>> files_of(const fs::path& album, const fs::path& photo, FolderCompanions& beside,
                                     std::vector<fs::path>& links) {
    std::vector<Packed> files;
    const auto add = [&](const fs::path& file) {
        if (link_there(file))
            links.push_back(file);
        else if (!is_temporary(file) && (file_there(file) || is_disks_fault(errno))) // which reading it tells
            files.push_back({file, file.lexically_relative(album)});
    };
    std::vector<fs::path> left;
    for (const Companion& companion : beside.of(photo, &left)) {
        if (!folder_there(companion.file)) {
            add(companion.file);
            continue;
        }
        int error = 0;
        for (const FolderEntry& file : entries_of(companion.file, &error))
            add(companion.file / file.name);
        if (error != 0)
            return Error{reason_of(error)};
    }
    if (beside.fault() != 0)
        return Error{reason_of(beside.fault())};
    for (const fs::path& one : left)
        add(one);
    add(photo);
    return files;
}

/// libarchive's own words, as the end of a sentence.
std::string zip_reason(archive* zip) {
    const char* words = archive_error_string(zip);
    return (words ? readable(words) : std::string("it cannot be written")) + ".";
}

class BundleWriter {
public:
    BundleWriter(NewFile& file, const BundleProgress& report, std::stop_token stop)
        : file_(file), report_(report), stop_(std::move(stop)) {}

    std::string write(const std::vector<Packed>& files) {
        const Utf8Names names;
        archive_write_set_format_zip(zip_.get());
        archive_write_set_options(zip_.get(), "zip:compression=store,zip:hdrcharset=UTF-8");
        archive_write_set_bytes_in_last_block(zip_.get(), 1);
        const auto take = [](archive*, void* self, const void* bytes, std::size_t count) -> la_ssize_t {
            return static_cast<BundleWriter*>(self)->take(bytes, count);
        };
        if (archive_write_open(zip_.get(), this, nullptr, take, nullptr) != ARCHIVE_OK)
            return why();
        for (const Packed& one : files)
            total_ += size_or_zero(one.file);
        for (const Packed& one : files)
            if (std::string problem = add(one); !problem.empty())
                return problem;
        return archive_write_close(zip_.get()) == ARCHIVE_OK ? std::string{} : why();
    }

private:
    la_ssize_t take(const void* bytes, std::size_t count) {
        disk_ = file_.write({static_cast<const char*>(bytes), count});
        return disk_.empty() ? static_cast<la_ssize_t>(count) : -1;
    }

    std::string why() const { return disk_.empty() ? zip_reason(zip_.get()) : disk_; }

    std::string add(const Packed& one) {
        OpenFile file(one.file, {});
        const auto facts = file.ok() ? file.facts() : std::nullopt;
        if (!facts || facts->kind != FileFacts::Kind::file)
            return link_there(one.file) ? left_alone(one.file) : quoted(one.file) + " cannot be read.";
        const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(),
                                                                                  archive_entry_free);
        archive_entry_set_pathname_utf8(entry.get(), name_in_bundle(one.name).c_str());
        archive_entry_set_size(entry.get(), static_cast<la_int64_t>(facts->bytes));
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), 0600);
        const std::chrono::nanoseconds written(facts->written_ns);
        archive_entry_set_mtime(entry.get(), std::chrono::floor<std::chrono::seconds>(written).count(), 0);
        if (archive_write_header(zip_.get(), entry.get()) < ARCHIVE_WARN)
            return why();
        std::array<char, 1 << 16> block;
        std::uintmax_t copied = 0;
        while (!stop_.stop_requested()) {
            const std::int64_t more = file.read(block);
            const auto count = static_cast<std::size_t>(std::max<std::int64_t>(more, 0));
            if (count == 0)
                break;
            if (archive_write_data(zip_.get(), block.data(), count) != static_cast<la_ssize_t>(count))
                return why();
            copied += count;
            done_ += count;
            if (report_)
                report_(done_, total_);
        }
        if (stop_.stop_requested())
            return "it was stopped.";
        return copied == facts->bytes ? std::string{} : quoted(one.file) + " changed meanwhile.";
    }

    NewFile& file_;
    const BundleProgress& report_;
    std::stop_token stop_;
    std::unique_ptr<archive, decltype(&archive_write_free)> zip_{archive_write_new(), archive_write_free};
    std::string disk_;
    std::uintmax_t done_ = 0, total_ = 0;
};

} // namespace

std::string write_bundle(const fs::path& bundle, const fs::path& album, const std::vector<fs::path>& photos,
                         const BundleProgress& report, std::stop_token stop, std::vector<fs::path>* left) {
    const ForeignFolder held(album);
    std::vector<fs::path> links;
    std::vector<Packed> files;
    FolderCompanions beside;
    for (const fs::path& photo : photos) {
        const fs::path below = photo.lexically_relative(album);
        if (!stays_below(below))
            return quoted(photo) + " is not in the album " + quoted(album) + ".";
        if (std::any_of(below.begin(), below.end(),
                        [](const fs::path& name) { return name.string().starts_with('.'); }))
            return quoted(photo) + " is hidden, and an album leaves what is hidden alone.";
        if (const auto link = link_on_the_way(photo)) {
            links.push_back(*link);
            continue;
        }
        if (!file_there(photo))
            return is_disks_fault(errno)
                       ? "The photograph " + quoted(photo) + " cannot be read: " + reason_of(errno)
                       : "There is no photograph " + quoted(photo) + ".";
        auto own = files_of(album, photo, beside, links);
        if (!own)
            return "What belongs to " + quoted(photo) + " cannot be read: " + own.error();
        for (Packed& one : *own)
            files.push_back(std::move(one));
    }
    if (files.empty() && !links.empty())
        return left_alone(links.front());
    if (left)
        *left = links;
    if (files.empty())
        return "There is no photograph to export.";
    auto file = NewFile::beside(bundle, Readers::owner_only);
    std::string reason = file ? BundleWriter(*file, report, std::move(stop)).write(files) : file.error();
    if (reason.empty())
        reason = file->take_place();
    return reason.empty() ? reason : "The bundle " + quoted(bundle) + " was not written: " + reason;
}

std::string export_bundle(const fs::path& bundle, const fs::path& album,
                          const std::vector<fs::path>& photos_and_folders, const BundleProgress& report,
                          std::stop_token stop, std::vector<fs::path>* left) {
    const ForeignFolder held(album);
    const PhotographsIn found = photographs_in(photos_and_folders);
    if (!found.unread.empty())
        return found.unread.front().sentence + " Nothing was exported.";
    const std::vector<fs::path>& links = found.links;
    std::vector<fs::path> photos;
    for (const PhotoToImport& photo : found.photos)
        photos.push_back(photo.file);
    std::string problem = write_bundle(bundle, album, photos, report, std::move(stop), left);
    if (left) { // one that lies beside a photograph is in both
        left->insert(left->end(), links.begin(), links.end());
        std::sort(left->begin(), left->end());
        left->erase(std::unique(left->begin(), left->end()), left->end());
    }
    return problem.empty() || !photos.empty() || links.empty() ? problem : left_alone(links.front());
}

} // namespace tp
