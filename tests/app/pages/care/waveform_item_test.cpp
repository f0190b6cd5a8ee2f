// SPDX-License-Identifier: Apache-2.0
// What is seen of a recording: how loud it is where, and what of it is kept.
#include "app/pages/care/waveform_item.hpp"
#include "drawn_item.hpp"
#include "test_program.hpp"

#include <QList>
#include <QTest>

namespace waveform_item_test {

using namespace tp;
using namespace tp::testing;

namespace {

const QColor kept(200, 220, 255), left_out(120, 40, 40);

/// 40 × 100 px: ten bars, 4 px from one to the next.
struct Bench : DrawnItem<WaveformItem> {
    Bench() : DrawnItem({40, 100}) {
        set("color", kept);
        set("dimColor", left_out);
    }
    void hear(const QList<float>& peaks) { set("peaks", peaks); }
    QList<int> heights(const QColor& colour = kept) {
        const QImage seen = picture();
        QList<int> rows;
        for (int bar = 0; bar < 10; ++bar)
            rows << rows_of(seen, 4 * bar + 1, colour);
        return rows;
    }
};

} // namespace

class WaveformItemTest : public QObject {
    Q_OBJECT
private slots:
    void soft_is_low_loud_is_high_and_silence_a_line() {
        Bench bench;
        QCOMPARE(bench.heights(), QList<int>(10, 0)); // there is no recording
        QList<float> peaks(10, 0.0F);
        peaks[2] = 0.25F; // half of the loudness that a person hears, not a quarter
        peaks[7] = 1.0F;
        bench.hear(peaks);
        QCOMPARE(bench.heights(), QList<int>({2, 2, 50, 2, 2, 2, 2, 100, 2, 2}));
        const QImage seen = bench.picture();
        QCOMPARE(extent_of(seen.copy(8, 0, 4, 100), kept),
                 QRect(0, 25, 3, 50)); // from the middle; a gap between bars
    }

    void a_bar_shows_the_loudest_of_what_it_stands_for() {
        Bench bench;
        QList<float> many(1000, 0.0F);
        many[350] = 1.0F;
        bench.hear(many);
        QCOMPARE(bench.heights(), QList<int>({2, 2, 2, 100, 2, 2, 2, 2, 2, 2}));
        bench.hear({1.0F, 0.25F});
        QCOMPARE(bench.heights(), QList<int>({100, 100, 100, 100, 100, 50, 50, 50, 50, 50}));
    }

    void what_is_left_out_is_dim() {
        Bench bench;
        bench.hear(QList<float>(10, 1.0F));
        bench.set("from", 0.2);
        bench.set("to", 0.7);
        QCOMPARE(bench.heights(), QList<int>({0, 0, 100, 100, 100, 100, 100, 0, 0, 0}));
        QCOMPARE(bench.heights(left_out), QList<int>({100, 100, 0, 0, 0, 0, 0, 100, 100, 100}));
    }
};

} // namespace waveform_item_test

TP_TEST(waveform_item_test, WaveformItemTest, window)
#include "waveform_item_test.moc"
