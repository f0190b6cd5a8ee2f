// SPDX-License-Identifier: Apache-2.0
#include "page_test.hpp"
#include "page_window.hpp"
#include "pixel_contrast.hpp"
#include "whole_program.hpp"

#include <QImage>
#include <QMetaObject>
#include <QQmlComponent>
#include <QQuickItem>
#include <QQuickView>
#include <QRectF>

#include <memory>

using namespace tp;
using namespace tp::testing;

namespace {

constexpr double text_bound = 7.0; // WCAG 2.1, 1.4.6, which the house promises for every text
constexpr double look_bound = 3.0; // 1.4.11: what shows a control and where the keyboard is
const QStringList all_pages{"start",   "browse",  "search",   "explore",   "care",
                            "capture", "mend",    "print",    "lab",       "study",
                            "consent", "sitting", "settings", "questions", "folders"};

/// Everything below an item that is seen and can be used; WCAG leaves out what cannot.
void collect_seen(QQuickItem* root, QList<QQuickItem*>& into) {
    if (!root->isVisible() || !root->isEnabled())
        return;
    into << root;
    for (QQuickItem* child : root->childItems())
        collect_seen(child, into);
}

bool is_a(const QObject* object, const char* qml_type) {
    return QString(object->metaObject()->className()).startsWith(QString(qml_type) + "_QMLTYPE");
}

/// What of a part of an item is not cut off by what it lies in, in the window.
QRectF uncut(const QQuickItem& item, const QRectF& part) {
    QRectF left = item.mapRectToScene(part);
    for (const QQuickItem* around = item.parentItem(); around != nullptr; around = around->parentItem())
        if (around->clip())
            left &= around->mapRectToScene(around->boundingRect());
    return left & QRectF(QPointF(), item.window()->size());
}

/// Where a Text draws its words.
QRectF words_of_text(const QQuickItem& text) {
    const double width = text.property("contentWidth").toDouble(), height = text.property("contentHeight").toDouble();
    const int across = text.property("effectiveHorizontalAlignment").toInt();
    const int down = text.property("verticalAlignment").toInt();
    const auto padding = [&](const char* side) { return text.property(side).toDouble(); };
    const double room = text.width() - padding("leftPadding") - padding("rightPadding") - width;
    const double rest = text.height() - padding("topPadding") - padding("bottomPadding") - height;
    return {padding("leftPadding") + room * (across == Qt::AlignRight ? 1.0 : across == Qt::AlignHCenter ? 0.5 : 0.0),
            padding("topPadding") + rest * (down == Qt::AlignBottom ? 1.0 : down == Qt::AlignVCenter ? 0.5 : 0.0), width, height};
}

QString hex(QRgb colour) { return QColor(colour).name(); }

/// A page as it is drawn, with all that it shows.
class DrawnPage {
public:
    DrawnPage(WholeProgram& whole, const QString& page) : whole_(whole) {
        const bool of_study = page == "consent" || page == "sitting";
        whole.program->open_page(page == "search"                           ? "browse"
                                 : page == "questions" || page == "folders" ? "start"
                                 : of_study                                 ? "study"
                                                                            : page);
        if (of_study)
            QTRY_VERIFY_WITH_TIMEOUT(
                (whole.program->study().begin(), whole.program->study().run()->running()), 60000);
        if (page == "sitting") {
            whole.program->study().run()->agree();
            QTRY_COMPARE_WITH_TIMEOUT(whole.program->study().run()->state(), StudyRun::State::Ready, 60000);
        }
        if (page == "search")
            whole.program->browse().lists()->openSearch();
        if (page == "questions" || page == "folders")
            whole.program->start().askAgain();
        for (int i = 0; page == "folders" && i < 4; ++i)
            whole.program->start().questions()->answer(0);
        if (page == "folders") // "In another folder", before "Ask me later"
            whole.program->start().questions()->answer(
                static_cast<int>(whole.program->start().questions()->answers().size()) - 2);
        QTRY_VERIFY_WITH_TIMEOUT(whole.complete(), 60000);
        if (page == "explore")
            QTRY_COMPARE_WITH_TIMEOUT(whole.program->explore().view()->state(), ExploreView::State::Ready,
                                      60000);
        if (page == "mend")
            QTRY_COMPARE_WITH_TIMEOUT(whole.program->mend().photo()->state(), MendedPhoto::State::Ready, 60000);
        if (page == "print")
            QTRY_VERIFY_WITH_TIMEOUT(whole.program->print().sheet()->ready(), 60000);
        QTest::qWait(20); // nothing fades in: it is there
        picture = whole.window->grabWindow().convertToFormat(QImage::Format_RGB32);
        if (const QString folder = qEnvironmentVariable("TP_PICTURES"); !folder.isEmpty()) // to look at
            picture.save(QString("%1/%2-%3-%4.png").arg(folder, page, QTest::currentDataTag()).arg(picture.width()));
    }

