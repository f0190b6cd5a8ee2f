// SPDX-License-Identifier: Apache-2.0
#include "sentences_check.hpp"

#include "audio/sentences/sentences.hpp"
#include "marked_sentences.hpp"

#include <QCoreApplication>

namespace tp::test {

namespace {

/// A program without one: translators need it.
QCoreApplication& program() {
    static int count = 1;
    static char name[] = "sentences";
    static char* names[] = {name, nullptr};
    static QCoreApplication made(count, names);
    return made;
}

} // namespace

std::string complaint_about_sentence(std::string_view text) {
    if (QCoreApplication::instance() == nullptr)
        program();
    const std::string english(text);
    const QString plain = QString::fromStdString(english);
    if (in_persons_language(english) != plain)
        return "English is changed";
    testing::Brackets brackets;
    QCoreApplication::installTranslator(&brackets);
    const QString marked = in_persons_language(english);
    QCoreApplication::removeTranslator(&brackets);
    if (testing::without_brackets(marked) != testing::without_brackets(plain))
        return "something is lost or put elsewhere: " + marked.toStdString();
    return {};
}

} // namespace tp::test
