// SPDX-License-Identifier: Apache-2.0
// What is seen under the contours that are mended: the part of the photograph, and the force where it is wanted.
#include "app/pages/mend/mend_picture_item.hpp"
#include "drawn_item.hpp"
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QTest>

namespace mend_picture_item_test {

using namespace tp;
using namespace tp::testing;

namespace {

const QColor photo_colour(90, 110, 130);

struct Bench : MendBench {
    DrawnItem<MendPictureItem> drawn{{800, 600}};

    Bench() { drawn.item.setSession(&session); }
    ~Bench() { drawn.item.setSession(nullptr); }
    QRect seen() { return extent_of(drawn.picture(), photo_colour); }
};

} // namespace

class MendPictureItemTest : public QObject {
    Q_OBJECT
private slots:
    void the_photograph_lies_where_the_view_has_it() {
        Bench bench;
        bench.session.view()->showAll();
        const auto lies_there = [&] {
            const QRect wanted =
                (bench.session.view()->photo_rect() & QRectF(0, 0, 800, 600)).toAlignedRect();
            const QRect there = bench.seen();
            return std::abs(there.left() - wanted.left()) < 3 &&
                   std::abs(there.right() - wanted.right()) < 3 && std::abs(there.top() - wanted.top()) < 3 &&
                   std::abs(there.bottom() - wanted.bottom()) < 3;
        };
        QVERIFY(lies_there());
        bench.session.view()->zoomAt(3.0, 400, 300);
        bench.session.view()->panBy(250, -100);
        QVERIFY(lies_there());
        bench.session.view()->panBy(900, 0); // its left border is in sight
        QVERIFY(lies_there() && bench.seen().left() > 20);
        bench.drawn.item.setSession(nullptr);
        QVERIFY(bench.seen().isEmpty());
    }

    void large_pixels_are_seen_as_they_are() {
        Bench bench;
        MendPhoto photo = drawn_mend_photo(bench.folder.path());
        photo.image.setPixelColor(200, 150, QColor(255, 255, 255));
        bench.session.show(std::move(photo));
        bench.session.view()->zoomAt(1000.0, 400, 300); // as far as it goes
        bench.session.view()->bring_in_sight({200.0, 150.0});
        const QPointF middle = bench.session.view()->to_window({200.0, 150.0});
        const double half = 0.5 * bench.session.view()->scale();
        const QRect white = extent_of(bench.drawn.picture(), Qt::white);
        QVERIFY2(std::abs(white.width() - 2.0 * half) < 2 && std::abs(white.height() - 2.0 * half) < 2,
                 qPrintable(QString("%1 of %2").arg(white.width()).arg(2.0 * half)));
        QVERIFY(std::abs(white.center().x() - middle.x()) < 2 &&
                std::abs(white.center().y() - middle.y()) < 2);
    }

    void the_force_is_seen_where_it_is_wanted() {
        Bench bench;
        bench.session.view()->showAll();
        const QImage plain = bench.drawn.picture();
        bench.session.preview()->setForceShown(true);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.session.preview()->felt().field.isNull(), 60000);
        const QImage force = bench.drawn.picture();
        const MendContour& lip = *bench.session.photo()->work().faces[0].features[lips].line;
        const QPoint beside = bench.session.view()->to_window(lip.nodes[0].at).toPoint() - QPoint(8, 0);
        QVERIFY(!is_near(force.pixelColor(beside), plain.pixelColor(beside)));
        const QPoint corner = bench.session.view()->photo_rect().topLeft().toPoint() + QPoint(4, 4);
        QVERIFY(is_near(force.pixelColor(corner), photo_colour)); // nothing is felt there
        bench.session.preview()->setForceShown(false);
        QVERIFY(bench.drawn.picture() == plain);
    }
};

} // namespace mend_picture_item_test

TP_TEST(mend_picture_item_test, MendPictureItemTest, window)
#include "mend_picture_item_test.moc"
