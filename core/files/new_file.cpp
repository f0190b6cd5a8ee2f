// SPDX-License-Identifier: Apache-2.0
#include "core/files/new_file.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <mutex>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view temporary_start = ".touchphoto-";
constexpr std::string_view temporary_end = ".tmp";
constexpr int most_tries = 100; // names left behind by a power cut, under this process's number
constexpr int most_links = 40;  // as the system itself follows

/// A name that nobody else has, and short, however long the file's is.
fs::path temporary_beside(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    return file.parent_path() / (std::string(temporary_start) + std::to_string(::getpid()) + "-" +
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

/// Gives `from` the name `to` where no file has it; 0, or the system's error.
int rename_to_free(const fs::path& from, const fs::path& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS)
        return errno;
    if (::link(from.c_str(), to.c_str()) != 0) // a file system without that flag
        return errno;
    ::unlink(from.c_str());
    return 0;
}

/// Gives `from` the name `to`; 0, or the system's error.
int rename_over(const fs::path& from, const fs::path& to) {
    return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
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
    void remove_all() const noexcept {
        for (const fs::path& file : files_)
            ::unlink(file.c_str());
    }

private:
    std::mutex mutex_;
    std::vector<fs::path> files_;
};

} // namespace

Result<NewFile> NewFile::beside(const fs::path& place, Readers readers) {
    std::error_code error;
    if (!place.has_filename() || fs::is_directory(place, error))
        return Error{quoted(place) + " is a folder."};
    const auto linked = end_of_links(place);
    if (!linked)
        return Error{linked.error()};
    const fs::path& target = *linked;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error) && error != std::errc::permission_denied)
        return Error{"there is no folder " + quoted(folder) + "."};

    const unsigned mode = readers == Readers::owner_only ? 0600 : 0666;
    for (int tries = 0; tries < most_tries; ++tries) {
        fs::path temporary = temporary_beside(target);
        const auto held = Unfinished::all().hold();
        const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (file < 0 && errno == EEXIST)
            continue;
        if (file < 0)
            return Error{reason_of(errno)};
        struct stat before {};
        if (::stat(target.c_str(), &before) ==
            0) // where that cannot be kept, the file is still worth writing
            static_cast<void>(::fchmod(file, before.st_mode & 0777u));
        Unfinished::all().add(temporary);
        return NewFile(target, target != place, std::move(temporary), file);
    }
    return Error{"files that an earlier program left behind are in the way."};
}

NewFile::NewFile(NewFile&& other) noexcept
    : place_(std::move(other.place_)), linked_(other.linked_),
      temporary_(std::exchange(other.temporary_, {})), descriptor_(std::exchange(other.descriptor_, -1)) {}

NewFile::~NewFile() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
    if (temporary_.empty())
        return;
    const auto held = Unfinished::all().hold();
    ::unlink(temporary_.c_str());
    Unfinished::all().drop(temporary_);
}

std::string NewFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            return reason_of(errno);
        if (written > 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return {};
}

std::string NewFile::take_place(Existing existing) {
    // fsync of any descriptor brings to the disk what others wrote to the file
    if (::fsync(descriptor_) != 0)
        return reason_of(errno);
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
        swapped = ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE) == 0;
        if (!swapped)
            renamed = errno == EINVAL || errno == ENOSYS ? rename_over(temporary_, place_) : errno;
        break;
    }
    if (renamed != 0)
        return reason_of(renamed);
    Unfinished::all().drop(temporary_); // what was swapped is somebody's whole file
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
