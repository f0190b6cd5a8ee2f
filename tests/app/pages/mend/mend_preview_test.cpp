// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_preview.hpp"
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <utility>

namespace mend_preview_test {

using namespace tp;
using State = MendPreview::State;

namespace {

struct PreviewBench : MendParts {
    MendPreview preview{photo, narrator};

    explicit PreviewBench(int faces = 1) { show(faces); }
    void move_all_by(Vec2 by) {
        history.step("the eye was moved", [&](MendWork& work) {
            move_all(*work.faces[0].features[left_eye].line, by);
            work.faces[0].features[left_eye].mended = true;
        });
    }
};

} // namespace

class MendPreviewTest : public QObject {
    Q_OBJECT
private slots:
    void how_much_is_felt_is_told() {
        PreviewBench bench;
        QTRY_COMPARE_WITH_TIMEOUT(bench.preview.change(), QString("It feels as the program found it."),
                                  60000);
        QVERIFY(!bench.preview.felt().field.isNull());
        bench.move_all_by({0, -8});
        QTRY_VERIFY_WITH_TIMEOUT(bench.preview.change().startsWith("A finger notices the difference"), 60000);
        QVERIFY(bench.preview.felt().difference->max_n > 0.1);
        // The field lies where the photograph is: the surface round the face.
        QVERIFY(bench.preview.felt().place.contains(QPointF(200, 150)));
        bench.history.undo();
        QTRY_COMPARE_WITH_TIMEOUT(bench.preview.change(), QString("It feels as the program found it."),
                                  60000);
    }
    void the_newest_contours_are_felt() {
        PreviewBench bench;
        QCOMPARE(bench.preview.state(), State::Asked);
        for (int i = 0; i < 50; ++i)
            bench.move_all_by({0.5, 0});
        QCOMPARE(bench.preview.state(), State::Outdated);
        QTRY_COMPARE_WITH_TIMEOUT(bench.preview.state(), State::Current, 60000);
        const MendWork& work = bench.photo.work();
        const FeltChange now = felt_change(found_faces(work), faces_of(work));
        QCOMPARE(bench.preview.felt().difference->mean_n, now.difference->mean_n);
        QCOMPARE(bench.preview.felt().field, now.field);
    }
    void nothing_of_a_photograph_that_is_gone_is_felt() {
        PreviewBench bench;
        QTRY_COMPARE_WITH_TIMEOUT(bench.preview.state(), State::Current, 60000);
        MendPhoto useless = drawn_mend_photo(bench.folder.path(), 0);
        useless.usable = false;
        bench.photo.show(std::move(useless));
        QCOMPARE(bench.preview.state(), State::Current);
        QVERIFY(bench.preview.felt().field.isNull());
        QVERIFY(bench.preview.change().isEmpty());
    }
    void the_force_is_shown_where_that_is_asked_for() {
        PreviewBench bench;
        QVERIFY(!bench.preview.forceShown());
        bench.preview.setForceShown(true);
        QCOMPARE(bench.said(), QString("The force is shown."));
        bench.preview.setForceShown(false);
        QCOMPARE(bench.said(), QString("The force is hidden."));
    }
};

} // namespace mend_preview_test

TP_TEST(mend_preview_test, MendPreviewTest, window)
#include "mend_preview_test.moc"
