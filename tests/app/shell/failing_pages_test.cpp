// SPDX-License-Identifier: Apache-2.0
// Every page that keeps something, on a disk of which one call fails, reading or writing, once or from then on: the program goes on
// to its end, what it says is done is done, what is not done is said, and no photograph or recording is lost. TP_MOMENTS=100 tries as
// many calls of each page, TP_SEED=2 others.
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/figures/study/study_report.hpp"
#include "app/pages/lab/lab_replay.hpp"
#include "checked_album.hpp"
#include "core/files/whole_file.hpp"
#include "core/study_folder/study_folder.hpp"
#include "core/svg/contour_sheet.hpp"
#include "faulty_run.hpp"
#include "places.hpp"

#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Deed {
    QString name;
    QStringList said;
    bool claims(const char* words) const {
        return !said.filter(QRegularExpression(QString::fromUtf8(words))).isEmpty();
    }
};

/// One time that a person was at a page.
struct Visit {
    std::unique_ptr<QTemporaryDir> place = std::make_unique<QTemporaryDir>();
    std::vector<Deed> deeds;
    QString taken; ///< the photograph that was taken
    bool ended = false;
    long calls = 0;

    Visit(const QString& page, const QByteArray& fault) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("TMPDIR", place->path());
        environment.insert("TP_FAULT_WAITS", "1");
        environment.insert("TP_FAULT_READS", "all");
        const fs::path count = place->filePath("calls").toStdString();
        const QByteArray told =
            test::faulty_run(test::in_build("tests/app/shell/failing_pages_worker"), {page},
                             place->path().toStdString(), fault, count, environment);
        for (const QString& line : QString::fromUtf8(told).split('\n', Qt::SkipEmptyParts)) {
            const QStringList words = line.split('\t');
            if (words[0] == "taken")
                taken = words[1];
            else if (words[0] == "ended")
                ended = true;
            else
                deeds.push_back({words[0], words.mid(1)});
        }
        calls = test::calls_in(count);
    }
    fs::path file(const char* name) const {
        for (const auto& entry : fs::directory_iterator(place->path().toStdString()))
            if (fs::exists(entry.path() / "Family"))
                return entry.path() / name;
        return {};
    }
    fs::path photo() const { return file("Family/anna_smiling.jpg"); }
};

/// Empty where it is not there.
std::string bytes_of(const fs::path& file) {
    const auto bytes = read_whole(file, 100'000'000);
    return bytes ? *bytes : std::string();
}

bool lies_below(const fs::path& folder, const std::string& bytes) {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.file_size() == bytes.size() && bytes_of(entry.path()) == bytes)
            return true;
    return false;
}

std::string sample(const std::string& name) {
    return bytes_of(test::in_source(("resources/samples/" + name).c_str()));
}

bool has_recording_of(const Visit& visit, double least_s) {
    const auto sounds = test::sounds_in(visit.file("Family"));
    return std::ranges::any_of(
        sounds, [&](const fs::path& sound) { return about_recording(sound)->seconds() >= least_s; });
}

template <typename Holds>
bool of_record(const fs::path& photo, Holds holds) {
    const auto record = read_record(photo);
    return record && holds(*record);
}

std::optional<fs::path> only_file(const fs::path& folder, const char* ending) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.path().extension() == ending)
            return entry.path();
    return std::nullopt;
}

std::size_t trials_kept(const Visit& visit) {
    const auto study = read_study(visit.file("TouchPhoto studies/shapes"));
    return study ? study->records.size() : 0;
}

/// What a deed does, by what it says then, and how that is seen on the disk.
struct Effect {
    const char* claim;
    std::function<bool(const Visit&)> holds;
};

