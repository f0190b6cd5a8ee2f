// SPDX-License-Identifier: Apache-2.0
#include "app/cli/verbs.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/version/program_version.hpp"

#include <array>
#include <cstdio>

namespace tp {

namespace {

struct Verb {
    const char* name;
    const char* about;
    int (*run)(const QStringList& words);
};

constexpr std::array<Verb, 17> verbs{{
    {"album", "photographs, people and recordings: scan, search, import, export, check", album_verb},
    {"faces", "find the faces of photographs and their contours", faces_verb},
    {"models", "list and check the nets inside the program", models_verb},
    {"scene", "write the scene that the Explore page would render for a photograph", scene_verb},
    {"tactile", "write a photograph's faces as a sheet for swell paper or an embosser", tactile_verb},
    {"correction", "say what the mended contours beside a photograph change", correction_verb},
    {"expressions", "say which expressions the contours of faces tell a finger", expressions_verb},
    {"force", "answer the force at places read from stdin", force_verb},
    {"field", "draw the force field of a scene", field_verb},
    {"friction", "write the friction of a scene as a picture for electrostatic displays", friction_verb},
    {"devices", "list, test and home force devices, record and replay sessions", devices_verb},
    {"servo", "measure how punctual the servo loop is on this machine", servo_verb},
    {"stability", "measure how stable the guidance is", stability_verb},
    {"bench", "measure how fast the nearest contour is found, beside other methods", bench_verb},
    {"trace", "let a simulated finger explore a scene in simulated time", trace_verb},
    {"aim", "let simulated hands aim a camera by what they hear, in simulated time", aim_verb},
    {"study", "plan experiments with people, and say what they have shown", study_verb},
}};

void list_verbs(FILE* where) {
    std::fputs("touchphoto-lab VERB [options] …\n\n", where);
    for (const Verb& verb : verbs)
        print_to(where, "  %-11s %s\n", verb.name, verb.about);
    std::fputs(
        "\ntouchphoto-lab VERB --help says more about one. Results go to stdout, everything else to stderr.\n"
        "What takes long says on stderr how far it is. Exit codes: 0 done, 1 bad input, 2 wrong usage,\n"
        "130 stopped by Ctrl-C, 143 by SIGTERM.\n",
        where);
}

} // namespace

int run_lab(const QStringList& words) {
    if (words.isEmpty()) {
        list_verbs(stderr);
        return exit_usage;
    }
    const QString first = words.first();
    if (first == "--help" || first == "-h" || first == "help") {
        list_verbs(stdout);
        return exit_done;
    }
    if (first == "--version") {
        std::fputs(program_version("touchphoto-lab").c_str(), stdout);
        return exit_done;
    }
    for (const Verb& verb : verbs)
        if (first == verb.name) {
            const LongWork work(verb.name);
            return verb.run(words.mid(1));
        }
    say_problem("There is no verb \"" + first.toStdString() + "\". touchphoto-lab --help lists them.");
    return exit_usage;
}

} // namespace tp
