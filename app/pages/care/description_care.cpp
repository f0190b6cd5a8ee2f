// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/description_care.hpp"

#include "app/album/metadata/read_record.hpp"
#include "app/pages/care/care_words.hpp"
#include "app/pages/care/described_in.hpp"

#include <utility>

namespace tp {

DescriptionCare::DescriptionCare(CaredPhoto& photo, CareTeller& teller, std::function<QString()> language)
    : photo_(photo), teller_(teller), language_(std::move(language)) {
    connect(&photo_, &CaredPhoto::opened, this, [this] {
        save(); // of the photograph before
        place_ = photo_.place();
        saving_ = false;
        alt_text_ = description_ = kept_alt_text_ = kept_description_ = QString();
        emit changed();
    });
    connect(&photo_, &CaredPhoto::changed, this, &DescriptionCare::read);
}

/// What the record says, unless a person has typed something else that is not kept yet.
void DescriptionCare::read() {
    if (saving_)
        return;
    const std::string tag = described_in(photo_.record(), language_());
    const bool typed_alt_text = alt_text_ != kept_alt_text_;
    const bool typed_description = description_ != kept_description_;
    kept_alt_text_ = text_in(photo_.record().alt_text, tag);
    kept_description_ = text_in(photo_.record().description, tag);
    if (!typed_alt_text)
        alt_text_ = kept_alt_text_;
    if (!typed_description)
        description_ = kept_description_;
    emit changed();
}

QString DescriptionCare::languageName() const { return CareWords::language(language_()); }

void DescriptionCare::typeAltText(const QString& text) {
    if (text == alt_text_)
        return;
    alt_text_ = text;
    emit changed();
}

void DescriptionCare::typeDescription(const QString& text) {
    if (text == description_)
        return;
    description_ = text;
    emit changed();
}

void DescriptionCare::save() {
    if (place_.keeper == nullptr || !unsaved() || saving_)
        return;
    saving_ = true;
    const QString alt_text = alt_text_, description = description_;
    photo_.change(
        place_,
        [language = language_(), alt_text, description](AlbumKeeper& keeper, const std::filesystem::path& photo) {
            const auto record = read_record(photo);
            return record ? keeper.describe(photo, described_in(*record, language), alt_text.trimmed().toStdString(),
                                            description.trimmed().toStdString())
                          : record.error();
        },
        [this, photo = place_.photo, alt_text, description](const QString& problem) {
            if (photo == place_.photo) {
                saving_ = false;
                if (problem.isEmpty()) { // more may have been typed meanwhile
                    kept_alt_text_ = alt_text;
                    kept_description_ = description;
                }
                read();
            }
            if (problem.isEmpty())
                teller_.did(Earcon::saved, tr("The description is saved."));
            else
                teller_.problem(problem);
        });
}

} // namespace tp
