// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/input_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/model_fetch.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/models/model_catalog.hpp"

#include <QDir>
#include <QFileInfo>

#include <cstdio>
#include <iostream>

namespace tp {

namespace {

KnownFile known_file(const PluggableModel& model) { return {static_cast<qint64>(model.bytes), model.sha256}; }

const char* option_of(const PluggableModel& model) {
    return model.role == PluggableModel::Role::detector ? "--detector" : "--model";
}

int list_models(const QStringList& words) {
    VerbLine line("models list", "Lists the models inside the program and those that can be plugged in.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    std::puts("Inside the program:");
    for (const EmbeddedModelFacts& model : embedded_models())
        print("  %-9s %s, %zu bytes, %s\n", model.name, model.purpose, model.bytes, model.licence);
    std::puts("\nCan be plugged in:");
    for (const PluggableModel* model : pluggable_models) {
        print("  %-9s %s for %s %s, %ju bytes, %s\n", model->name, model->description, option_of(*model),
              model->name, static_cast<std::uintmax_t>(model->bytes), model->licence);
        const auto file = installed_file(*model);
        if (file)
            print("            installed: %s\n", file->c_str());
        else if (model->inside)
            print("            inside the program; a file %s in a folder below takes its place\n",
                  model->file);
        else if (*model->address)
            print("            not installed: touchphoto-lab models fetch %s, or put a file %s into a "
                  "folder below\n",
                  model->name, model->file);
        else
            print("            not installed: put a file %s into a folder below. %s\n", model->file,
                  model->origin);
    }
    std::puts("\nLooked for in:");
    for (const std::filesystem::path& folder : model_folders())
        print("  %s\n", folder.c_str());
    return exit_done;
}

int check_models(const QStringList& words) {
    VerbLine line(
        "models check",
        "Says of each model whether it is the file that we know, and whether it loads and gives what\n"
        "the program expects. A file that we do not know is said to be so, and may be as good.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    int result = exit_done;
    const auto judge = [&](const std::string& name, const std::string& about, const std::string& problem) {
        print("%s: %s%s\n", name.c_str(), about.c_str(),
              problem.empty() ? "loads and gives what the program expects" : "cannot be used");
        std::fflush(stdout);
        if (problem.empty())
            return;
        say_problem(problem);
        result = exit_bad_input;
    };
    judge("embedded", "", FaceExtractor::create().error());
    for (const PluggableModel* model : pluggable_models) {
        const auto file = installed_file(*model);
        if (!file) {
            print("%s: %s\n", model->name, model->inside ? "inside the program" : "not installed");
            continue;
        }
        LongWork::step("checking " + std::string(model->name));
        const auto sum = sha256_of(QString::fromStdString(file->string()));
        if (!sum) {
            judge(model->name, file->string() + ", ", sum.error());
            continue;
        }
        const std::string what = *sum == model->sha256
                                     ? "the known file, "
                                     : "a file that we do not know (SHA-256 " + sum->toStdString() + "), ";
        judge(model->name, file->string() + ", " + what, problem_with_model(*model, *file));
    }
    return result;
}

/// A file's name, or an address.
QUrl address_of(const QString& text) {
    return QFileInfo::exists(text) || !text.contains("://")
               ? QUrl::fromLocalFile(QFileInfo(text).absoluteFilePath())
               : QUrl(text);
}

/// Asks on stderr, listens on stdin; silence is no.
bool agreed(const char* question) {
    std::fputs(question, stderr);
    std::fflush(stderr);
    const PersonsTurn turn;
    std::string answer;
    next_line(std::cin, answer);
    const QString word = QString::fromStdString(answer).trimmed().toLower();
    return word == "y" || word == "yes";
}

/// The model of that name, or the sentence that says which there are.
Result<const PluggableModel*> named(const std::string& name) {
    std::string names;
    for (const PluggableModel* model : pluggable_models) {
        if (name == model->name)
            return model;
        names += (names.empty() ? "" : ", ") + std::string(model->name);
    }
    for (const EmbeddedModelFacts& model : embedded_models())
        if (name == model.name)
            return Error{"The model \"" + name + "\" is inside the program; there is nothing to fetch."};
    return Error{"There is no model \"" + name + "\" to fetch. There are: " + names + "."};
}

/// What a file has to be to be taken for `model`. Where no checksum of it is known, that is a file of this
/// machine which works.
Result<KnownFile> wanted_file(const PluggableModel& model, const QUrl& address) {
    if (*model.sha256)
        return known_file(model);
    if (!address.isLocalFile())
        return Error{"Nothing would tell whether what comes from " + address.toString().toStdString() +
                     " is this model. " + model.origin};
    const QString file = address.toLocalFile();
    const auto sum = sha256_of(file);
    if (!sum)
        return Error{sum.error()};
    if (const std::string problem = problem_with_model(model, file.toStdString()); !problem.empty())
        return Error{problem};
    return KnownFile{QFileInfo(file).size(), *sum};
}

/// Asks, unless that was done, and fetches `model` from `address` to `target`.
int fetch(const PluggableModel& model, const QUrl& address, const QString& target, bool ask) {
    const auto wanted = wanted_file(model, address);
    if (!wanted)
        return refused(wanted.error());
    say(std::string(model.name) + ", " + model.description + ". " + model.origin);
    say("  from     " + address.toString().toStdString());
    say("  licence  " + std::string(model.licence));
    say("  size     " + std::to_string(wanted->bytes) + " bytes");
    say("  to       " + target.toStdString() +
        (QFileInfo::exists(target) ? ", in place of another file there" : ""));
    if (ask && !agreed("Fetch it? [y/N] "))
        return refused("Nothing was fetched.");
    LongWork::step("fetching " + std::string(model.name));
    int tenths = 0;
    const auto progress = [&](qint64 bytes) {
        const int reached = static_cast<int>(10 * bytes / wanted->bytes);
        if (reached > tenths)
            say(std::to_string(10 * reached) + " %");
        tenths = reached;
    };
    const auto done = fetch_file(address, target, *wanted, progress, LongWork::stop_asked());
    if (!done) {
        say_problem(done.error());
        return LongWork::stop_asked() ? LongWork::stop_code() : exit_bad_input;
    }
    say("Installed: " + std::string(option_of(model)) + " " + model.name + " uses it.");
    return exit_done;
}

int fetch_model(const QStringList& words) {
    VerbLine line("models fetch",
                  "Shows where a model comes from, its licence and size, asks, and installs it where its\n"
                  "checksum is right (where none is known: a file that works). The only command of "
                  "TouchPhoto that goes online.");
    line.option("yes", "Does not ask for confirmation.")
        .option("from", "Takes it from another place: a file, or an http or https address.", "address")
        .argument("NAME", "Its name in models list.", "NAME");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    const auto model = named(line.arguments().first().toStdString());
    if (!model)
        return refused(model.error());
    const PluggableModel& wanted = **model;
    const auto folders = model_folders();
    if (folders.empty())
        return refused("There is no folder for models: set TOUCHPHOTO_MODELS to one.");
    if (const auto file = installed_file(wanted)) {
        const auto sum = sha256_of(QString::fromStdString(file->string()));
        if (sum && *sum == wanted.sha256) {
            say("The model \"" + std::string(wanted.name) + "\" is already installed: " + file->string() +
                ".");
            return exit_done;
        }
    }
    const QString from = line.has("from") ? line.text("from") : QString(wanted.address);
    if (from.isEmpty())
        return refused("The model \"" + std::string(wanted.name) + "\" cannot be fetched. " + wanted.origin +
                       (*wanted.sha256 ? " Whoever has the file can use --from FILE." : ""));
    const auto target = QString::fromStdString((folders.front() / wanted.file).string());
    return fetch(wanted, address_of(from), target, !line.has("yes"));
}

} // namespace

int models_verb(const QStringList& words) {
    const QString what = words.isEmpty() ? QString() : words.first();
    if (what == QLatin1String("list"))
        return list_models(words.mid(1));
    if (what == QLatin1String("check"))
        return check_models(words.mid(1));
    if (what == QLatin1String("fetch"))
        return fetch_model(words.mid(1));
    if (what == QLatin1String("--help") || what == QLatin1String("-h")) {
        std::puts("touchphoto-lab models list\n"
                  "touchphoto-lab models check\n"
                  "touchphoto-lab models fetch NAME [--yes] [--from ADDRESS]");
        return exit_done;
    }
    return wrong_usage("models", "Say what to do with the models: list, check or fetch.");
}

} // namespace tp
