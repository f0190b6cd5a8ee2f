// SPDX-License-Identifier: Apache-2.0
#include "app/shell/program_window.hpp"

#include "app/pages/browse/browse_module.hpp"
#include "app/pages/capture/capture_module.hpp"
#include "app/pages/care/care_module.hpp"
#include "app/pages/explore/explore_module.hpp"
#include "app/pages/lab/lab_module.hpp"
#include "app/pages/mend/mend_module.hpp"
#include "app/pages/print/print_module.hpp"
#include "app/pages/settings/settings_module.hpp"
#include "app/pages/start/start_module.hpp"
#include "app/pages/study/study_module.hpp"
#include "app/shell/focus_words.hpp"
#include "app/shell/own_resources.hpp"

#include <QAccessible>
#include <QColor>
#include <QQmlEngine>
#include <QQuickItem>
#include <QRect>
#include <QScreen>
#include <QUrl>
#include <QVariant>

#include <utility>

extern void qml_register_types_TouchPhoto_Shell();

namespace tp {

ProgramWindow::ProgramWindow(Program& program) : program_(program) {
    keep_to_own_resources(*engine());
    qml_register_types_TouchPhoto_Shell();
    register_start();
    register_browse();
    register_explore();
    register_care();
    register_capture();
    register_mend();
    register_print();
    register_lab();
    register_study();
    register_settings();
    setResizeMode(SizeRootObjectToView);
    setMinimumSize({480, 480}); // a screen of 600 px has so much left below a title bar and beside a panel
    resize(1280, 800);
    setColor(QColor(0x0e, 0x12, 0x17));
    Shell& shell = program.shell();
    const auto entitle = [this, &shell] {
        const QString title = shell.home() ? QString() : shell.title() + " – ";
        setTitle(title + Program::tr("TouchPhoto"));
    };
    connect(&shell, &Shell::pageChanged, this, entitle);
    connect(&program, &Program::language_changed, this, [this] { engine()->retranslate(); });
    entitle();
    setInitialProperties({{"shell", QVariant::fromValue(&shell)},
                          {"announcer", QVariant::fromValue(&program.announcer())},
                          {"sessions", QVariant::fromValue(&program)},
                          {"pages", Program::page_files()}});
    setSource(QUrl("qrc:/qt-project.org/imports/TouchPhoto/Shell/ShellView.qml"));
}

void ProgramWindow::keyPressEvent(QKeyEvent* event) {
    const QQuickItem* before = activeFocusItem();
    QQuickView::keyPressEvent(event);
    const bool tab = event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab;
    if (!tab || activeFocusItem() == before)
        return;
    if (QAccessibleInterface* focused = QAccessible::queryAccessibleInterface(activeFocusItem()))
        program_.tell_focus(focus_words(*focused));
}

void ProgramWindow::fit_to_screen() {
    const QSize room = screen()->availableSize();
    resize(room.height() > room.width() ? room : size().boundedTo(room));
    frame_to_fit_ = true;
}

void ProgramWindow::exposeEvent(QExposeEvent* event) {
    QQuickView::exposeEvent(event);
    if (!isExposed() || !std::exchange(frame_to_fit_, false))
        return;
    const QRect room = screen()->availableGeometry();
    if (room.contains(frameGeometry()))
        return;
    resize(size().boundedTo(room.marginsRemoved(frameMargins()).size()));
    setFramePosition(room.topLeft());
}

void ProgramWindow::closeEvent(QCloseEvent* event) {
    program_.keep_all();
    QQuickView::closeEvent(event);
}

} // namespace tp
