// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAccessible>
#include <QList>
#include <QObject>
#include <QQmlComponent>
#include <QQmlEngine>
#include <QQuickItem>
#include <QQuickView>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QTest>
#include <QUrl>
#include <QVariant>
#include <QtGlobal>

#include <algorithm>
#include <memory>

/// A page in a window of its own, for tests: what a screen reader finds in it.
class PageWindow : public QQuickView {
public:
    /// `page` such as "Settings/SettingsPage.qml".
    PageWindow(const QString& page, QObject* session, QSize size = {1280, 800}) {
        setResizeMode(SizeRootObjectToView);
        resize(size);
        setInitialProperties({{"session", QVariant::fromValue(session)}});
        setSource(QUrl("qrc:/qt-project.org/imports/TouchPhoto/" + page));
        show();
        requestActivate();
        if (rootObject() != nullptr)
            rootObject()->forceActiveFocus();
    }
    /// In sight, with what comes after the page.
    bool exposed() {
        return status() == Ready && QTest::qWaitForWindowExposed(this) &&
               QTest::qWaitFor([this] { return complete(*contentItem()); });
    }
    /// Nothing in it is still being made.
    static bool complete(const QQuickItem& item) {
        constexpr int loading = 2; // QQuickLoader::Status
        const QList<QQuickItem*> children = item.childItems();
        return !(item.inherits("QQuickLoader") && item.property("status").toInt() == loading) &&
               std::all_of(children.begin(), children.end(), [](const QQuickItem* child) { return complete(*child); });
    }

    /// Its texts are so many times as large; false where they cannot be.
    bool set_text_scale(double scale) {
        QQmlComponent component(engine());
        component.setData(QString("import QtQml\nimport TouchPhoto.Controls\n"
                                  "QtObject { Component.onCompleted: Theme.textScale = %1 }")
                              .arg(scale)
                              .toUtf8(),
                          QUrl());
        return std::unique_ptr<QObject>(component.create()) != nullptr;
    }

    /// Everything that a screen reader finds, in reading order.
    static QList<QAccessibleInterface*> everything(QQuickWindow& window) {
        QList<QAccessibleInterface*> all;
        collect(QAccessible::queryAccessibleInterface(&window), all);
        return all;
    }
    static QAccessibleInterface* named(QQuickWindow& window, const QString& name) {
        for (QAccessibleInterface* one : everything(window))
            if (one->text(QAccessible::Name) == name)
                return one;
        return nullptr;
    }
    QAccessibleInterface* named(const QString& name) { return named(*this, name); }
    /// Does it as a screen reader does; false where it is not there, or does not offer it.
    static bool act(QAccessibleInterface* found, const QString& action) {
        if (found == nullptr || found->actionInterface() == nullptr ||
            !found->actionInterface()->actionNames().contains(action))
            return false;
        found->actionInterface()->doAction(action);
        return true;
    }
    /// Presses it as a screen reader does, offered or not; false where it is not there.
    static bool press(QAccessibleInterface* found) {
        if (found == nullptr || found->actionInterface() == nullptr)
            return false;
        found->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
        return true;
    }
    static bool press(QQuickWindow& window, const QString& name) { return press(named(window, name)); }
    bool press(const QString& name) { return press(*this, name); }

    /// What can be used and lacks a name or is smaller than `least` pixels; as "role name".
    static QStringList faulty_targets(QQuickWindow& window, double least) {
        QStringList faults;
        for (QAccessibleInterface* one : everything(window)) {
            const QQuickItem* item = tab_stop(one);
            if (item == nullptr)
                continue;
            if (one->text(QAccessible::Name).isEmpty() || item->width() < least || item->height() < least)
                faults << QString("%1 \"%2\" %3×%4").arg(one->role()).arg(one->text(QAccessible::Name))
                              .arg(item->width()).arg(item->height());
        }
        return faults;
    }
    QStringList faulty_targets(double least = 64.0) { return faulty_targets(*this, least); }

    /// Texts that do not fit where they stand, or reach out of the window's sides; as "text (how)".
    static QStringList clipped_texts(QQuickWindow& window) {
        QStringList clipped;
        const double slack = 1.0; // px, of rounding
        for (const QQuickItem* item : shown_items(*window.contentItem())) {
            if (!item->property("truncated").isValid() || item->property("text").toString().isEmpty())
                continue;
            const double wide = item->property("contentWidth").toDouble(), high = item->property("contentHeight").toDouble();
            const double left = item->mapToScene({0.0, 0.0}).x();
            QString how;
            if (item->property("truncated").toBool())
                how = "cut short";
            else if (wide > item->width() + slack || high > item->height() + slack)
                how = QString("needs %1×%2, has %3×%4").arg(wide).arg(high).arg(item->width()).arg(item->height());
            else if (left < -slack || left + item->width() > window.width() + slack)
                how = QString("from %1 to %2").arg(left).arg(left + item->width());
            if (!how.isEmpty())
                clipped << item->property("text").toString() + " (" + how + ")";
        }
        return clipped;
    }

    /// The item that Tab stops at; null where it does not stop here. (Qt 6.4 calls texts focusable too.)
    static QQuickItem* tab_stop(QAccessibleInterface* one) {
        auto* item = qobject_cast<QQuickItem*>(one->object());
        return item != nullptr && item->activeFocusOnTab() && item->isEnabled() ? item : nullptr;
    }
    /// Names of what Tab stops at, as a screen reader reads them.
    static QStringList reading_order(QQuickWindow& window) {
        QStringList names;
        for (QAccessibleInterface* one : everything(window))
            if (tab_stop(one) != nullptr)
                names << one->text(QAccessible::Name);
        return names;
    }
    /// Names of what Tab comes to, once round.
    static QStringList tab_order(QQuickWindow& window) {
        QStringList names;
        QQuickItem* first = window.activeFocusItem();
        for (int i = 0; i < 500; ++i) {
            QAccessibleInterface* one = QAccessible::queryAccessibleInterface(window.activeFocusItem());
            names << (one == nullptr ? QString() : one->text(QAccessible::Name));
            QTest::keyClick(&window, Qt::Key_Tab);
            if (window.activeFocusItem() == first)
                return names;
        }
        return names << "no way round";
    }

private:
    static QList<const QQuickItem*> shown_items(const QQuickItem& root) {
        QList<const QQuickItem*> all;
        if (!root.isVisible() || root.opacity() == 0.0)
            return all;
        all << &root;
        for (const QQuickItem* child : root.childItems())
            all << shown_items(*child);
        return all;
    }
    static void collect(QAccessibleInterface* root, QList<QAccessibleInterface*>& into) {
        if (root == nullptr || root->state().invisible)
            return;
        into << root;
        for (int i = 0; i < root->childCount(); ++i)
            collect(root->child(i), into);
    }
};
