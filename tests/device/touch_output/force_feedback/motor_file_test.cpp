// SPDX-License-Identifier: Apache-2.0
// A motor that is a file, behind the back end that serves real ones: what reaches it, and how it is plugged in and out.
#include "core/touch/tick.hpp"
#include "device/touch_output/force_feedback/feedback_output.hpp"
#include "device/touch_output/force_feedback/motor_file.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace motor_file_test {

using namespace tp;

namespace {

struct Bench {
    QTemporaryDir folder;
    QString file = folder.filePath("motor");

    Bench() { plug_in(); }
    void plug_in() const { QVERIFY(QFile(file).open(QIODevice::WriteOnly)); }
    void unplug() const { QVERIFY(QFile::remove(file)); }
    std::filesystem::path path() const { return file.toStdString(); }
    /// By whoever calls deliver().
    std::unique_ptr<FeedbackOutput> output() const {
        return std::make_unique<FeedbackOutput>(
            FeedbackOutput::Identity{"simulated motor", ""},
            [this]() -> Result<std::unique_ptr<FeedbackNode>> {
                auto node = std::make_unique<MotorFile>(path());
                if (node->open() != 0)
                    return Error{"It cannot be opened."};
                return std::unique_ptr<FeedbackNode>(std::move(node));
            },
            LatestWriter::Thread::caller);
    }
    /// The lines without their times.
    QStringList lines() const {
        QFile written(file);
        QStringList lines;
        if (written.open(QIODevice::ReadOnly))
            for (const QByteArray& line : written.readAll().split('\n'))
                lines << QString::fromLatin1(line).section(' ', 1);
        return lines;
    }
};

} // namespace

class MotorFileTest : public QObject {
    Q_OBJECT
private slots:
    void each_tick_is_a_line_with_what_is_felt_of_it() {
        const Bench bench;
        const auto output = bench.output();
        QVERIFY(output->open().ok());
        for (const Tick& tick : {Tick(0.7, 1.0, 0.008), Tick(0.7, 1.0, 0.008), Tick(0.25, 0.0, 0.016)}) {
            QVERIFY(output->tick(tick));
            output->deliver();
        }
        QCOMPARE(bench.lines(),
                 QStringList({"opened", "tick 700 250 8", "tick 700 250 8", "tick 250 125 16", ""}));
    }
    void what_was_asked_beyond_the_bounds_of_a_tick_does_not_reach_it() {
        const Bench bench;
        const auto output = bench.output();
        QVERIFY(output->open().ok());
        QVERIFY(output->tick(Tick(9.0, 9.0, 9.0)));
        output->deliver();
        QCOMPARE(bench.lines().value(1), QString("tick 1000 250 50"));
    }
    void halted_it_is_off_and_stopped_it_is_closed() {
        const Bench bench;
        const auto output = bench.output();
        QVERIFY(output->open().ok());
        output->halt();
        output->deliver();
        QCOMPARE(bench.lines(), QStringList({"opened", "off", ""}));
        output->stop();
        QCOMPARE(bench.lines().value(bench.lines().size() - 2), QString("closed"));
    }
    void without_its_file_it_is_lost_and_with_a_new_one_opened_again() {
        const Bench bench;
        const auto output = bench.output();
        QVERIFY(output->open().ok());
        QVERIFY(!output->lost());
        bench.unplug();
        QVERIFY(output->lost());
        QVERIFY(!output->tick(Tick(1.0, 0.5, 0.01)));
        QVERIFY(!output->complaint().empty());
        QVERIFY(!output->open().ok());
        QVERIFY(!QFile::exists(bench.file)); // asking for it does not plug it in
        bench.plug_in();
        QVERIFY(output->open().ok());
        QVERIFY(output->tick(Tick(1.0, 0.5, 0.01)));
        output->deliver();
        QCOMPARE(bench.lines().filter("tick").size(), 1);
    }
    void it_is_plugged_in_while_the_file_is_there() {
        const Bench bench;
        const auto plugged = plugged_motor_file(bench.path());
        QCOMPARE(plugged.size(), std::size_t(1));
        QCOMPARE(plugged[0].means, TouchMeans::ticks);
        const auto output = plugged[0].make();
        const auto can = output->open();
        QVERIFY(can.ok());
        QCOMPARE(can->means, plugged[0].means);
        QCOMPARE(can->delay, plugged[0].delay);
        output->stop();
        bench.unplug();
        QVERIFY(plugged_motor_file(bench.path()).empty());
        QVERIFY(!plugged[0].make()->open().ok());
        QVERIFY(plugged_motor_file(bench.folder.path().toStdString()).empty()); // a folder is none
    }
};

} // namespace motor_file_test

TP_TEST(motor_file_test, MotorFileTest, event_loop)
#include "motor_file_test.moc"