    QList<QQuickItem*> seen() const {
        QList<QQuickItem*> items;
        collect_seen(whole_.window->contentItem(), items);
        return items;
    }
    QStringList weak_texts(int* looked_at) const {
        QStringList weak;
        for (const QQuickItem* item : seen()) {
            const QString words = item->property("text").toString();
            if (!item->inherits("QQuickText") || words.trimmed().isEmpty())
                continue;
            const QRectF drawn = words_of_text(*item), left = uncut(*item, drawn);
            if (left.height() < 0.7 * drawn.height() || left.width() < 0.5 * drawn.width())
                continue; // scrolled away
            ++*looked_at;
            const DrawnContrast contrast = drawn_contrast(picture, left.toAlignedRect());
            if (contrast.ratio < text_bound)
                weak << QString("%1 : 1 \"%2\" %3 on %4").arg(contrast.ratio, 0, 'f', 1).arg(words.left(40))
                            .arg(hex(contrast.foreground), hex(contrast.background));
        }
        return weak;
    }
    /// Edges of what can be pressed, pulled or written in.
    QStringList weak_edges(int* looked_at) const {
        QStringList weak;
        for (QQuickItem* item : seen()) {
            const QAccessibleInterface* one = item->activeFocusOnTab() ? QAccessible::queryAccessibleInterface(item) : nullptr;
            const bool has_no_edge = one != nullptr && (one->role() == QAccessible::Canvas || one->role() == QAccessible::Graphic ||
                                                        one->role() == QAccessible::Grouping || is_a(item, "TrimHandle"));
            const QRectF left = uncut(*item, item->boundingRect().adjusted(-4, -4, 4, 4));
            const bool whole = left.height() >= item->height() + 7.5 && left.width() >= item->width() + 7.5;
            if (one == nullptr || has_no_edge || !whole || item->hasActiveFocus())
                continue;
            ++*looked_at;
            const double contrast = edge_contrast(picture, item->mapRectToScene(item->boundingRect()).toRect(), {-1, 1}, {-4, -4}, 12);
            if (contrast < look_bound)
                weak << QString("%1 : 1 %2").arg(contrast, 0, 'f', 1).arg(one->text(QAccessible::Name));
        }
        return weak;
    }
    /// What is moved within a slider, and what shows whether a switch is on.
    QStringList weak_marks(int* looked_at) const {
        QStringList weak;
        for (const QQuickItem* item : seen())
            for (const char* part : {"handle", "indicator"}) {
                const auto* mark = item->property(part).value<QQuickItem*>();
                if (mark == nullptr || !mark->isVisible() || uncut(*mark, mark->boundingRect()).height() < mark->height())
                    continue;
                ++*looked_at;
                const QRect place = mark->mapRectToScene(mark->boundingRect()).toAlignedRect();
                const double contrast = drawn_contrast(picture, place.adjusted(-8, -6, 8, 6)).ratio;
                if (contrast < look_bound)
                    weak << QString("%1 : 1 %2 of %3").arg(contrast, 0, 'f', 1).arg(part, item->property("text").toString());
            }
        return weak;
    }

