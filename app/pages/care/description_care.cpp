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
        saving_.reset();
        typed_ = kept_ = Texts(); // and `changed` follows
        if (const auto unkept = unkept_.extract(place_.photo))
            typed_ = unkept.mapped();
    });
    connect(&photo_, &CaredPhoto::changed, this, &DescriptionCare::read);
}

/// What the record says, unless a person has typed something else that is not kept yet.
void DescriptionCare::read() {
    if (saving_)
        return;
    const std::string tag = described_in(photo_.record(), language_());
    const Texts now{text_in(photo_.record().alt_text, tag), text_in(photo_.record().description, tag)};
    if (typed_.alt_text == kept_.alt_text)
        typed_.alt_text = now.alt_text;
    if (typed_.description == kept_.description)
        typed_.description = now.description;
    kept_ = now;
    emit changed();
}

QString DescriptionCare::languageName() const { return CareWords::language(language_()); }

void DescriptionCare::typeAltText(const QString& text) {
    if (text == typed_.alt_text)
        return;
    typed_.alt_text = text;
    emit changed();
}

void DescriptionCare::typeDescription(const QString& text) {
    if (text == typed_.description)
        return;
    typed_.description = text;
    emit changed();
}

void DescriptionCare::save() {
    if (place_.keeper == nullptr || typed_ == saving_.value_or(kept_))
        return;
    saving_ = typed_;
    photo_.change(
        place_,
        [language = language_(), texts = typed_](AlbumKeeper& keeper, const std::filesystem::path& photo) {
            const auto record = read_record(photo);
            return record ? keeper.describe(photo, described_in(*record, language),
                                            texts.alt_text.trimmed().toStdString(),
                                            texts.description.trimmed().toStdString())
                          : record.error();
        },
        [this, photo = place_.photo, texts = typed_](const QString& problem) {
            if (photo != place_.photo) {
                if (!problem.isEmpty())
                    unkept_[photo] = texts;
            } else {
                if (!problem.isEmpty() && !saving_ &&
                    typed_ == kept_) // it was left and opened again meanwhile
                    typed_ = texts;
                if (saving_ == texts)
                    saving_.reset();
                if (problem.isEmpty()) // more may have been typed meanwhile
                    kept_ = texts;
                read();
            }
            if (problem.isEmpty())
                teller_.did(Earcon::saved, tr("The description is saved."));
            else
                teller_.problem(problem);
        });
}

} // namespace tp
