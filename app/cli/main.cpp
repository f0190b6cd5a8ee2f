// SPDX-License-Identifier: Apache-2.0
#include "app/cli/verbs.hpp"
#include "core/processes/foreign_decoder.hpp"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QtGlobal>

#include <cstdio>

namespace {

/// stderr holds the verbs' sentences; Qt's own remarks about the machine would be taken for them.
void only_what_is_fatal(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtFatalMsg)
        std::fprintf(stderr, "%s\n", qPrintable(message));
}

} // namespace

int main(int argc, char** argv) {
    qInstallMessageHandler(only_what_is_fatal);
    // Text in pictures needs fonts, which need a platform; a shell has no window.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Never destroyed: in its destructor that platform reads every font of the system (Qt 6.4), 60 ms after the
    // work is done.
    static const QGuiApplication& application = *new QGuiApplication(argc, argv);
    tp::decode_in_helpers(&tp::touchphoto_decoders());
    return tp::run_lab(application.arguments().mid(1));
}
