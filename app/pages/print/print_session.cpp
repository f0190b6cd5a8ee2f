// SPDX-License-Identifier: Apache-2.0
#include "app/pages/print/print_session.hpp"

#include "app/album/metadata/read_record.hpp"
#include "app/photo/people/face_names.hpp"
#include "app/photo/scene/corrections.hpp"
#include "app/photo/tactile/braille.hpp"
#include "app/photo/tactile/tactile_file.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/durable_file.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QBuffer>
#include <QByteArray>
#include <QColor>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QStandardPaths>
#include <QSvgRenderer>

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr double preview_px_per_mm = 4.0;

/// Of the pages' language, English where that has no braille here.
std::string braille_language() {
    const std::string own = QLocale().name().left(2).toStdString();
    const std::vector<std::string> all = braille_languages();
    return std::find(all.begin(), all.end(), own) == all.end() ? "en" : own;
}

} // namespace

PrintSession::Subject PrintSession::read_subject(const std::filesystem::path& photo) {
    auto extractor = FaceExtractor::create();
    if (!extractor) {
        Subject none;
        none.extraction.problem = extractor.error();
        return none;
    }
    Subject subject{with_corrections(extractor->extract(photo), photo), {}};
    if (const auto record = read_record(photo))
        subject.names = names_of_faces(subject.extraction, *record);
    return subject;
}

std::filesystem::path PrintSession::usual_folder() {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return std::filesystem::path(documents.toStdU16String()) / "TouchPhoto";
}

PrintSession::PrintSession(Narrator& narrator, EarconPlayer& earcons, Preferences& preferences,
                           std::filesystem::path folder, Read read)
    : narrator_(narrator), earcons_(earcons), preferences_(preferences), folder_(std::move(folder)),
      read_(std::move(read)) {}

// --- the photograph ---

void PrintSession::open_photo(const std::filesystem::path& photo) {
    photo_ = photo;
    looking_ = true;
    face_ = 0;
    subject_ = {};
    sheet_.reset();
    notes_.clear();
    preview_.clear();
    reading_.ask([this, photo](const std::stop_token&) -> NewestWork::Answer {
        return [this, subject = read_(photo)] { take(subject); };
    });
    emit photoChanged();
    emit sheetChanged();
    emit optionsChanged();
}

void PrintSession::take(const Subject& subject) {
    subject_ = subject;
    looking_ = false;
    emit photoChanged();
    make();
    enter();
}

void PrintSession::enter() {
    if (photo_.empty())
        return narrator_.tell(tr("Print. Choose a photograph on the page for looking after the album."), Priority::touch);
    if (looking_)
        return narrator_.tell(tr("Print %1. Looking for faces…").arg(photoName()), Priority::touch);
    narrator_.tell(ready() ? tr("Print %1 on %2.").arg(photoName(), size()) + ' ' + notes_.join(' ')
                           : notes_.join(' '),
                   Priority::touch);
}

void PrintSession::leave() { narrator_.stop(); }

// --- the sheet ---

QStringList PrintSession::papers_named() const {
    return {tr("A4"), tr("Letter"), tr("A3"), tr("Braille paper, 11 by 11.5 inches")};
}

QStringList PrintSession::faces() const {
    const std::size_t count = subject_.extraction.faces.size();
    QStringList list{count == 1 ? tr("The face") : tr("All faces")};
    for (std::size_t i = 0; count > 1 && i < count; ++i)
        list << (i < subject_.names.size() && !subject_.names[i].empty() ? QString::fromStdString(subject_.names[i])
                                                                         : tr("Face %1").arg(i + 1));
    return list;
}

QString PrintSession::size() const {
    return sheet_ ? tr("%1 by %2 millimetres")
                        .arg(QLocale().toString(sheet_->width_mm, 'f', 0), QLocale().toString(sheet_->height_mm, 'f', 0))
                  : QString();
}

