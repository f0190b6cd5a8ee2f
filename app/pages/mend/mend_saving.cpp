// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_saving.hpp"

#include "audio/sentences/sentences.hpp"
#include "core/svg/contour_sheet.hpp"

#include <filesystem>

namespace tp {

MendSaving::MendSaving(MendedPhoto& photo, MendSelection& selection, MendHistory& history, Narrator& narrator)
    : photo_(photo), selection_(selection), history_(history), narrator_(narrator) {
    connect(&photo, &MendedPhoto::replaced, this, &MendSaving::begin_anew);
    connect(&photo, &MendedPhoto::changed, this, &MendSaving::follow);
}

MendSaving::~MendSaving() { write(); }

void MendSaving::begin_anew() {
    opened_ = photo_.work();
    opened_text_ = sheet_to_svg(sheet_of(opened_));
}

void MendSaving::follow() {
    text_ = sheet_to_svg(sheet_of(photo_.work()));
    unsaved_ = photo_.usable() && photo_.file().differs(photo_.work());
    emit changed();
}

QString MendSaving::write() {
    if (!photo_.usable() || !photo_.file().differs(photo_.work()))
        return {};
    return in_persons_language(photo_.file().save(photo_.work()));
}

bool MendSaving::save() {
    if (!unsaved_)
        return true;
    const QString problem = write();
    if (!problem.isEmpty()) {
        narrator_.tell(tr("%1 Your work is kept here; nothing is lost.").arg(problem), Priority::message);
        return false;
    }
    unsaved_ = false;
    emit changed();
    const std::filesystem::path& aside = photo_.file().kept_aside();
    narrator_.tell(
        aside.empty()
            ? tr("The contours are saved.")
            : tr("The contours are saved. Another program had changed them; what it wrote is kept as %1.")
                  .arg(QString::fromStdString(aside.filename().string())),
        Priority::message);
    return true;
}

void MendSaving::discard() {
    if (!canDiscard())
        return narrator_.tell(tr("Nothing was changed."), Priority::touch);
    history_.replace(tr("all changes were discarded"), opened_);
    selection_.take_handle(-1);
    narrator_.tell(tr("All changes are discarded: the contours are as they were when opened."),
                   Priority::message);
}

} // namespace tp
