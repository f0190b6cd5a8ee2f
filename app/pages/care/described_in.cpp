// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/described_in.hpp"

#include <QLocale>

#include <functional>

namespace tp {

namespace {

QString first_part(const QString& tag) { return tag.section('-', 0, 0).toLower(); }

} // namespace

QString own_language(const Preferences& preferences) {
    const QString& chosen = preferences.choices().language;
    const QString own = chosen.isEmpty() ? QLocale().bcp47Name() : chosen;
    return own.isEmpty() || QLocale(own) == QLocale::c() ? QString("en") : own;
}

std::string described_in(const PhotoRecord& record, const QString& language) {
    const auto find = [&](const std::function<bool(const QString&)>& fits) {
        for (const LanguageTexts* texts : {&record.alt_text, &record.description})
            for (const auto& [tag, words] : *texts)
                if (!words.empty() && fits(QString::fromStdString(tag)))
                    return tag;
        return std::string{};
    };
    std::string tag = find([&](const QString& one) { return one.compare(language, Qt::CaseInsensitive) == 0; });
    if (tag.empty())
        tag = find([&](const QString& one) { return first_part(one) == first_part(language); });
    if (tag.empty())
        tag = find([](const QString& one) { return one == "x-default"; });
    return tag.empty() ? language.toStdString() : tag;
}

QString text_in(const LanguageTexts& texts, const std::string& tag) {
    const auto found = texts.find(tag);
    return found == texts.end() ? QString() : QString::fromStdString(found->second);
}

} // namespace tp
