// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/shell/program.hpp"

#include <QKeyEvent>
#include <QQuickView>

namespace tp {

/// The program's window.
class ProgramWindow final : public QQuickView {
    Q_OBJECT
public:
    /// The program must outlive the window.
    explicit ProgramWindow(Program& program);
    /// No larger than the screen it is on; the whole of one that is taller than wide.
    void fit_to_screen();

protected:
    /// Tab also tells what it has come to, where the program's own voice speaks.
    void keyPressEvent(QKeyEvent* event) override;

private:
    Program& program_;
};

} // namespace tp
