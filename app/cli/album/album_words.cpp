// SPDX-License-Identifier: Apache-2.0
#include "app/cli/album/album_words.hpp"

#include "app/cli/terminal.hpp"

#include <cstdio>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

int run_sub_verb(const char* verb, std::span<const SubVerb> verbs, const QStringList& words) {
    for (const SubVerb& one : verbs)
        if (!words.isEmpty() && words.first() == QLatin1String(one.name))
            return one.run(words.mid(1));
    const bool help = !words.isEmpty() && (words.first() == "--help" || words.first() == "-h");
    if (!help && !words.isEmpty())
        return wrong_usage(QString::fromLatin1(verb),
                           "There is no \"" + words.first().toStdString() + "\" in it.");
    std::FILE* where = help ? stdout : stderr;
    print_to(where, "touchphoto-lab %s VERB [options] …\n\n", verb);
    for (const SubVerb& one : verbs)
        print_to(where, "  %-9s %s\n", one.name, one.about);
    print_to(where, "\ntouchphoto-lab %s VERB --help says more about one.\n", verb);
    return help ? exit_done : exit_usage;
}

} // namespace tp
