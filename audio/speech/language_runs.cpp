// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/language_runs.hpp"

#include <QChar>
#include <QLocale>
#include <QStringView>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tp {

namespace {

using Script = QChar::Script;

const std::map<Script, QString>& commonest_language() {
    static const std::map<Script, QString> languages{
        {QChar::Script_Arabic, "ar"},     {QChar::Script_Armenian, "hy"},  {QChar::Script_Bengali, "bn"},
        {QChar::Script_Bopomofo, "zh"},   {QChar::Script_Cyrillic, "ru"},  {QChar::Script_Devanagari, "hi"},
        {QChar::Script_Ethiopic, "am"},   {QChar::Script_Georgian, "ka"},  {QChar::Script_Greek, "el"},
        {QChar::Script_Gujarati, "gu"},   {QChar::Script_Gurmukhi, "pa"},  {QChar::Script_Han, "zh"},
        {QChar::Script_Hangul, "ko"},     {QChar::Script_Hebrew, "he"},    {QChar::Script_Hiragana, "ja"},
        {QChar::Script_Kannada, "kn"},    {QChar::Script_Katakana, "ja"},  {QChar::Script_Malayalam, "ml"},
        {QChar::Script_Sinhala, "si"},    {QChar::Script_Tamil, "ta"},     {QChar::Script_Telugu, "te"},
        {QChar::Script_Thai, "th"}};
    return languages;
}

/// What the letters of a run say more exactly than its first one.
QString language_of(const QString& text, const QString& by_script) {
    const auto has = [&](QStringView letters) {
        return std::any_of(text.begin(), text.end(), [&](QChar each) { return letters.contains(each, Qt::CaseInsensitive); });
    };
    if (by_script == "ru" && has(u"іїєґ"))
        return "uk";
    if (by_script == "ar" && has(u"پچژگ"))
        return "fa";
    return by_script;
}

/// Scripts that the voice of a language reads; Latin is read by all.
std::set<QString> read_by(const QString& language) {
    std::set<QString> own{language.section('-', 0, 0)};
    const QLocale locale(language);
    const auto also = [&](QLocale::Language one, const char* tag) {
        if (locale.language() == one)
            own.insert(tag);
    };
    also(QLocale::Ukrainian, "ru");
    also(QLocale::Bulgarian, "ru");
    also(QLocale::Serbian, "ru");
    also(QLocale::Persian, "ar");
    also(QLocale::Urdu, "ar");
    also(QLocale::Japanese, "zh"); // its Han
    return own;
}

/// A known name in a text.
struct FoundName {
    qsizetype begin = 0, end = 0;
    QString language;
};

char32_t letter_before(const QString& text, qsizetype place) {
    const QChar last = text[place - 1];
    return last.isLowSurrogate() && place > 1 && text[place - 2].isHighSurrogate()
               ? QChar::surrogateToUcs4(text[place - 2], last)
               : last.unicode();
}

char32_t letter_at(const QString& text, qsizetype place) {
    const QChar first = text[place];
    return first.isHighSurrogate() && place + 1 < text.size() && text[place + 1].isLowSurrogate()
               ? QChar::surrogateToUcs4(first, text[place + 1])
               : first.unicode();
}

bool is_apostrophe(QChar letter) { return letter == u'\'' || letter == u'\u2019'; }

/// Whether a word may begin or end there.
bool between_words(const QString& text, qsizetype place) {
    if (place == 0 || place == text.size())
        return true;
    if (is_apostrophe(text[place]) || is_apostrophe(text[place - 1])) {
        const qsizetype mark = is_apostrophe(text[place]) ? place : place - 1;
        return mark == 0 || mark + 1 == text.size() || !QChar::isLetter(letter_before(text, mark)) ||
               !QChar::isLetter(letter_at(text, mark + 1));
    }
    const char32_t before = letter_before(text, place), after = letter_at(text, place);
    if (QChar::isMark(after))
        return false;
    if (!(QChar::isLetterOrNumber(before) || QChar::isMark(before)) || !QChar::isLetterOrNumber(after))
        return true;
    const Script one = QChar::script(before), other = QChar::script(after);
    return one != other && one > QChar::Script_Common && other > QChar::Script_Common;
}

/// Whether both are read by one voice: a country makes no other voice of a name within a sentence.
bool same_voice(const QString& one, const QString& other) {
    return one.section('-', 0, 0).compare(other.section('-', 0, 0), Qt::CaseInsensitive) == 0;
}

/// In order, none within another.
std::vector<FoundName> names_in(const QString& text, const SpokenNames& names) {
    std::vector<FoundName> found;
    for (qsizetype place = 0; place < text.size();) {
        const SpokenName* longest = nullptr;
        if (between_words(text, place))
            for (const SpokenName& each : names)
                if (!each.name.isEmpty() && (longest == nullptr || each.name.size() > longest->name.size()) &&
                    QStringView(text).mid(place).startsWith(each.name) &&
                    between_words(text, place + each.name.size()))
                    longest = &each;
        if (longest != nullptr)
            found.push_back({place, place + longest->name.size(), longest->language});
        place += longest != nullptr ? longest->name.size() : 1;
    }
    return found;
}

} // namespace

std::vector<LanguageRun> language_runs(const QString& text, const QString& language, const SpokenNames& names) {
    const std::set<QString> own = read_by(language);
    std::vector<FoundName> known = names_in(text, names);
    std::erase_if(known, [&](const FoundName& name) { return same_voice(name.language, language); });
    auto name = known.cbegin(); // the one that letters have come to, or the next
    qsizetype place = 0;
    struct Run {
        LanguageRun run;
        bool by_script = true; // its language was told by its letters alone
    };
    std::vector<Run> runs;
    bool only_marks = true; // in the last run so far
    for (const char32_t letter : text.toStdU32String()) {
        while (name != known.cend() && place >= name->end)
            ++name;
        const bool named = name != known.cend() && place >= name->begin;
        place += QChar::requiresSurrogates(letter) ? 2 : 1;
        const bool mark = QChar::script(letter) <= QChar::Script_Common && !QChar::isDigit(letter);
        const auto found = commonest_language().find(QChar::script(letter));
        QString wanted = found == commonest_language().end() || own.contains(found->second) ? language : found->second;
        if (named)
            wanted = name->language;
        if (!runs.empty()) {
            Run& last = runs.back();
            const bool by_letters = last.by_script && !named;
            if (mark || (by_letters && wanted == "zh" && last.run.language == "ja"))
                wanted = last.run.language;
            else if (only_marks || (by_letters && wanted == "ja" && last.run.language == "zh"))
                last.run.language = wanted; // a bracket before a name, kanji before kana
        }
        if (runs.empty() || runs.back().run.language != wanted) {
            runs.push_back({{{}, wanted}, true});
            only_marks = true;
        }
        runs.back().run.text += QString::fromUcs4(&letter, 1);
        runs.back().by_script = runs.back().by_script && !named;
        only_marks = only_marks && mark;
    }
    std::vector<LanguageRun> told;
    for (auto& [run, by_script] : runs) {
        if (by_script && run.language != language)
            run.language = language_of(run.text, run.language);
        if (!told.empty() && told.back().language == run.language)
            told.back().text += run.text;
        else
            told.push_back(std::move(run));
    }
    return told;
}

} // namespace tp
