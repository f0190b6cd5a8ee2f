// SPDX-License-Identifier: Apache-2.0
#include "app/cli/results_file.hpp"

#include "app/cli/command_line.hpp"
#include "core/files/file_words.hpp"

#include <QFile>
#include <QJsonDocument>
#include <QJsonValue>

#include <cerrno>
#include <cstdint>
#include <utility>

namespace tp {

namespace {

constexpr std::chrono::seconds between_syncs{1};
constexpr qint64 most_result_bytes = 16 << 20; ///< a photograph with a thousand faces has 4 MB

/// What a line of results that was cut off can be: the beginning of an object.
bool is_cut_line(const QByteArray& text) { return text == "{" || text.startsWith("{\""); }

} // namespace

Result<ResultsFile> ResultsFile::open(const std::filesystem::path& file) {
    const ForeignFolder held = held_around(file);
    OpenFile opened(file, {.write = true, .make = true, .at_end = true});
    if (!opened.ok())
        return Error{"The results cannot be written to \"" + file.string() + "\": " + reason_of(errno)};
    const auto facts = opened.facts();
    if (!facts || facts->kind != FileFacts::Kind::file)
        return Error{"The results cannot be written to \"" + file.string() + "\": it is not a file."};
    // Two batches that append to one file would each do the other's photographs again.
    if (!opened.lock() && errno == EWOULDBLOCK)
        return Error{"Another batch is writing to \"" + file.string() +
                     "\": wait until it ends, or give each its own file."};
    ResultsFile results(file, std::move(opened));
    if (const std::string problem = results.read(); !problem.empty())
        return Error{problem};
    return results;
}

std::string ResultsFile::read() {
    QFile in;
    if (!in.open(open_.number(), QIODevice::ReadOnly))
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
    const int error = whole == in.size() ? 0 : open_.cut(static_cast<std::uint64_t>(whole));
    return error == 0 ? std::string() : unwritable(error);
}

std::string ResultsFile::unwritable(int error) const {
    return "The results cannot be written to \"" + file_.string() + "\": " + reason_of(error) +
           " What it holds is good; the same command continues from there.";
}

std::string ResultsFile::append(const std::string& photo, const QByteArray& line) {
    const QByteArray bytes = line + '\n';
    const Written written = open_.write({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    if (written.error != 0)
        return unwritable(written.error);
    photos_.insert(photo);
    return std::chrono::steady_clock::now() - synced_ < between_syncs ? std::string() : sync();
}

std::string ResultsFile::sync() {
    synced_ = std::chrono::steady_clock::now();
    const int error = open_.bytes_to_disk();
    return error == 0 || error == EINVAL ? std::string()
                                         : unwritable(error); // not every file system offers it
}

} // namespace tp
