// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/files/foreign_folder.hpp"

#include <QCommandLineParser>
#include <QStringList>

#include <filesystem>
#include <optional>
#include <string>

namespace tp {

/// How a verb ends, for a shell.
enum ExitCode {
    exit_done = 0,
    exit_bad_input = 1, ///< one clear sentence was written to stderr
    exit_usage = 2
};

/// One sentence to stderr, with `about` (a file's name, say) before it.
void say_problem(const std::string& sentence, const std::string& about = {});
/// The same; exit_bad_input, or what a verb ends in that was stopped.
int refused(const std::string& sentence);
/// A line of progress or news to stderr; stdout is for machines.
void say(const std::string& line);
/// The same of what begins now, which is then also what a person who waits is told.
void say_step(const std::string& line);

/// The parser of one verb: options, `--help`, and what is left as arguments.
class VerbLine {
public:
    /// `verb` as typed; `about` in a sentence or two.
    VerbLine(const QString& verb, const QString& about);

    VerbLine& option(const QString& name, const QString& about, const QString& value = {},
                     const QString& preset = {});
    /// One that names a file to be written, and with it --force.
    VerbLine& output(const QString& name, const QString& about, const QString& value);
    /// Adds --force, for an argument that names a file to be written.
    VerbLine& with_force();
    VerbLine& argument(const QString& name, const QString& about, const QString& syntax = {});

    /// Parses; where that ends the verb (help asked for, or wrong usage) the exit code to end with.
    std::optional<int> parse(const QStringList& words, int least_arguments, int most_arguments);
    QStringList arguments() const { return parser_.positionalArguments(); }
    bool has(const QString& name) const { return parser_.isSet(name); }
    QString text(const QString& name) const { return parser_.value(name); }
    /// All values of an option that may be given several times.
    QStringList texts(const QString& name) const { return parser_.values(name); }
    /// The file that an option or argument names to be written. Without --force an error where something is there that TouchPhoto
    /// did not write, or that a person mended.
    Result<std::filesystem::path> output_file(const QString& word) const;
    /// Makes the folder that an option names, where it is missing; the sentence that says why not, else
    /// empty.
    std::string make_folder(const QString& name) const;
    /// A number above zero; otherwise the sentence that says which option is wrong.
    Result<double> positive(const QString& name) const;
    /// A whole number from `least` to `most`; otherwise the sentence that says which option is wrong.
    Result<int> whole(const QString& name, int least, int most) const;

private:
    QString verb_;
    QCommandLineParser parser_;
};

/// The place that a word of the command line names, whole and without "..".
std::filesystem::path path_given(const QString& word);

/// While it lives, what a verb writes to this path goes through no link that lies beside it or in the album around it.
ForeignFolder held_around(const std::filesystem::path& output);

/// Says what is wrong with the usage, on stderr; returns exit_usage.
int wrong_usage(const QString& verb, const std::string& sentence);

} // namespace tp