    QImage picture;

private:
    WholeProgram& whole_;
};

QQuickItem* shown_ring(QQuickItem* below, const QQuickItem* target) {
    for (QQuickItem* child : below->childItems()) {
        if (is_a(child, "FocusRing") && child->isVisible() && child->property("target").value<QQuickItem*>() == target)
            return child;
        if (QQuickItem* found = shown_ring(child, target); found != nullptr)
            return found;
    }
    return nullptr;
}

} // namespace

class ContrastTest : public PageTest {
    Q_OBJECT
private slots:
    void the_ratio_is_that_of_the_recommendation() {
        QVERIFY(std::abs(contrast_ratio(qRgb(0, 0, 0), qRgb(255, 255, 255)) - 21.0) < 1e-9);
        QVERIFY(std::abs(contrast_ratio(qRgb(0x76, 0x76, 0x76), qRgb(255, 255, 255)) - 4.54) < 0.01);
        QVERIFY(std::abs(contrast_ratio(qRgb(255, 0, 0), qRgb(0, 0, 255)) - 2.15) < 0.01);
        QCOMPARE(contrast_ratio(qRgb(9, 9, 9), qRgb(9, 9, 9)), 1.0);
    }

    void what_is_measured_is_what_was_drawn_data() {
        QTest::addColumn<QColor>("foreground");
        QTest::addColumn<QColor>("background");
        QTest::addColumn<int>("size");
        QTest::newRow("black on white") << QColor("#000000") << QColor("#ffffff") << 16;
        QTest::newRow("grey on white, 4.5") << QColor("#767676") << QColor("#ffffff") << 16;
        QTest::newRow("weak, 1.6") << QColor("#333333") << QColor("#111111") << 18;
        QTest::newRow("yellow on black, large") << QColor("#ffff00") << QColor("#000000") << 46;
    }
    void what_is_measured_is_what_was_drawn() {
        QFETCH(QColor, foreground);
        QFETCH(QColor, background);
        QFETCH(int, size);
        QQuickView view;
        view.setColor(background);
        QQmlComponent component(view.engine());
        component.setData(QString("import QtQuick\nText { x: 20.5; y: 20; text: 'Feel a face'; color: '%1'; font.pixelSize: %2 }")
                              .arg(foreground.name()).arg(size).toUtf8(), QUrl());
        const std::unique_ptr<QQuickItem> text(qobject_cast<QQuickItem*>(component.create()));
        QVERIFY2(text != nullptr, qPrintable(component.errorString()));
        text->setParentItem(view.contentItem());
        view.resize(400, 120);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const QImage picture = view.grabWindow().convertToFormat(QImage::Format_RGB32);
        const DrawnContrast measured = drawn_contrast(picture, text->mapRectToScene(words_of_text(*text)).toAlignedRect());
        const double drawn = contrast_ratio(foreground.rgb(), background.rgb());
        QVERIFY2(measured.ratio > 0.93 * drawn && measured.ratio <= drawn + 1e-9, qPrintable(QString("%1 of %2").arg(measured.ratio).arg(drawn)));
    }

    void all_that_is_drawn_stands_out_data() { add_looks({1000, 3000}, {1000, 4600}); }
    void all_that_is_drawn_stands_out() {
        QFETCH(QSize, size);
        WholeProgram whole(choices());
        show(whole, size);
        QStringList weak;
        int texts = 0, edges = 0, marks = 0;
        for (const QString& page : all_pages) {
            const DrawnPage drawn(whole, page);
            for (const QString& one : drawn.weak_texts(&texts) + drawn.weak_edges(&edges) + drawn.weak_marks(&marks))
                weak << page + ": " + one;
        }
        for (const QString& one : weak)
            QTest::qFail(qPrintable(one), __FILE__, __LINE__);
        QVERIFY2(texts > 250 && edges > 150 && marks > 20, qPrintable(QString("%1 %2 %3").arg(texts).arg(edges).arg(marks)));
    }

