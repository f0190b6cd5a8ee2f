// SPDX-License-Identifier: Apache-2.0
#include "audio/sentences/sentences.hpp"

#include "audio/sentences/sentence_ends.hpp"
#include "audio/sentences/sentence_list.hpp"
#include "audio/sentences/sentence_pattern.hpp"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>
#include <QStringView>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace tp {

namespace {

using Strict = SentencePattern::Strict;

constexpr int deepest = 4;         ///< a sentence in a sentence in …
constexpr int most_sentences = 16; ///< one after the other, that are told apart

/// A name and a reason behind it, "%1: %2": believed where one of them is known, the name is no sentence, and after
/// everything else.
bool says_nothing(const SentencePattern& pattern) { return std::strcmp(pattern.source(), "%1: %2") == 0; }

QString translated(const char* source) { return QCoreApplication::translate("Sentence", source); }

struct SentenceBook {
    QHash<QString, const char*> whole;     ///< without a place
    std::vector<SentencePattern> patterns; ///< with places; the one that says most before its first place first

    SentenceBook() {
        for (const char* source : sentence_list()) {
            SentencePattern pattern(source);
            if (pattern.has_places())
                patterns.push_back(std::move(pattern));
            else
                whole.insert(QString::fromUtf8(source), source);
        }
        std::ranges::stable_sort(patterns, std::ranges::greater{}, &SentencePattern::weight);
        std::ranges::stable_sort(patterns, std::ranges::greater{}, &SentencePattern::letters_before);
    }
};

const SentenceBook& book() {
    static const SentenceBook all;
    return all;
}

/// One text on its way into the person's language.
class Reading {
public:
    explicit Reading(qsizetype length) : letters_left_(300'000 + 300 * length) {}

    /// Nothing where no part of it is known.
    std::optional<QString> read(QStringView text, int depth) {
        if (auto all = as_one(text, Strict::yes, depth))
            return all;
        bool every_part_known = false;
        const std::optional<QString> parts = one_after_the_other(text, depth, every_part_known);
        if (parts && every_part_known)
            return parts;
        if (auto all = as_one(text, Strict::no, depth))
            return all;
        return parts;
    }

private:
    std::optional<QString> as_one(QStringView text, Strict strict, int depth) {
        if (const auto source = book().whole.constFind(text.toString()); source != book().whole.constEnd())
            return translated(*source);
        letters_left_ -= static_cast<qsizetype>(book().patterns.size());
        for (const SentencePattern& pattern : book().patterns) {
            if (letters_left_ < 0)
                return std::nullopt;
            if (!pattern.may_fit(text) || (strict == Strict::yes && says_nothing(pattern)))
                continue;
            letters_left_ -= 2 * text.size();
            const auto places = pattern.places_in(text, strict);
            if (!places || (says_nothing(pattern) && next_sentence(places->front(), 0) >= 0))
                continue;
            if (auto all = filled(pattern, *places, depth))
                return all;
        }
        return std::nullopt;
    }

    std::optional<QString> filled(const SentencePattern& pattern, const std::vector<QStringView>& places, int depth) {
        QStringList words;
        bool known = !says_nothing(pattern);
        for (std::size_t i = 0; i < places.size(); ++i) {
            std::optional<QString> inner;
            if (depth < deepest && !pattern.is_name(static_cast<qsizetype>(i)))
                inner = read(places[i], depth + 1);
            known = known || inner;
            words << inner.value_or(places[i].toString());
        }
        return known ? std::optional(with_places(translated(pattern.source()), words)) : std::nullopt;
    }

    std::optional<QString> one_after_the_other(QStringView text, int depth, bool& every_part_known) {
        QStringList parts;
        qsizetype begin = 0;
        int tried = 0;
        for (qsizetype space = next_sentence(text, 0); space >= 0 && tried < most_sentences;
             space = next_sentence(text, space + 1), ++tried) {
            letters_left_ -= 2 * text.size();
            if (auto first = as_one(text.sliced(begin, space - begin), Strict::yes, depth)) {
                parts << *std::move(first);
                begin = space + 1;
            } else if (auto rest = as_one(text.sliced(space + 1), Strict::yes, depth)) {
                every_part_known = false;
                return (parts << as_far_as_known(text.sliced(begin, space - begin), depth) << *std::move(rest)).join(u' ');
            }
        }
        if (begin == 0)
            return std::nullopt;
        const QStringView rest = text.sliced(begin);
        const std::optional<QString> last = as_one(rest, Strict::yes, depth);
        every_part_known = last.has_value();
        return (parts << (last ? *last : as_far_as_known(rest, depth))).join(u' ');
    }

    QString as_far_as_known(QStringView text, int depth) {
        return as_one(text, Strict::no, depth).value_or(text.toString());
    }

    qsizetype letters_left_; ///< to be looked at; what needs more stays as it is
};

} // namespace

QString in_persons_language(const QString& english) {
    return Reading(english.size()).read(english, 0).value_or(english);
}

QString in_persons_language(const std::string& english) { return in_persons_language(QString::fromStdString(english)); }

} // namespace tp
