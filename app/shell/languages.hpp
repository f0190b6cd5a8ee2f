// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>
#include <QString>
#include <QTranslator>

#include <memory>
#include <vector>

namespace tp {

/// The languages that the program can speak, and the one that it speaks now.
class Languages {
public:
    Languages();
    ~Languages();

    /// Installs the texts of `wanted` ("de"; empty: the system's language, English where there is none of it) and makes
    /// it the locale of numbers and dates.
    void use(const QString& wanted);
    /// "en", "de", "ko"
    const QString& current() const { return current_; }

private:
    void forget();

    std::vector<std::unique_ptr<QTranslator>> translators_;
    QString current_;
    bool mirrored_; ///< whatever the language: Qt's option -reverse, to look at it without one that is written so
};

} // namespace tp
