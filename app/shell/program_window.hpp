// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/shell/program.hpp"

#include <QCloseEvent>
#include <QExposeEvent>
#include <QKeyEvent>
#include <QQuickView>

namespace tp {

/// The program's window.
class ProgramWindow final : public QQuickView {
    Q_OBJECT
public:
    /// The program must outlive the window.
    explicit ProgramWindow(Program& program);
    /// No larger than what panels leave of the screen it is on, its frame included; the whole of one that is taller than
    /// wide. To be called before it is shown.
    void fit_to_screen();

protected:
    /// Tab also tells what it has come to, where the program's own voice speaks.
    void keyPressEvent(QKeyEvent* event) override;
    void exposeEvent(QExposeEvent* event) override;
    /// Not before everything is kept.
    void closeEvent(QCloseEvent* event) override;

private:
    Program& program_;
    bool frame_to_fit_ = false; ///< which is not known before the window manager has given it one
};

} // namespace tp
