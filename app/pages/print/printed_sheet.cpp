// SPDX-License-Identifier: Apache-2.0
#include "app/pages/print/printed_sheet.hpp"

#include "app/pages/print/sheet_preview.hpp"
#include "app/photo/tactile/braille.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/base/result.hpp"

#include <QLocale>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

/// Of the pages' language, English where that has no braille here.
std::string braille_language() {
    const std::string own = QLocale().name().left(2).toStdString();
    const std::vector<std::string> all = braille_languages();
    return std::find(all.begin(), all.end(), own) == all.end() ? "en" : own;
}

} // namespace

PrintedSheet::PrintedSheet(const PrintedPhoto& photo, Narrator& narrator)
    : photo_(photo), narrator_(narrator) {}

void PrintedSheet::clear() {
    face_ = 0;
    sheet_.reset();
    notes_.clear();
    preview_.clear();
    emit sheetChanged();
    emit optionsChanged();
}

QStringList PrintedSheet::papers_named() const {
    return {tr("A4"), tr("Letter"), tr("A3"), tr("Braille paper, 11 by 11.5 inches")};
}

QString PrintedSheet::size() const {
    return sheet_ ? tr("%1 by %2 millimetres")
                        .arg(QLocale().toString(sheet_->width_mm, 'f', 0),
                             QLocale().toString(sheet_->height_mm, 'f', 0))
                  : QString();
}

void PrintedSheet::make() {
    TactileOptions options;
    const Paper& chosen = papers[static_cast<std::size_t>(paper_)];
    options.paper = landscape_ ? turned(chosen) : chosen;
    if (face_ > 0)
        options.face = static_cast<std::size_t>(face_ - 1);
    options.names = photo_.subject().names;
    options.language = braille_language();
    if (titled_)
        options.title = photo_.file().stem().string();
    Result<TactileSheet> sheet = make_tactile_sheet(photo_.subject().extraction, options);
    notes_.clear();
    sheet_.reset();
    if (sheet) {
        sheet_ = std::move(*sheet);
        for (const std::string& note : sheet_->notes)
            notes_ << QString::fromStdString(note);
    } else {
        const std::string& problem = photo_.subject().extraction.problem;
        notes_ << in_persons_language(problem.empty() ? sheet.error() : problem);
    }
    preview_ = sheet_ ? sheet_preview(*sheet_) : QString();
    emit sheetChanged();
}

void PrintedSheet::choosePaper(int index) {
    if (index < 0 || index >= static_cast<int>(papers.size()) || index == paper_)
        return;
    paper_ = index;
    emit optionsChanged();
    if (photo_.looking())
        return;
    make();
    narrator_.tell(papers_named()[index] + ": " + size() + '.', Priority::touch);
}

void PrintedSheet::setLandscape(bool landscape) {
    if (landscape == landscape_)
        return;
    landscape_ = landscape;
    emit optionsChanged();
    if (photo_.looking())
        return;
    make();
    narrator_.tell(size() + '.', Priority::touch);
}

void PrintedSheet::chooseFace(int index) {
    if (index < 0 || index >= photo_.faces().size() || index == face_)
        return;
    face_ = index;
    emit optionsChanged();
    make();
    narrator_.tell(photo_.faces()[index] + ". " + notes_.join(' '), Priority::touch);
}

void PrintedSheet::setTitled(bool titled) {
    if (titled == titled_)
        return;
    titled_ = titled;
    emit optionsChanged();
    if (!photo_.looking())
        make();
    narrator_.tell(titled ? tr("With the name in print.") : tr("Without the name in print."),
                   Priority::touch);
}

} // namespace tp
