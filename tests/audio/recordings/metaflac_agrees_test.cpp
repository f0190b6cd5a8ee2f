// SPDX-License-Identifier: Apache-2.0
// Two readers, one FLAC file: the comments that we read are those that metaflac exports.
#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/flac_head.hpp"
#include "places.hpp"
#include "sounds.hpp"
#include "test_program.hpp"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <optional>
#include <random>

namespace metaflac_agrees_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

/// As metaflac exports them, a line each; texts of several lines stay so.
std::string exported(const VorbisComments& comments) {
    std::string text;
    for (const auto& field : comments.fields)
        text.append(field.name).append("=").append(field.value).append("\n");
    return text;
}

/// None where metaflac refuses the file.
std::optional<std::string> exported_by_metaflac(const fs::path& file) {
    QProcess process;
    process.start("metaflac", {"--no-utf8-convert", "--export-tags-to=-", QString::fromStdString(file)});
    if (!process.waitForFinished(60'000) || process.exitStatus() != QProcess::NormalExit ||
        process.exitCode() != 0)
        return std::nullopt;
    return process.readAllStandardOutput().toStdString();
}

} // namespace

class MetaflacAgreesTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path path(const char* name) const { return fs::path(dir_.path().toStdString()) / name; }

    static std::string ours(const fs::path& file) {
        const auto bytes = FileBytes::open(file);
        const auto head = bytes ? flac_head(**bytes) : Result<FlacHead>(Error{bytes.error()});
        return head ? exported(head->comments) : "refused: " + head.error();
    }

private slots:
    void initTestCase() {
        if (!has_program("metaflac") || !has_program("flac"))
            QSKIP("metaflac is missing (package flac)");
    }

    void files_of_the_corpus() {
        int compared = 0;
        for (const auto& file : fs::directory_iterator(in_source("tests/audio/recordings/flac_corpus"))) {
            const auto theirs = exported_by_metaflac(file.path());
            const auto bytes = FileBytes::open(file.path());
            if (!theirs || !bytes || !flac_head(**bytes))
                continue;
            QVERIFY2(ours(file.path()) == *theirs, file.path().c_str());
            ++compared;
        }
        QVERIFY2(compared >= 5, qPrintable(QString::number(compared)));
    }

    void files_of_ffmpeg() {
        if (!has_program("ffmpeg"))
            QSKIP("ffmpeg is missing (package ffmpeg)");
        const QString name = QString::fromStdString(path("by_ffmpeg.flac"));
        const Ran made = run("ffmpeg", {"-loglevel", "error", "-y", "-f", "lavfi", "-i", "sine=d=0.1",
                                        "-metadata", "title=Am See", "-metadata", "ARTIST=Opa = Jörg",
                                        "-metadata", "comment=two\nlines", name});
        QVERIFY2(made.status == 0, made.output.c_str());
        const std::string text = ours(path("by_ffmpeg.flac"));
        QCOMPARE(text, exported_by_metaflac(path("by_ffmpeg.flac")).value_or("refused"));
        QVERIFY2(text.find("ARTIST=Opa = Jörg\n") != std::string::npos, text.c_str());
    }

    void random_comments() {
        const fs::path made = path("random.flac");
        const QString name = QString::fromStdString(made);
        QVERIFY(run("ffmpeg", {"-loglevel", "error", "-y", "-f", "lavfi", "-i", "sine=d=0.1", name}).status ==
                0);
        std::mt19937 random(20260501);
        const std::vector<std::string> texts{
            "", "a", "=", "=b=", "Jörg שלום", "👵🏽", "two\nlines", std::string(70'000, 'x')};
        const std::vector<std::string> names{"KIND", "person", "A B", "}", "TRANSCRIPT", "CHAPTER001NAME"};
        for (int i = 0; i < 20; ++i) {
            QStringList arguments{"--no-utf8-convert", "--remove-all-tags"};
            for (std::size_t k = random() % 12; k > 0; --k)
                arguments << QString::fromStdString("--set-tag=" + names[random() % names.size()] + "=" +
                                                    texts[random() % texts.size()]);
            const Ran ran = run("metaflac", arguments << "--add-padding=100" << name);
            QVERIFY2(ran.status == 0, ran.output.c_str());
            QCOMPARE(ours(made), exported_by_metaflac(made).value_or("refused"));
        }
    }

    void what_we_write_is_what_metaflac_reads() {
        const fs::path made = path("base.flac"), written = path("written.flac");
        QVERIFY(run("ffmpeg", {"-loglevel", "error", "-y", "-f", "lavfi", "-i", "sine=d=0.1", "-metadata",
                               "title=gone", QString::fromStdString(made)})
                    .status == 0);
        VorbisComments comments;
        comments.vendor = "somebody";
        comments.fields = {{"KIND", "story"},
                           {"PERSON", "Anna"},
                           {"EMPTY", ""},
                           {"TRANSCRIPT", "a\nb = c"},
                           {"PERSON", "Ben"}};
        const auto bytes = FileBytes::open(made);
        std::string all;
        QCOMPARE(write_with_comments(**bytes, *flac_head(**bytes), comments,
                                     [&](std::string_view more) {
                                         all += more;
                                         return std::string();
                                     }),
                 std::string());
        write_bytes(written, all);
        QCOMPARE(exported_by_metaflac(written).value_or("refused"), exported(comments));
        QCOMPARE(run("flac", {"-t", "-s", QString::fromStdString(written)}).status, 0);
    }
};

} // namespace metaflac_agrees_test

TP_TEST(metaflac_agrees_test, MetaflacAgreesTest, event_loop)
#include "metaflac_agrees_test.moc"
