// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <QFile>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace tp {

void say_problem(const std::string& sentence, const std::string& about) {
    say(about.empty() ? sentence : readable(about) + ": " + sentence);
}

int refused(const std::string& sentence) {
    say_problem(sentence);
    return LongWork::stop_asked() ? LongWork::stop_code() : exit_bad_input;
}

void say(const std::string& line) {
    print_to(stderr, "%s\n", line.c_str());
    LongWork::said();
}

void say_step(const std::string& line) {
    say(line);
    LongWork::step(line);
}

int wrong_usage(const QString& verb, const std::string& sentence) {
    say(sentence + " See touchphoto-lab " + verb.toStdString() + " --help.");
    return exit_usage;
}

VerbLine::VerbLine(const QString& verb, const QString& about) : verb_(verb) {
    parser_.setApplicationDescription(about);
    parser_.addOption({{QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Shows this help.")});
}

VerbLine& VerbLine::option(const QString& name, const QString& about, const QString& value,
                           const QString& preset) {
    parser_.addOption({name, about, value, preset});
    return *this;
}

VerbLine& VerbLine::argument(const QString& name, const QString& about, const QString& syntax) {
    parser_.addPositionalArgument(name, about, syntax);
    return *this;
}

std::optional<int> VerbLine::parse(const QStringList& words, int least, int most) {
    const bool understood = parser_.parse(QStringList{QStringLiteral("touchphoto-lab ") + verb_} + words);
    if (understood && has(QStringLiteral("help"))) {
        // QCommandLineParser names the program by its file; the verb belongs behind it.
        QString text = parser_.helpText();
        text.replace(
            0, text.indexOf(QLatin1Char('\n')),
            QStringLiteral("Usage: touchphoto-lab %1 [options] %2")
                .arg(verb_, text.section(QLatin1Char('\n'), 0, 0).section(QStringLiteral("[options] "), 1)));
        std::fputs(qPrintable(text), stdout);
        return exit_done;
    }
    if (!understood)
        return wrong_usage(verb_, parser_.errorText().toStdString());
    const auto count = static_cast<int>(arguments().size());
    if (count < least)
        return wrong_usage(verb_, "An argument is missing.");
    if (count > most)
        return wrong_usage(verb_,
                           "Too many arguments, from \"" + arguments().at(most).toStdString() + "\" on.");
    return std::nullopt;
}

std::string VerbLine::make_folder(const QString& name) const {
    const std::filesystem::path folder(QFile::encodeName(text(name)).toStdString());
    const ForeignFolder held = held_around(text(name) + "/name");
    const std::string reason = tp::make_folder(folder);
    return reason.empty() ? reason : "The folder " + quoted(folder) + " cannot be created: " + reason;
}

ForeignFolder held_around(const QString& output) {
    std::error_code error;
    const std::filesystem::path place(QFile::encodeName(output).toStdString());
    return ForeignFolder(album_around(std::filesystem::absolute(place, error).lexically_normal()));
}

Result<double> VerbLine::positive(const QString& name) const {
    bool is_number = false;
    const double value = text(name).toDouble(&is_number);
    if (!is_number || !std::isfinite(value) || !(value > 0.0))
        return Error{"--" + name.toStdString() + " needs a number above zero, not \"" +
                     text(name).toStdString() + "\"."};
    return value;
}

Result<int> VerbLine::whole(const QString& name, int least, int most) const {
    bool is_number = false;
    const int value = text(name).toInt(&is_number);
    if (!is_number || value < least || value > most)
        return Error{"--" + name.toStdString() + " needs a whole number from " + std::to_string(least) +
                     " to " + std::to_string(most) + ", not \"" + text(name).toStdString() + "\"."};
    return value;
}

} // namespace tp
