// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <QStringView>

#include <optional>
#include <vector>

namespace tp {

/// One sentence of the list: literal text with a place for %1, %2… between each two pieces of it.
class SentencePattern {
public:
    /// How much is believed of what stands in the places.
    enum class Strict {
        yes, ///< no quotation mark within quotation marks, and a sentence ends only in the last place
        no,  ///< anything
    };

    /// `source` is UTF-8, lives as long as the program, and counts its places from %1 on.
    explicit SentencePattern(const char* source);

    const char* source() const { return source_; }
    bool has_places() const { return texts_.size() > 1; }
    /// Stands in quotation marks: a name, not to be translated.
    bool is_name(qsizetype place) const;
    /// Letters before the first place: of two patterns that fit, the one with more of them is meant.
    qsizetype letters_before() const { return texts_.first().size(); }
    /// Letters that are always the same: then the one with more of these.
    qsizetype weight() const { return weight_; }

    /// Begins and ends as the pattern does: quick to tell.
    bool may_fit(QStringView text) const;
    /// What stands in its places, or nothing where it does not fit. Each place is as short as it can be, the last one is
    /// what remains; none that is no name is empty.
    std::optional<std::vector<QStringView>> places_in(QStringView text, Strict strict) const;

private:
    const char* source_;
    QStringList texts_; ///< before, between and after the places
    qsizetype weight_ = 0;
};

/// `translated` with `places[0]` for %1 and so on; what stands in a place is not looked into.
QString with_places(const QString& translated, const QStringList& places);

} // namespace tp
