// SPDX-License-Identifier: Apache-2.0
#include "audio/sentences/sentence_pattern.hpp"

#include "audio/sentences/sentence_ends.hpp"

namespace tp {

namespace {

/// The number of a placeholder that begins at `at`; 0: there is none.
int place_number(QStringView text, qsizetype at) {
    if (text[at] != u'%' || at + 1 == text.size() || text[at + 1] < u'1' || text[at + 1] > u'9')
        return 0;
    return text[at + 1].unicode() - u'0';
}

} // namespace

SentencePattern::SentencePattern(const char* source) : source_(source) {
    const QString text = QString::fromUtf8(source);
    qsizetype begin = 0;
    for (qsizetype at = 0; at < text.size(); ++at)
        if (place_number(text, at) != 0) {
            texts_ << text.mid(begin, at - begin);
            begin = at + 2;
        }
    texts_ << text.mid(begin);
    for (const QString& piece : texts_)
        weight_ += piece.size();
}

bool SentencePattern::is_name(qsizetype place) const {
    return texts_[place].endsWith(u'"') && texts_[place + 1].startsWith(u'"');
}

bool SentencePattern::may_fit(QStringView text) const {
    return text.size() >= weight_ && text.startsWith(texts_.first()) && text.endsWith(texts_.last());
}

std::optional<std::vector<QStringView>> SentencePattern::places_in(QStringView text, Strict strict) const {
    if (!has_places() || !may_fit(text))
        return std::nullopt;
    const qsizetype last = texts_.size() - 2;
    const qsizetype end = text.size() - texts_.last().size();
    qsizetype from = texts_.first().size();
    std::vector<QStringView> places;
    for (qsizetype place = 0; place <= last; ++place) {
        // A place holds at least one letter, unless it is a name.
        const qsizetype least = from + (is_name(place) ? 0 : 1);
        const qsizetype to = place == last ? end : text.first(end).indexOf(texts_[place + 1], least);
        if (to < least)
            return std::nullopt;
        const QStringView held = text.sliced(from, to - from);
        if (strict == Strict::yes) {
            const bool at_the_end = place == last && texts_.last().isEmpty();
            if (is_name(place) ? held.contains(u'"') : !at_the_end && next_sentence(held, 0) >= 0)
                return std::nullopt;
        }
        places.push_back(held);
        from = to + texts_[place + 1].size();
    }
    return places;
}

QString with_places(const QString& translated, const QStringList& places) {
    QString text;
    for (qsizetype at = 0; at < translated.size(); ++at) {
        const int number = place_number(translated, at);
        if (number == 0 || number > places.size()) {
            text += translated[at];
        } else {
            text += places[number - 1];
            ++at;
        }
    }
    return text;
}

} // namespace tp
