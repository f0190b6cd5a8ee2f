// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/import_care.hpp"

#include "app/album/index/album_queries.hpp"
#include "app/pages/care/care_words.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/file_name.hpp"

#include <QFileInfo>
#include <QMetaObject>

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

fs::path path_of_file(const QUrl& url) { return path_named(url.toLocalFile().toStdString()); }

/// Where the album has a photograph of these bytes, by an index of the calling thread.
std::function<std::optional<fs::path>(const std::string&)> known_in(const AlbumIndex& index) {
    const auto own = std::make_shared<Result<AlbumIndex>>(index.another());
    return [own](const std::string& hash) -> std::optional<fs::path> {
        if (!*own)
            return std::nullopt; // what was imported before is then told by its name and bytes in the folder
        const auto entry = AlbumQueries(**own).with_content(hash);
        return entry && *entry ? std::optional((*entry)->path) : std::nullopt;
    };
}

} // namespace

ImportCare::ImportCare(OpenAlbum& album, Preferences& preferences, CareTeller& teller)
    : album_(album), preferences_(preferences), teller_(teller) {
    pool_.setMaxThreadCount(1);
    connect(&album_, &OpenAlbum::folders_changed, this, &ImportCare::follow_folders);
    follow_folders();
}

ImportCare::~ImportCare() {
    stop_.request_stop();
    pool_.waitForDone();
}

double ImportCare::fraction() const {
    return progress_.bytes_total == 0
               ? 0.0
               : static_cast<double>(progress_.bytes_done) / static_cast<double>(progress_.bytes_total);
}

QString ImportCare::progressText() const {
    return running_ && progress_.total == 0 ? tr("Looking for photographs…")
                                            : CareWords::import_progress(progress_);
}

QStringList ImportCare::folders() const {
    QStringList names;
    for (const fs::path& folder : album_.folders())
        names << CareWords::text(folder.string());
    return names;
}

void ImportCare::setFolder(int folder) {
    if (folder < 0 || folder >= static_cast<int>(album_.folders().size()) || folder == folder_ || running_)
        return;
    into_ = album_.folders()[static_cast<std::size_t>(folder)];
    follow_folders();
}

/// An import goes to the folder that was chosen, wherever it stands now; without that one, to the first.
void ImportCare::follow_folders() {
    const std::vector<fs::path>& all = album_.folders();
    const auto same = std::find(all.begin(), all.end(), into_);
    folder_ = same == all.end() ? 0 : static_cast<int>(same - all.begin());
    into_ = all.empty() ? fs::path() : all[static_cast<std::size_t>(folder_)];
    look();
    emit foldersChanged();
}

void ImportCare::look() {
    if (running_)
        return;
    const std::vector<std::string> now =
        into_.empty() ? std::vector<std::string>{} : unfinished_imports(into_);
    QString text;
    if (const auto import =
            now.empty() ? Result<UnfinishedImport>(Error{}) : unfinished_import(into_, now.front())) {
        QStringList sources;
        for (const fs::path& source : import->sources)
            sources << CareWords::text(source.string());
        text = tr("From %1 into %2.").arg(sources.join(", "), CareWords::text(import->into.string()));
    }
    const bool other = std::exchange(unfinished_text_, text) != text;
    if (std::exchange(unfinished_, now) != now || other)
        emit changed();
}

void ImportCare::import(const QList<QUrl>& sources) {
    if (running_) {
        teller_.problem(tr("An import is running. Wait until it ends, or stop it first."));
        return;
    }
    std::vector<fs::path> paths;
    for (const QUrl& source : sources)
        if (source.isLocalFile())
            paths.push_back(path_of_file(source));
    if (paths.empty()) {
        teller_.problem(tr("Only photographs and folders on this computer can be imported."));
        return;
    }
    if (album_.folders().empty()) {
        wish_ = sources;
        teller_.tell(tr("Choose the folder to keep the album in. The photographs are copied into it."));
        emit folderWanted();
        return;
    }
    run(tr("Importing…"), [folder = into_, paths = std::move(paths)](const ImportTools& tools) {
        return import_photos(folder, {}, paths, tools);
    });
}

void ImportCare::chooseFolder(const QUrl& folder) {
    if (!folder.isLocalFile() || !QFileInfo(folder.toLocalFile()).isDir()) {
        teller_.problem(tr("The album needs a folder on this computer."));
        return;
    }
    preferences_.change([&](Choices& choices) {
        if (!choices.folders.contains(folder.toLocalFile()))
            choices.folders << folder.toLocalFile();
    });
    if (!wish_.isEmpty())
        import(std::exchange(wish_, {}));
    else
        teller_.tell(tr("The folder %1 now belongs to the album.").arg(folder.toLocalFile()));
}

void ImportCare::stop() {
    if (!running_)
        return;
    stop_.request_stop();
    teller_.answer(tr("Stopping after this photograph."));
}

void ImportCare::goOn() {
    if (!unfinished())
        return;
    run(tr("The import continues.") + " " + unfinished_text_,
        [folder = into_, id = unfinished_.front()](const ImportTools& tools) {
            return go_on_importing(folder, id, tools);
        });
}

void ImportCare::giveUp() {
    if (!unfinished())
        return;
    if (const std::string problem = give_up_import(into_, unfinished_.front()); !problem.empty())
        teller_.problem(in_persons_language(problem));
    else
        teller_.tell(tr("The import is discarded. What was imported stays."));
    look();
}

void ImportCare::run(const QString& told, Work work) {
    running_ = true;
    progress_ = {};
    report_.clear();
    problems_.clear();
    pace_ = {};
    clock_.start();
    stop_ = std::stop_source();
    teller_.tell(told);
    emit changed();
    emit progressed();
    pool_.start([this, work = std::move(work), stop = stop_.get_token()] {
        ImportTools tools;
        tools.stop = stop;
        tools.progress = [this](const ImportProgress& progress) {
            QMetaObject::invokeMethod(
                this, [this, progress] { show(progress); }, Qt::QueuedConnection);
        };
        std::optional<Result<ImportReport>> report;
        try {
            tools.known = known_in(album_.index());
            report = work(tools);
        } catch (const std::exception& fault) { // out of memory, mostly
            report = Error{std::string("The import ended, because the computer reports: ") + fault.what()};
        }
        tools.known = {}; // its index belongs to this thread
        QMetaObject::invokeMethod(
            this, [this, report = *report] { finish(report); }, Qt::QueuedConnection);
    });
}

void ImportCare::show(const ImportProgress& progress) {
    progress_ = progress;
    emit progressed();
    if (pace_.due(fraction(), static_cast<double>(clock_.elapsed()) / 1000.0))
        teller_.tell(CareWords::import_progress(progress_));
}

void ImportCare::finish(const Result<ImportReport>& report) {
    running_ = false;
    report_ = report ? CareWords::import_report(*report) : in_persons_language(report.error());
    if (report)
        for (const ImportedPhoto& photo : report->photos)
            if (!photo.problem.empty())
                problems_ << in_persons_language(photo.problem);
    look();
    emit changed();
    emit progressed();
    album_.rescan();
    const bool all_well = report && report->count(ImportedPhoto::Fate::failed) == 0;
    teller_.did(all_well ? Earcon::saved : Earcon::error, report_);
}

} // namespace tp
