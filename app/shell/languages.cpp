// SPDX-License-Identifier: Apache-2.0
#include "app/shell/languages.hpp"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLibraryInfo>
#include <QStringList>

namespace tp {

namespace {

/// The first of the system's languages that we have.
QString of_the_system() {
    for (const QString& tag : QLocale::system().uiLanguages())
        for (const char* code : {"en", "de", "ko"})
            if (tag.section('-', 0, 0) == code)
                return code;
    return "en";
}

} // namespace

Languages::Languages() : mirrored_(QGuiApplication::isRightToLeft()) {}

Languages::~Languages() { forget(); }

void Languages::forget() {
    for (const auto& translator : translators_)
        QCoreApplication::removeTranslator(translator.get());
    translators_.clear();
}

void Languages::use(const QString& wanted) {
    const QString code = wanted.isEmpty() ? of_the_system() : wanted;
    if (code == current_)
        return;
    forget();
    const auto install = [&](const QString& name, const QString& folder) {
        auto translator = std::make_unique<QTranslator>();
        if (translator->load(name, folder)) {
            QCoreApplication::installTranslator(translator.get());
            translators_.push_back(std::move(translator));
        }
    };
    install("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)); // the words of Qt itself
    install("touchphoto_en", ":/translations"); // plural forms, and what is not translated yet
    if (code != "en")
        install("touchphoto_" + code, ":/translations");
    current_ = code;
    const QLocale system = QLocale::system();
    const QLocale locale = system.name().startsWith(code) ? system : QLocale(code);
    QLocale::setDefault(locale);
    QGuiApplication::setLayoutDirection(mirrored_ ? Qt::RightToLeft : locale.textDirection());
}

} // namespace tp
