// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/search_words.hpp"

#include <QString>

namespace tp {

namespace {

/// What unicode61 makes words of (https://www.sqlite.org/fts5.html#unicode61_tokenizer); a mark belongs to
/// the letter before it.
bool in_word(const QString& text, qsizetype at) {
    const QChar c = text[at];
    if (c.isSurrogate()) {
        const qsizetype high = c.isLowSurrogate() ? at - 1 : at;
        return high >= 0 && high + 1 < text.size() && text[high].isHighSurrogate() &&
               text[high + 1].isLowSurrogate() &&
               QChar::isLetterOrNumber(QChar::surrogateToUcs4(text[high], text[high + 1]));
    }
    return c.isLetterOrNumber() || c.isMark() || c.category() == QChar::Other_PrivateUse;
}

} // namespace

std::vector<std::string> search_terms(std::string_view typed) {
    constexpr std::size_t most_terms = 12;
    constexpr qsizetype most_letters = 64;
    const QString text = QString::fromUtf8(typed.data(), static_cast<qsizetype>(typed.size()))
                             .normalized(QString::NormalizationForm_C);
    std::vector<std::string> terms;
    for (qsizetype begin = 0; begin < text.size() && terms.size() < most_terms;) {
        qsizetype end = begin;
        while (end < text.size() && in_word(text, end))
            ++end;
        if (end > begin) {
            const bool cut = end - begin > most_letters;
            const std::string word = text.mid(begin, cut ? most_letters : end - begin).toStdString();
            terms.push_back("\"" + word + (cut || end == text.size() ? "\"*" : "\""));
        }
        begin = end + 1;
    }
    return terms;
}

std::string all_of(const std::vector<std::string>& terms) {
    std::string query;
    for (const std::string& term : terms)
        query.append(query.empty() ? "" : " AND ").append(term);
    return query;
}

} // namespace tp
