// SPDX-License-Identifier: Apache-2.0
#include "app/cli/results_file.hpp"

#include <QFile>
#include <QJsonDocument>
#include <QJsonValue>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace tp {

namespace {

constexpr std::chrono::seconds between_syncs{1};
constexpr qint64 most_result_bytes = 16 << 20; ///< a photograph with a thousand faces has 4 MB

/// What a line of results that was cut off can be: the beginning of an object.
bool is_cut_line(const QByteArray& text) { return text == "{" || text.startsWith("{\""); }

std::string reason() { return std::strerror(errno); }

} // namespace

ResultsFile::ResultsFile(ResultsFile&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)),
      photos_(std::move(other.photos_)), synced_(other.synced_) {}

ResultsFile::~ResultsFile() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

Result<ResultsFile> ResultsFile::open(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0)
        return Error{"The results cannot be written to \"" + file.string() + "\": " + reason() + "."};
    ResultsFile results(file, descriptor);
    struct stat about {};
    if (::fstat(descriptor, &about) != 0 || !S_ISREG(about.st_mode))
        return Error{"The results cannot be written to \"" + file.string() + "\": it is not a file."};
    // Two batches that append to one file would each do the other's photographs again.
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return Error{"Another batch is writing to \"" + file.string() +
                     "\": wait until it ends, or give each its own file."};
    if (const std::string problem = results.read(); !problem.empty())
        return Error{problem};
    return results;
}

std::string ResultsFile::read() {
    QFile in;
    if (!in.open(descriptor_, QIODevice::ReadOnly))
        return "The results in \"" + file_.string() + "\" cannot be read.";
    qint64 whole = 0; ///< bytes up to the end of the last line that has one
    for (int number = 1; !in.atEnd(); ++number) {
        const QByteArray line = in.readLine(most_result_bytes);
        const QJsonValue photo =
            line.endsWith('\n') ? QJsonDocument::fromJson(line)[QLatin1String("photo")] : QJsonValue();
        if (!photo.isString()) {
            if (in.atEnd() && !line.endsWith('\n') && is_cut_line(line))
                break;
            return "Line " + std::to_string(number) + " of \"" + file_.string() +
                   "\" is not a result of faces --json: nothing is written to this file; name another.";
        }
        photos_.insert(photo.toString().toStdString());
        whole += line.size();
    }
    return whole == in.size() || ::ftruncate(descriptor_, whole) == 0 ? std::string() : unwritable();
}

std::string ResultsFile::unwritable() const {
    return "The results cannot be written to \"" + file_.string() + "\": " + reason() +
           ". What it holds is good; the same command continues from there.";
}

std::string ResultsFile::append(const std::string& photo, const QByteArray& line) {
    const QByteArray bytes = line + '\n';
    for (qsizetype done = 0; done < bytes.size();) {
        const ssize_t count =
            ::write(descriptor_, bytes.constData() + done, static_cast<std::size_t>(bytes.size() - done));
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return unwritable();
        done += count;
    }
    photos_.insert(photo);
    return std::chrono::steady_clock::now() - synced_ < between_syncs ? std::string() : sync();
}

std::string ResultsFile::sync() {
    synced_ = std::chrono::steady_clock::now();
    const bool failed = ::fdatasync(descriptor_) != 0 && errno != EINVAL; // not every file system offers it
    return failed ? unwritable() : std::string();
}

} // namespace tp
