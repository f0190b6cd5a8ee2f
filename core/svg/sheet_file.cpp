// SPDX-License-Identifier: Apache-2.0
#include "core/base/words.hpp"
#include "core/svg/contour_sheet.hpp"
#include "core/svg/sheet_limits.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool ok() const { return number_ >= 0; }
    int number() const { return number_; }

private:
    int number_;
};

std::string quoted(const fs::path& path) { return tp::quoted(path.string()); }

/// Why the system would not: the end of a sentence.
std::string reason(int error) {
    switch (error) {
    case EACCES:
    case EPERM:
    case EROFS:
        return "you are not allowed to write there.";
    case ENOSPC:
    case EDQUOT:
        return "the disk is full.";
    case ENAMETOOLONG:
        return "its name is too long.";
    default:
        return std::generic_category().message(error) + ".";
    }
}

bool write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno != EINTR)
            return false;
        if (written > 0)
            text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// A new file beside `file`, which nobody else has. Its name is short, however long the file's is.
fs::path temporary_beside(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    return file.parent_path() /
           (".touchphoto-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
}

/// Writes the whole text to disk under a new name; 0, or the system's error.
int write_new(const fs::path& temporary, const fs::path& replaced, std::string_view text) {
    const Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.ok())
        return errno;
    struct stat before {};
    if (::stat(replaced.c_str(), &before) == 0) // where that cannot be kept, the file is still worth writing
        static_cast<void>(::fchmod(file.number(), before.st_mode & 0777u));
    if (!write_all(file.number(), text) || ::fsync(file.number()) != 0)
        return errno;
    return 0;
}

Result<fs::path> write_text(const fs::path& file, std::string_view text) {
    std::error_code error;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error) && error != std::errc::permission_denied)
        return Error{"The drawing cannot be saved: there is no folder " + quoted(folder) + "."};
    if (!file.has_filename() || fs::is_directory(file, error))
        return Error{"The drawing cannot be saved: " + quoted(file) + " is a folder."};
    // A link stays a link: what it points to is replaced.
    const fs::path linked = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    const fs::path target = error || linked.empty() ? file : linked;

    const auto failed = [&](int number) {
        return Error{"The drawing cannot be saved as " + quoted(file) + ": " + reason(number)};
    };
    fs::path temporary = temporary_beside(target);
    int trouble = write_new(temporary, target, text);
    for (int tries = 0; trouble == EEXIST && tries < 100; ++tries) { // left behind by a power cut
        temporary = temporary_beside(target);
        trouble = write_new(temporary, target, text);
    }
    if (trouble == 0 && ::rename(temporary.c_str(), target.c_str()) != 0)
        trouble = errno;
    if (trouble != 0) {
        if (trouble != EEXIST)
            ::unlink(temporary.c_str());
        return failed(trouble);
    }
    const fs::path home = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const Descriptor directory(::open(home.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.ok() && ::fsync(directory.number()) != 0 && errno != EINVAL && errno != EROFS)
        return failed(errno); // EINVAL: a file system that cannot, such as some network shares
    return file;
}

Result<std::string> text_of(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (error == std::errc::permission_denied)
        return Error{"The file " + quoted(file) + " is in a folder that you are not allowed to open."};
    if (!fs::exists(status))
        return Error{"There is no file " + quoted(file) + "."};
    if (fs::is_directory(status))
        return Error{quoted(file) + " is a folder, not a drawing."};
    if (!fs::is_regular_file(status)) // opening a pipe would wait for ever
        return Error{quoted(file) + " is not a file."};
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return Error{"The file " + quoted(file) + " cannot be opened; you may not be allowed to read it."};
    std::string text;
    std::array<char, 65536> block{};
    while (stream) {
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > svg::most_bytes)
            return Error{"The file " + quoted(file) + " is larger than 64 MB; that is no sheet of contours."};
    }
    if (stream.bad())
        return Error{"The file " + quoted(file) + " cannot be read to its end."};
    return text;
}

} // namespace

Result<ContourSheet> read_sheet(const fs::path& file, ContourSheet::Unit unit) {
    try {
        const Result<std::string> text = text_of(file);
        return text ? sheet_from_svg(*text, unit) : Error{text.error()};
    } catch (const std::exception&) {
        return Error{"The drawing could not be read: there is not enough memory for it."};
    }
}

Result<fs::path> write_sheet(const fs::path& file, const ContourSheet& sheet) {
    try {
        if (!(sheet.width > 0.0) || !(sheet.height > 0.0) || !std::isfinite(sheet.width) ||
            !std::isfinite(sheet.height))
            return Error{"The drawing cannot be saved: it needs a width and a height larger than zero."};
        return write_text(file, sheet_to_svg(sheet));
    } catch (const std::exception&) {
        return Error{"The drawing cannot be saved: there is not enough memory for it."};
    }
}

} // namespace tp
