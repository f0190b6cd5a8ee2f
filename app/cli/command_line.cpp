// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_name.hpp"
#include "core/files/file_words.hpp"
#include "core/files/open_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// What stands at the beginning or the end of each kind of file that a verb writes: contours, tables, pictures, sheets, a packed
/// study. "TouchPhoto" alone stands in photographs too that were taken with it.
constexpr std::array<std::string_view, 6> marks{"TouchPhoto contours",
                                                "\"made_by\": \"TouchPhoto\"",
                                                "TouchPhoto-drawing",
                                                "data-name=\"orientation mark\"",
                                                {"T\0o\0u\0c\0h\0P\0h\0o\0t\0o", 19},
                                                "/sittings.csv"};

/// The photograph whose mended contours a file holds, where it is there.
std::optional<fs::path> photo_of_contours(const fs::path& file) {
    constexpr std::string_view end = ".contours.svg";
    const std::string name = file.filename().string();
    if (!name.ends_with(end) || !name_taken(file))
        return std::nullopt;
    const fs::path photo = file.parent_path() / name.substr(0, name.size() - end.size());
    return has_photo_name(photo) && photo_there(photo) ? std::optional(photo) : std::nullopt;
}

/// Whether nothing would be lost by writing there: it is no file, is empty or one of ours.
bool is_free_or_ours(const fs::path& file) {
    constexpr std::uint64_t looked_at = 64 << 10; // bytes at each end
    OpenFile opened(file, {});
    const auto facts = opened.ok() ? opened.facts() : std::nullopt;
    if (!facts)
        return is_gone(file);
    if (facts->kind != FileFacts::Kind::file || facts->bytes == 0)
        return true; // what cannot be written to either says so itself
    if (file.extension() == ".touchphoto")
        return true;
    std::string bytes(looked_at, '\0');
    for (const std::uint64_t at : {std::uint64_t{0}, facts->bytes - std::min(facts->bytes, looked_at)}) {
        const std::string_view read(bytes.data(), opened.read_at(at, bytes));
        if (std::ranges::any_of(
                marks, [&](std::string_view mark) { return read.find(mark) != std::string_view::npos; }))
            return true;
    }
    return false;
}

} // namespace

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

VerbLine& VerbLine::output(const QString& name, const QString& about, const QString& value) {
    return option(name, about, value).with_force();
}

VerbLine& VerbLine::with_force() {
    return option(QStringLiteral("force"),
                  QStringLiteral("Writes over a file that TouchPhoto did not write."));
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

Result<fs::path> VerbLine::output_file(const QString& word) const {
    fs::path file = path_given(word);
    if (has(QStringLiteral("force")))
        return file;
    if (const auto photo = photo_of_contours(file))
        return Error{quoted(file) + " holds what a person mended of " + quoted(photo->filename()) +
                     ". Name another file, or write over it with --force."};
    if (!is_free_or_ours(file))
        return Error{
            quoted(file) +
            " is there already, and TouchPhoto did not write it. Name another file, or write over it "
            "with --force."};
    return file;
}

std::string VerbLine::make_folder(const QString& name) const {
    const fs::path folder = path_given(text(name));
    const ForeignFolder held = held_around(folder / "name");
    const std::string reason = tp::make_folder(folder);
    return reason.empty() ? reason : "The folder " + quoted(folder) + " cannot be created: " + reason;
}

fs::path path_given(const QString& word) {
    std::error_code error;
    const fs::path whole = fs::absolute(path_named(word.toStdString()), error).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

ForeignFolder held_around(const fs::path& output) { return ForeignFolder(album_around(output)); }

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