const std::map<QString, Effect> effects{
    {"record",
     {"^Recorded: 3 seconds. Saved.", [](const Visit& visit) { return has_recording_of(visit, 2.9); }}},
    {"label",
     {"Saved:",
      [](const Visit& visit) {
          return std::ranges::any_of(test::sounds_in(visit.file("Family")), [](const fs::path& sound) {
              return about_recording(sound)->notes.label.person == "Otto";
          });
      }}},
    {"describe",
     {"The description is saved.",
      [](const Visit& visit) {
          return of_record(visit.photo(), [](const PhotoRecord& record) {
              return std::ranges::any_of(record.description,
                                         [](const auto& text) { return text.second == "By the lake"; });
          });
      }}},
    {"name",
     {"Saved: Otto",
      [](const Visit& visit) {
          return of_record(visit.photo(), [](const PhotoRecord& record) {
              return std::ranges::any_of(record.faces,
                                         [](const FaceRegion& face) { return face.name == "Otto"; });
          });
      }}},
    {"import",
     {"^1 photograph.s. imported",
      [](const Visit& visit) { return lies_below(visit.file("Family"), sample("clara_sad.jpg")); }}},
    {"undo that", {"Undone", [](const Visit& visit) { return fs::exists(visit.photo()); }}},
    {"save",
     {"The contours are saved.",
      [](const Visit& visit) { return read_sheet(visit.photo().string() + ".contours.svg").ok(); }}},
    {"take",
     {"", [](const Visit& visit) { return bytes_of(visit.taken.toStdString()).ends_with("\xFF\xD9"); }}},
    {"memo",
     {"Saved.",
      [](const Visit& visit) {
          return of_record(visit.taken.toStdString(),
                           [](const PhotoRecord& record) { return record.tags.size() == 1; });
      }}},
    {"store",
     {"The sheet is saved as",
      [](const Visit& visit) {
          for (const auto& entry : fs::directory_iterator(visit.file("Documents")))
              if (entry.path().extension() == ".pdf" &&
                  bytes_of(entry.path()).find("%%EOF") != std::string::npos)
                  return true;
          return false;
      }}},
    {"measure",
     {"^Recorded in",
      [](const Visit& visit) {
          const auto recording = only_file(visit.file("Documents/Lab"), ".touch");
          return recording && read_replay(*recording).ok();
      }}},
    {"table",
     {"row.s. (are|is) in",
      [](const Visit& visit) {
          const auto table = only_file(visit.file("Documents/Lab"), ".csv");
          return table && std::ranges::count(bytes_of(*table), '\n') > 1;
      }}},
    {"first trial", {"Trial 2 of 4", [](const Visit& visit) { return trials_kept(visit) >= 1; }}},
    {"second trial", {"done 2 of 4", [](const Visit& visit) { return trials_kept(visit) >= 2; }}},
    {"report",
     {"The report is in",
      [](const Visit& visit) {
          const fs::path page = visit.file("TouchPhoto studies/shapes report") / study_page_file;
          return bytes_of(page).find("</html>") != std::string::npos;
      }}},
    {"limit", {"", [](const Visit& visit) {
                   return bytes_of(visit.file("preferences.json")).find("0.7") != std::string::npos;
               }}}};

/// Empty, or what is wrong after a visit; `good` is one to the same page on a disk without a fault.
QString wrong_with(const Visit& visit, const Visit& good) {
    if (!visit.ended)
        return visit.deeds.empty() ? "It did not begin."
                                   : "It ended after \"" + visit.deeds.back().name + "\".";
    QSet<QString> usual, new_words;
    for (const Deed& deed : good.deeds)
        usual.unite({deed.said.begin(), deed.said.end()});
    AlbumKeeper keeper(visit.file("Family"));
    for (const TrashEntry& entry :
         keeper.trash().entries()) // what was deleted and not undone can still be had
        keeper.restore(entry.id);
    for (const Deed& deed : visit.deeds) {
        new_words.unite(QSet<QString>(deed.said.begin(), deed.said.end()).subtract(usual));
        const auto effect = effects.find(deed.name);
        if (effect == effects.end())
            continue;
        const bool held = effect->second.holds(visit);
        const QByteArray claim = effect->second.claim;
        if (!held && new_words.isEmpty())
            return "\"" + deed.name + "\" was not done, and nothing was said of it: " + deed.said.join(" | ");
        if (!held && !claim.isEmpty() && deed.claims(claim))
            return "\"" + deed.name + "\" was said to be done: " + deed.said.join(" | ");
    }
    for (const char* name : {"anna_smiling.jpg", "ben_and_clara.jpg", "ben_smiling.jpg"})
        if (!lies_below(visit.file("Family"), sample(name)))
            return QString("%1 is lost.").arg(name);
    if (!has_recording_of(visit, 1.9))
        return "The recording that was there is lost.";
    test::checked(visit.file("Family"), true);
    for (const Finding& left : test::checked(visit.file("Family"), false).findings)
        if (left.kind != Finding::Kind::unfinished_import) // a person decides
            return "Left after mending: " + QString::fromStdString(left.sentence);
    return {};
}

} // namespace

class FailingPagesTest : public QObject {
    Q_OBJECT
private slots:
    void nothing_is_lost_and_all_is_said_data() {
        QTest::addColumn<int>("calls");
        QTest::newRow("care") << 6;
        for (const char* page : {"mend", "capture", "browse", "study"})
            QTest::newRow(page) << 3;
        for (const char* page : {"print", "settings", "lab"})
            QTest::newRow(page) << 2;
    }
    void nothing_is_lost_and_all_is_said() {
        QFETCH(int, calls);
        const QString page = QTest::currentDataTag();
        const Visit good(page, "none@1");
        QCOMPARE(wrong_with(good, good), QString());
        for (const Deed& deed : good.deeds)
            if (const auto effect = effects.find(deed.name); effect != effects.end()) {
                QVERIFY2(effect->second.holds(good), qPrintable(deed.name + ": " + deed.said.join(" | ")));
                QVERIFY2(deed.claims(effect->second.claim) || *effect->second.claim == 0,
                         qPrintable(deed.name + ": " + deed.said.join(" | ")));
            }
        const auto seed = static_cast<std::uint32_t>(20261128 + qEnvironmentVariableIntValue("TP_SEED"));
        QStringList all_wrong;
        for (const QByteArray& fault : test::random_faults(calls, good.calls, {"EIO-once@", "EIO@"}, seed))
            if (const QString wrong = wrong_with(Visit(page, fault), good); !wrong.isEmpty())
                all_wrong << QString::fromLatin1(fault) + ": " + wrong;
        QVERIFY2(all_wrong.isEmpty(), qPrintable(all_wrong.join('\n')));
    }
};

QTEST_GUILESS_MAIN(FailingPagesTest)
#include "failing_pages_test.moc"
