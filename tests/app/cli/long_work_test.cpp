// SPDX-License-Identifier: Apache-2.0
// Every verb that can take more than two seconds, at work on something large: it says how far it is, and
// Ctrl-C ends it with nothing half-written.
#include "lab_process.hpp"
#include "long_verbs.hpp"

#include <QDataStream>
#include <QDir>
#include <QRegularExpression>
#include <QStringList>
#include <QTest>

#include <algorithm>
#include <csignal>
#include <iterator>
#include <optional>
#include <random>
#include <set>

using tp::test::LongVerb;
using tp::test::LongWorkInputs;

namespace {

/// An answer takes a fraction of a second (tests/bench/verbs); so long is waited for it, however busy the machine is.
constexpr int longest_answer_ms = 30'000;
constexpr int longest_silence_ms = 120'000;

QByteArray list_of(const std::set<QString>& names) {
    return QStringList(names.begin(), names.end()).join(", ").toUtf8();
}

/// WAV, 8 kHz, 16 bit, mono: nothing that is packed or unpacked at once.
QByteArray a_noise(int frames) {
    QByteArray samples(2 * frames, '\0');
    std::minstd_rand random(1);
    for (char& byte : samples)
        byte = static_cast<char>(random() >> 9);
    QByteArray wav;
    QDataStream out(&wav, QIODevice::WriteOnly);
    out.setByteOrder(QDataStream::LittleEndian);
    const auto bytes = static_cast<quint32>(samples.size());
    out.writeRawData("RIFF", 4);
    out << quint32{36 + bytes};
    out.writeRawData("WAVEfmt ", 8);
    out << quint32{16} << quint16{1} << quint16{1} << quint32{8000} << quint32{16000} << quint16{2}
        << quint16{16};
    out.writeRawData("data", 4);
    out << bytes;
    return wav + samples;
}

} // namespace

class LongWorkTest : public QObject {
    Q_OBJECT
    std::optional<LongWorkInputs> inputs_;

private slots:
    void initTestCase() { inputs_.emplace(); }

    void the_manual_names_the_verbs_that_are_stopped_here() {
        std::set<QString> here{"devices tick"}; // which needs an output for a bare finger, plugged in
        for (const LongVerb& verb : inputs_->verbs())
            here.insert(verb.name);
        const std::set<QString> named = tp::test::long_verbs_of_manual();
        std::set<QString> differing;
        std::set_symmetric_difference(here.begin(), here.end(), named.begin(), named.end(),
                                      std::inserter(differing, differing.end()));
        QVERIFY2(differing.empty(), list_of(differing).constData());
    }

    void ctrl_c_ends_it_with_nothing_half_written_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < static_cast<int>(inputs_->verbs().size()); ++i)
            QTest::newRow(qPrintable(inputs_->verbs()[static_cast<std::size_t>(i)].name)) << i;
    }

    void ctrl_c_ends_it_with_nothing_half_written() {
        QFETCH(int, index);
        const LongVerb& verb = inputs_->verbs()[static_cast<std::size_t>(index)];
        const std::set<QString> left_before = inputs_->left();
        QProcess process;
        inputs_->start(process, verb);
        QByteArray told;
        while (!told.contains('\n') && process.waitForReadyRead(longest_silence_ms))
            told += process.readAllStandardError();
        QVERIFY2(process.state() == QProcess::Running, told.constData());
        QVERIFY2(told.contains('\n'), "it said nothing");

        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(longest_answer_ms));
        told += process.readAllStandardError();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit, told.constData());
        QVERIFY2(process.exitCode() == 130, told.constData());
        const QRegularExpression whole(QRegularExpression::anchoredPattern(verb.leaves));
        for (const QString& file : inputs_->left())
            QVERIFY2(left_before.contains(file) || whole.match(file).hasMatch(), qPrintable(file));
    }

    void a_recording_that_was_stopped_is_whole() {
        const Run replayed = lab({"devices", "replay", inputs_->path("long.rec")});
        QCOMPARE(replayed.code, 0);
        QCOMPARE(replayed.err, QByteArray());
    }

    /// The end comes at the moment when the file has appeared, or soon after: it goes, or is in the list.
    void a_recording_that_was_stopped_is_not_left_unlisted() {
        const QString photo = inputs_->path("one.jpg"), sound = inputs_->path("noise.wav");
        written(sound, a_noise(600 * 8000));
        const QDir tags(photo + ".tags");
        for (int round = 0; round < 24; ++round) {
            QProcess process;
            process.start(tp::test::in_build("bin/touchphoto-lab"),
                          {"album", "tag", "add", photo, "--from", sound});
            while (tags.entryList({"*.flac"}).isEmpty() && process.state() != QProcess::NotRunning)
                process.waitForFinished(1);
            process.waitForFinished(round / 2 * 25 + 1); // ms, up to where its list is whole
            ::kill(static_cast<pid_t>(process.processId()), round % 2 == 0 ? SIGINT : SIGTERM);
            QVERIFY(process.waitForFinished(longest_answer_ms));
            const Run listed = lab({"album", "tag", "list", photo, "--json"});
            QCOMPARE(listed.code, 0);
            const QStringList there = tags.entryList({"*.flac"});
            QVERIFY2(listed.out.count("\"file\"") == there.size(), listed.out + there.join(' ').toUtf8());
            QVERIFY2(there.size() == 1 || process.exitCode() >= 128, "it said that it was done");
            if (!there.isEmpty())
                QCOMPARE(lab({"album", "tag", "delete", photo, there.front()}).code, 0);
        }
    }

    /// A trial's path is on the disk before the trial: where the end comes in between, it is done again.
    void a_study_that_was_stopped_has_no_half_written_trial() {
        const Run checked = lab({"study", "check", inputs_->path("simulated")});
        const QRegularExpression known(
            "^(Participant [0-9]+: [0-9]+ trials of .*|.* belongs to no trial that was kept[.])$");
        for (const QByteArray& line : checked.out.trimmed().split('\n'))
            QVERIFY2(known.match(QString::fromUtf8(line)).hasMatch(), line.constData());
    }
};

QTEST_GUILESS_MAIN(LongWorkTest)
#include "long_work_test.moc"
