// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_session.hpp"
#include "study_ground.hpp"

#include <QDir>
#include <QFile>
#include <QString>
#include <QTest>
#include <QUrl>

#include <memory>
#include <utility>

/// The page's session in a test's own time.
struct StudyBench : StudyGround {
    explicit StudyBench(tp::DeviceAccess devices = {})
        : session(std::make_unique<tp::StudySession>(narrator, earcons, guide, preferences,
                                                     settings_with(std::move(devices)))) {}

    tp::StudyRun& run() override { return *session->run(); }
    void pass(double seconds) override { session->advance(seconds); }
    /// The researcher comes and opens an experiment.
    void set_up(const char* text, const QString& name = "own.study") {
        const QString file = folder.filePath(name);
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(text);
        out.close();
        session->enter();
        session->setup()->openFile(QUrl::fromLocalFile(file));
        experiment = *tp::read_experiment(text);
        QTRY_COMPARE_WITH_TIMEOUT(session->setup()->problem(), QString(), 60000);
    }
    /// … and the participant agrees.
    void begin(const char* text) {
        set_up(text);
        session->begin();
        QCOMPARE(run().state(), State::Consent);
        run().agree();
        QTRY_VERIFY_WITH_TIMEOUT(run().state() != State::Opening, 60000);
    }

    std::unique_ptr<tp::StudySession> session;
};