void PrintSession::make() {
    TactileOptions options;
    const Paper& chosen = papers[static_cast<std::size_t>(paper_)];
    options.paper = landscape_ ? turned(chosen) : chosen;
    if (face_ > 0)
        options.face = static_cast<std::size_t>(face_ - 1);
    options.names = subject_.names;
    options.language = braille_language();
    if (titled_)
        options.title = photo_.stem().string();
    Result<TactileSheet> sheet = make_tactile_sheet(subject_.extraction, options);
    notes_.clear();
    sheet_.reset();
    if (sheet) {
        sheet_ = std::move(*sheet);
        for (const std::string& note : sheet_->notes)
            notes_ << QString::fromStdString(note);
    } else {
        const std::string& problem = subject_.extraction.problem;
        notes_ << in_persons_language(problem.empty() ? sheet.error() : problem);
    }
    draw();
    emit sheetChanged();
}

void PrintSession::draw() {
    preview_.clear();
    if (!sheet_)
        return;
    QSvgRenderer renderer(QByteArray::fromStdString(tactile_svg(*sheet_)));
    QImage picture(qRound(preview_px_per_mm * sheet_->width_mm), qRound(preview_px_per_mm * sheet_->height_mm),
                   QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    renderer.render(&painter);
    painter.end();
    QByteArray png;
    QBuffer buffer(&png);
    picture.save(&buffer, "PNG");
    preview_ = "data:image/png;base64," + QString::fromLatin1(png.toBase64());
}

void PrintSession::choosePaper(int index) {
    if (index < 0 || index >= static_cast<int>(papers.size()) || index == paper_)
        return;
    paper_ = index;
    emit optionsChanged();
    if (looking_)
        return;
    make();
    narrator_.tell(papers_named()[index] + ": " + size() + '.', Priority::touch);
}

void PrintSession::setLandscape(bool landscape) {
    if (landscape == landscape_)
        return;
    landscape_ = landscape;
    emit optionsChanged();
    if (looking_)
        return;
    make();
    narrator_.tell(size() + '.', Priority::touch);
}

void PrintSession::chooseFace(int index) {
    if (index < 0 || index >= faces().size() || index == face_)
        return;
    face_ = index;
    emit optionsChanged();
    make();
    narrator_.tell(faces()[index] + ". " + notes_.join(' '), Priority::touch);
}

void PrintSession::setTitled(bool titled) {
    if (titled == titled_)
        return;
    titled_ = titled;
    emit optionsChanged();
    if (!looking_)
        make();
    narrator_.tell(titled ? tr("With its name in print.") : tr("Without a name in print."), Priority::touch);
}

void PrintSession::store(const QString& ending) {
    const auto refuse = [this](const QString& sentence) {
        earcons_.play(Earcon::error);
        narrator_.tell(sentence, Priority::message);
    };
    if (!sheet_ || (ending != "pdf" && ending != "svg"))
        return refuse(notes_.isEmpty() ? tr("There is no sheet yet.") : notes_.join(' '));
    if (const std::string why = make_folder(folder_); !why.empty())
        return refuse(tr("The folder %1 could not be made: %2")
                          .arg(QString::fromStdU16String(folder_.u16string()), in_persons_language(why)));
    const QString stem = QString::fromStdU16String((folder_ / photo_.stem()).u16string());
    std::filesystem::path file = (stem + '.' + ending).toStdU16String();
    for (int number = 2; name_taken(file); ++number)
        file = QString("%1 %2.%3").arg(stem).arg(number).arg(ending).toStdU16String();
    const auto written = write_tactile(file, *sheet_);
    if (!written)
        return refuse(in_persons_language(written.error()));
    earcons_.play(Earcon::saved);
    narrator_.tell(tr("The sheet is stored as %1. Print it at 100 percent, unscaled.")
                       .arg(QString::fromStdU16String(file.u16string())),
                   Priority::message);
}

} // namespace tp