    void the_focus_ring_stands_out_and_is_whole_data() { add_looks({1280, 800}, {1280, 800}); }
    void the_focus_ring_stands_out_and_is_whole() {
        QFETCH(QSize, size);
        WholeProgram whole(choices());
        show(whole, size);
        QStringList weak;
        int rings = 0;
        for (const QString& page : all_pages) {
            const DrawnPage drawn(whole, page);
            const QQuickItem* first = whole.window->activeFocusItem();
            for (int i = 0; i < 200 && (i == 0 || whole.window->activeFocusItem() != first); ++i) {
                weak << weak_ring(*whole.window, page);
                ++rings;
                QTest::keyClick(whole.window.get(), Qt::Key_Tab);
            }
        }
        weak.removeAll(QString());
        for (const QString& one : weak)
            QTest::qFail(qPrintable(one), __FILE__, __LINE__);
        QVERIFY2(rings > 120, qPrintable(QString::number(rings)));
    }

private:
    static void add_looks(QSize usual, QSize large) {
        QTest::addColumn<int>("theme");
        QTest::addColumn<double>("text");
        QTest::addColumn<QSize>("size");
        const char* const themes[] = {"dark", "light", "yellow on black"};
        for (int theme = 0; theme < 3; ++theme) {
            QTest::addRow("%s", themes[theme]) << theme << 1.0 << usual;
            QTest::addRow("%s, large text", themes[theme]) << theme << 2.0 << large;
        }
    }
    static Choices choices() {
        QFETCH(int, theme);
        QFETCH(double, text);
        Choices choices = WholeProgram::asked();
        choices.theme = static_cast<Choices::Theme>(theme);
        choices.text_scale = text;
        choices.motion = false;
        return choices;
    }
    static void show(WholeProgram& whole, QSize size) {
        qputenv("HOME", whole.folder.path().toUtf8()); // the folders that are chosen from
        whole.window->resize(size);
        QVERIFY(whole.shown());
        QTRY_VERIFY_WITH_TIMEOUT(whole.complete(), 60000);
        Choices now = whole.program->preferences().choices();
        now.last_photo = whole.folder.filePath("Family/ben_and_clara.jpg");
        whole.program->preferences().set(now);
    }
    /// Empty where the ring round what has the keyboard is seen and whole.
    static QString weak_ring(QQuickWindow& window, const QString& page) {
        QQuickItem* focused = window.activeFocusItem();
        QAccessibleInterface* one = QAccessible::queryAccessibleInterface(focused);
        const QString name = page + ": " + (one != nullptr ? one->text(QAccessible::Name) : QString(focused->metaObject()->className()));
        const QQuickItem* ring = shown_ring(focused, focused);
        if (ring == nullptr)
            return name + " has no ring";
        const QImage picture = window.grabWindow().convertToFormat(QImage::Format_RGB32);
        const QRect place = ring->mapRectToScene(ring->boundingRect()).toRect();
        const double outside = edge_contrast(picture, place, {1, 1}, {-2, -2}, 20),
                     inside = edge_contrast(picture, place, {1, 1}, {3, 4}, 20);
        if (std::min(outside, inside) >= look_bound)
            return {};
        return QString("%1: %2 outside, %3 inside, at %4,%5 %6×%7").arg(name).arg(outside, 0, 'f', 1).arg(inside, 0, 'f', 1)
            .arg(place.x()).arg(place.y()).arg(place.width()).arg(place.height());
    }
};

QTEST_MAIN(ContrastTest)
#include "contrast_test.moc"
