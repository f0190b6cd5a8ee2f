// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/language_runs.hpp"

#include <QChar>
#include <QLocale>
#include <QStringView>

#include <algorithm>
#include <map>
#include <set>

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

} // namespace

std::vector<LanguageRun> language_runs(const QString& text, const QString& language) {
    const std::set<QString> own = read_by(language);
    std::vector<LanguageRun> runs;
    bool only_marks = true; // in the last run so far
    for (const char32_t letter : text.toStdU32String()) {
        const bool mark = QChar::script(letter) <= QChar::Script_Common && !QChar::isDigit(letter);
        const auto found = commonest_language().find(QChar::script(letter));
        QString wanted = found == commonest_language().end() || own.contains(found->second) ? language : found->second;
        if (!runs.empty()) {
            LanguageRun& last = runs.back();
            if (mark || (wanted == "zh" && last.language == "ja"))
                wanted = last.language;
            else if (only_marks || (wanted == "ja" && last.language == "zh"))
                last.language = wanted; // a bracket before a name, kanji before kana
        }
        if (runs.empty() || runs.back().language != wanted) {
            runs.push_back({{}, wanted});
            only_marks = true;
        }
        runs.back().text += QString::fromUcs4(&letter, 1);
        only_marks = only_marks && mark;
    }
    for (LanguageRun& run : runs)
        if (run.language != language)
            run.language = language_of(run.text, run.language);
    return runs;
}

} // namespace tp
