// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/description_draft.hpp"

#include "app/photo/words/description.hpp"

#include <utility>

namespace tp {

DescriptionDraft::DescriptionDraft(OpenAlbum& album, CaredPhoto& photo, DescriptionCare& descriptions,
                                   CareTeller& teller, std::function<QString()> language)
    : album_(album), photo_(photo), descriptions_(descriptions), teller_(teller),
      language_(std::move(language)) {
    connect(&descriptions_, &DescriptionCare::changed, this, &DescriptionDraft::make);
}

void DescriptionDraft::looked_at(const std::filesystem::path& photo) {
    if (photo == photo_.place().photo)
        make();
}

void DescriptionDraft::make() {
    QString text;
    if (photo_.is_open() && descriptions_.altText().isEmpty()) {
        AlbumQueries queries = album_.queries();
        const auto entry = queries.find(photo_.place().photo);
        const auto known = entry && *entry ? queries.summary((*entry)->id) : std::optional<PhotoSummary>();
        const QLocale::Language language = QLocale(language_()).language();
        if (known && *known && (*known)->seen && (*known)->seen->width > 0)
            text = full_description(view_of((*known)->seen, photo_.record(), language), language);
    }
    if (std::exchange(text_, text) != text)
        emit changed();
}

void DescriptionDraft::take() {
    if (text_.isEmpty())
        return;
    const QString taken = text_;
    descriptions_.typeAltText(taken);
    teller_.tell(taken);
}

} // namespace tp
