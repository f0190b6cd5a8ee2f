// SPDX-License-Identifier: Apache-2.0
#include "app/photo/words/description.hpp"

#include "app/photo/words/grammars.hpp"

#include <QStringList>

#include <utility>

namespace tp {

namespace {

QString begun_large(const QString& text) {
    return text.isEmpty() ? text : text.front().toUpper() + text.mid(1);
}

QString joined(QStringList parts, const QString& between) {
    parts.removeAll(QString());
    return parts.join(between);
}

QString in_sentences(QStringList texts) {
    texts.removeAll(QString());
    for (QString& text : texts)
        text = begun_large(text) + QLatin1Char('.');
    return texts.join(QLatin1Char(' '));
}

} // namespace

const DescriptionGrammar& grammar_of(QLocale::Language language) {
    return language == QLocale::German   ? german_grammar()
           : language == QLocale::Korean ? korean_grammar()
                                         : english_grammar();
}

QString short_description(const PhotoView& view, QLocale::Language language, DescriptionOrder order) {
    const DescriptionGrammar& grammar = grammar_of(language);
    const QString where = view.where == NearTown::Where::in ? view.town : grammar.where(view);
    const QString between = QStringLiteral(", ");
    const QString circumstances = joined({grammar.month(view), where}, between);
    const QString people = grammar.people_in_short(view);
    return order == DescriptionOrder::people_first ? joined({people, circumstances}, between)
                                                   : joined({circumstances, people}, between);
}

QString taken_words(const PhotoView& view, QLocale::Language language) {
    const DescriptionGrammar& grammar = grammar_of(language);
    return in_sentences({grammar.taken(view), grammar.faults(view)});
}

QString full_description(const PhotoView& view, QLocale::Language language, DescriptionOrder order) {
    const DescriptionGrammar& grammar = grammar_of(language);
    const QString circumstances = joined({grammar.when(view), grammar.where(view)}, QStringLiteral(", "));
    QStringList sentences{grammar.people(view), grammar.picture(view)};
    if (order == DescriptionOrder::people_first)
        sentences.append(circumstances);
    else
        sentences.prepend(circumstances);
    return in_sentences(std::move(sentences));
}

} // namespace tp
