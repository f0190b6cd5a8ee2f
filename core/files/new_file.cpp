// SPDX-License-Identifier: Apache-2.0
#include "core/files/new_file.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view temporary_start = ".touchphoto-";
constexpr std::string_view temporary_end = ".tmp";
constexpr std::size_t most_in_memory = 16 << 20; // bytes, which a disk takes in a fraction of a second
constexpr int most_tries = 100; // names left behind by a power cut, under this process's number
constexpr int most_links = 40;  // as the system itself follows

/// A name that nobody else has, and short, however long the file's is.
fs::path temporary_beside(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    return file.parent_path() / (std::string(temporary_start) + std::to_string(this_process()) + "-" +
                                 std::to_string(counter++) + std::string(temporary_end));
}

/// Where the links at `place` lead, though nothing be there yet.
Result<fs::path> end_of_links(fs::path place) {
    std::error_code error;
    for (int links = 0; links < most_links; ++links) {
        if (!fs::is_symlink(place, error))
            return place;
        place = place.parent_path() / fs::read_symlink(place, error);
    }
    return Error{reason_of(ELOOP)};
}

/// The temporary names that this process has given and not yet taken back.
class Unfinished {
public:
    /// Never destroyed: files are written until the very end.
    static Unfinished& all() {
        static Unfinished& files = *new Unfinished;
        return files;
    }
    /// Nothing begins or ends while it is held.
    std::unique_lock<std::mutex> hold() { return std::unique_lock(mutex_); }

    void add(const fs::path& file) { files_.push_back(file); }
    void drop(const fs::path& file) { std::erase(files_, file); }
    void remove_all() const {
        static const HeldElsewhere& until_the_end = *new HeldElsewhere(files_);
        static_cast<void>(until_the_end);
        for (const fs::path& file : files_)
            remove_name(file);
    }

private:
    std::mutex mutex_;
    std::vector<fs::path> files_;
};

alignas(64) thread_local MadeTogether* made_together = nullptr; ///< the innermost one

} // namespace

MadeTogether::MadeTogether() : outer_(std::exchange(made_together, this)) {}

MadeTogether::~MadeTogether() {
    made_together = outer_;
    const auto held = Unfinished::all().hold();
    for (const fs::path& file : unfinished_)
        Unfinished::all().drop(file);
}

Result<NewFile> NewFile::beside(const fs::path& place, Readers readers) {
    const auto there = place.has_filename() ? facts_of(place) : std::nullopt;
    if (!place.has_filename() || (there && there->kind == FileFacts::Kind::folder))
        return Error{quoted(place) + " is a folder."};
    if (there && there->kind != FileFacts::Kind::file)
        return Error{reason_of(there->kind == FileFacts::Kind::link ? ELOOP : ENXIO)};
    const auto linked = foreign_place(place) ? Result<fs::path>(place) : end_of_links(place);
    if (!linked)
        return Error{linked.error()};
    const fs::path& target = *linked;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const auto above = facts_of(folder);
    const int error = above ? 0 : errno;
    if ((above && above->kind != FileFacts::Kind::folder) || (!above && error != EACCES)) {
        if (const auto link = link_on_the_way(folder))
            return Error{left_alone(*link)};
        return Error{is_disks_fault(error) ? reason_of(error) : "there is no folder " + quoted(folder) + "."};
    }

    for (int tries = 0; tries < most_tries; ++tries) {
        fs::path temporary = temporary_beside(target);
        const auto held = Unfinished::all().hold();
        OpenFile file(temporary,
                      {.read = false, .write = true, .make = true, .only_new = true, .readers = readers});
        if (!file.ok() && errno == EEXIST)
            continue;
        if (!file.ok())
            return Error{reason_of(errno)};
        file.give_readers_of(target);
        Unfinished::all().add(temporary);
        return NewFile(target, target != place, std::move(temporary), std::move(file));
    }
    return Error{"files that an earlier program left behind are in the way."};
}

NewFile::NewFile(NewFile&& other) noexcept
    : place_(std::move(other.place_)), linked_(other.linked_),
      temporary_(std::exchange(other.temporary_, {})), file_(std::move(other.file_)),
      in_memory_(other.in_memory_) {}

NewFile::~NewFile() {
    if (temporary_.empty())
        return;
    const HeldElsewhere held_elsewhere({temporary_});
    file_.close();
    const auto held = Unfinished::all().hold();
    remove_name(temporary_);
    Unfinished::all().drop(temporary_);
}

std::string NewFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const Written written = file_.write(bytes.substr(0, most_in_memory - in_memory_));
        if (written.error != 0)
            return reason_of(written.error);
        bytes.remove_prefix(written.count);
        in_memory_ += written.count;
        if (in_memory_ < most_in_memory)
            continue;
        in_memory_ = 0;
        if (const int error = file_.bytes_out_of_memory(); error != 0)
            return reason_of(error);
    }
    return {};
}

std::string NewFile::take_place(Existing existing) {
    // what others wrote to the file, too
    if (const int error = file_.to_disk(); error != 0)
        return reason_of(error);
    auto held = Unfinished::all().hold();
    bool swapped = false;
    int renamed = 0;
    switch (existing) {
    case Existing::replaced:
        renamed = rename_over(temporary_, place_);
        break;
    case Existing::kept:
        renamed = linked_ ? EEXIST : rename_to_free(temporary_, place_);
        break;
    case Existing::swapped:
        renamed = swap_names(temporary_, place_);
        swapped = renamed == 0;
        if (renamed == EINVAL || renamed == ENOSYS)
            renamed = rename_over(temporary_, place_);
        break;
    }
    if (renamed != 0)
        return reason_of(renamed);
    Unfinished::all().drop(temporary_); // what was swapped is somebody's whole file
    if (made_together && made_together->next_completes_) {
        for (const fs::path& file : made_together->unfinished_)
            Unfinished::all().drop(file);
        made_together->unfinished_.clear();
    } else if (made_together && existing == Existing::kept) {
        Unfinished::all().add(place_);
        made_together->unfinished_.push_back(place_);
    }
    held.unlock();
    if (!swapped)
        temporary_.clear();
    return sync_folder(place_.parent_path());
}

void NewFile::give_up_all() {
    Unfinished::all().hold().release(); // for good: nothing takes its place any more
    Unfinished::all().remove_all();
}

bool is_temporary(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with(temporary_start) && name.ends_with(temporary_end);
}

} // namespace tp
