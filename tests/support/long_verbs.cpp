// SPDX-License-Identifier: Apache-2.0
#include "long_verbs.hpp"

#include "long_inputs.hpp"
#include "places.hpp"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

namespace tp::test {

LongWorkInputs::LongWorkInputs() {
    if (!folder_.isValid())
        qFatal("there is no place for the inputs");
    write_long_inputs(folder_.path());
    files_ = names(QDir::Files);
    folders_ = names(QDir::Dirs);
    const char* const index = "cache/.*";
    add("field", "field --scene @tangle.svg --out @field.png");
    add("friction", "friction --scene @tangle.svg --out @friction.png");
    add("force", "force --scene @tangle.svg");
    add("trace", "trace --scene @tangle.svg --out @trace");
    add("devices record --scene", "devices record @tangle.rec --scene @tangle.svg");
    add("devices record", "devices record @long.rec --seconds 1000", "long.rec");
    add("devices replay --scene", "devices replay @short.rec --scene @tangle.svg");
    add("devices test", "devices test simulated --seconds 1000");
    add("servo", "servo --seconds 1000");
    add("aim", "aim simulate --people 100000 --out @aim");
    add("stability", "stability --out @stability");
    add("bench guidance", "bench guidance --json @bench.json");
    add("bench accuracy", "bench accuracy --out @accuracy");
    add("bench touch", "bench touch --people 10000 --out @touch");
    add("bench faces", "bench faces --photos @portraits --truth @truth.json --out @faces");
    add("bench faces --harder", "bench faces --photos @portraits --truth @truth.json --out @harder --harder");
    add("bench faces --identity", "bench faces --identity @portraits --out @identity");
    add("bench faces --wild", "bench faces --wild @album --out @wild",
        "wild/wild(_summary)?[.](csv|png|svg)");
    add("scene", "scene @large.jpg --out @scene.svg");
    add("tactile", "tactile @large.jpg @tactile.pdf");
    add("correction", "correction @large.jpg --out @correction.png");
    add("expressions", "expressions @large.jpg --out @expressions");
    add("faces", "faces @large.jpg --json --svg @svg --overlay @overlay");
    add("album scan", "album scan @album --cache @cache/scan", index);
    add("album rebuild", "album rebuild @album --cache @cache/rebuild", index);
    add("album list", "album list @album --cache @cache/list", index);
    add("album search", "album search @album Anna --cache @cache/search", index);
    add("album show", "album show @large.jpg");
    add("album person list", "album person list @album --cache @cache/people", index);
    add("album person rename", "album person rename @album Anna Tom --cache @cache/rename", index);
    add("album person record", "album person record @empty Anna --from @long.wav");
    add("album tag add", "album tag add @one.jpg --from @long.wav");
    const QString recording = QDir(path("spoken/one.jpg.tags")).entryList(QDir::Files).value(0);
    add("album tag trim", "album tag trim @spoken/one.jpg " + recording + " --begin 1 --end 20000");
    const QString large = QDir(path("labelled/one.jpg.tags")).entryList(QDir::Files).value(0);
    add("album tag label", "album tag label @labelled/one.jpg " + large + " --kind story");
    add("album trash list", "album trash list @thrown_away");
    add("album trash empty", "album trash empty @thrown_away --yes");
    add("album check", "album check @album");
    add("album export", "album export @heavy --to @all.touchphoto");
    add("album import", "album import @empty @album --cache @cache/import",
        "cache/.*|empty/[0-9]+[.]jpg|empty/[.]touchphoto/import/[^/]+");
    add("study simulate", "study simulate tracking --participants 1000 --out @simulated",
        "simulated/(README[.]txt|study[.]txt|protocol[.]study|sittings[.]csv|participant-[0-9]+[.]csv|"
        "paths/participant-[0-9]+-trial-[0-9]+[.]csv[.]gz)");
    add("study check", "study check @study");
    add("study report", "study report @study --out @report", "report/[a-z_]+[.](csv|png|svg|html)");
    add("study export", "study export @study --out @study.zip");
}

void LongWorkInputs::add(const char* name, const QString& words, const char* leaves) {
    QStringList list = words.split(' ');
    for (QString& word : list)
        if (word.startsWith('@'))
            word = path(word.mid(1));
    verbs_.push_back({name, list, leaves});
}

void LongWorkInputs::start(QProcess& process, const LongVerb& verb) const {
    process.setReadChannel(QProcess::StandardError);
    process.start(tp::test::in_build("bin/touchphoto-lab"), verb.words);
}

std::set<QString> LongWorkInputs::names(QDir::Filters kind) const {
    std::set<QString> found;
    for (QDirIterator all(folder_.path(), kind | QDir::Hidden | QDir::NoDotAndDotDot,
                          QDirIterator::Subdirectories);
         all.hasNext();)
        found.insert(QDir(folder_.path()).relativeFilePath(all.next()));
    return found;
}

std::set<QString> LongWorkInputs::left() const {
    std::set<QString> found = names(QDir::Files);
    for (const QString& file : files_)
        found.erase(file);
    return found;
}

void LongWorkInputs::remove_left() const {
    for (const QString& file : left())
        QFile::remove(path(file));
    const std::set<QString> folders = names(QDir::Dirs);
    for (auto folder = folders.rbegin(); folder != folders.rend();
         ++folder) // those within before those around them
        if (!folders_.contains(*folder))
            QDir().rmdir(path(*folder));
}

std::set<QString> long_verbs_of_manual() {
    QFile file(in_source("app/cli/VERBS.md"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("the manual cannot be read");
    const QString manual = QString::fromUtf8(file.readAll());
    const qsizetype begin = manual.indexOf(QStringLiteral("| what takes long |"));
    const QString table = manual.mid(begin, manual.indexOf(QStringLiteral("\n\n"), begin) - begin);
    static const QRegularExpression in_code(QStringLiteral("`([^`]+)`"));
    std::set<QString> verbs;
    for (const QString& row : table.split('\n').mid(2)) {
        const QString cell = row.section(QStringLiteral(" | "), 1, 1).remove('\\');
        for (auto found = in_code.globalMatch(cell); found.hasNext();) {
            const QStringList words = found.next().captured(1).split(' ');
            QStringList names{QString()};
            for (const QString& word : words) {
                QStringList longer;
                for (const QString& name : names)
                    for (const QString& choice : word.split('|'))
                        longer << (name.isEmpty() ? choice : name + ' ' + choice);
                names = longer;
            }
            verbs.insert(names.begin(), names.end());
        }
    }
    return verbs;
}

} // namespace tp::test
