// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/models/model_catalog.hpp"

#include <array>
#include <cstdio>
#include <string>

namespace tp {

namespace {

int list_models(const QStringList& words) {
    VerbLine line("models list", "Lists the nets inside the program: name, purpose, bytes, licence.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    for (const EmbeddedModelFacts& model : embedded_models())
        print("%-12s %s, %zu bytes, %s\n", model.name, model.purpose, model.bytes, model.licence);
    return exit_done;
}

/// What `--detector` and `--model` of `faces` choose, by the name that is chosen.
struct ChosenNets {
    const char* name;
    ExtractorChoice nets;
};

/// Why they cannot be used, in a sentence; empty: they can.
std::string problem_with(const ExtractorChoice& nets) {
    auto extractor = FaceExtractor::create(nets);
    return extractor ? extractor->problem() : extractor.error();
}

int check_models(const QStringList& words) {
    VerbLine line(
        "models check",
        "Says of the nets that faces can choose whether they load and give what the program expects.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    const std::array<ChosenNets, 3> choices{
        {{"embedded", {}}, {"yunet", {"yunet", "embedded"}}, {"mesh", {"embedded", "mesh"}}}};
    int result = exit_done;
    for (const ChosenNets& choice : choices) {
        const std::string problem = problem_with(choice.nets);
        print("%s: %s\n", choice.name,
              problem.empty() ? "loads and gives what the program expects" : "cannot be used");
        std::fflush(stdout);
        if (problem.empty())
            continue;
        say_problem(problem);
        result = exit_bad_input;
    }
    return result;
}

} // namespace

int models_verb(const QStringList& words) {
    const QString what = words.isEmpty() ? QString() : words.first();
    if (what == QLatin1String("list"))
        return list_models(words.mid(1));
    if (what == QLatin1String("check"))
        return check_models(words.mid(1));
    if (what == QLatin1String("--help") || what == QLatin1String("-h")) {
        std::puts("touchphoto-lab models list\n"
                  "touchphoto-lab models check");
        return exit_done;
    }
    return wrong_usage("models", "Say what to do with the models: list or check.");
}

} // namespace tp
