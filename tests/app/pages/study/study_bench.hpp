// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_session.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "audio/speech/recording_voice.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/geometry/polyline.hpp"
#include "core/study_folder/path_file.hpp"
#include "core/study_folder/study_folder.hpp"
#include "fake_loudspeaker.hpp"

#include <QDir>
#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

/// The page's session in a test's own time, with a folder of its own.
struct StudyBench {
    static constexpr std::uint64_t seed = 7;
    /// Two lines, each once, with a training trial.
    static constexpr const char* lines =
        "experiment: lines\ntitle: Two lines\ntask: follow\n"
        "factor path: circle, curve\nset stiffness: 0.5 N/mm\nset range: 10 mm\n"
        "training: 1\n";
    /// Two shapes, each twice, in a time.
    static constexpr const char* shapes = "experiment: shapes\ntitle: Two shapes\ntask: name\n"
                                          "factor shape: circle, square\nanswer: shape\nrepetitions: 2\n"
                                          "break after: 2\nlongest trial: 3 s\n";

    explicit StudyBench(tp::DeviceAccess devices = {}) {
        tp::StudySettings settings;
        settings.folder = documents().toStdString();
        settings.devices = std::move(devices);
        settings.version = "touchphoto test";
        settings.new_seed = [] { return seed; };
        settings.time = &time;
        session = std::make_unique<tp::StudySession>(narrator, earcons, guide, preferences, settings);
    }
    ~StudyBench() { session.reset(); }

    QString documents() const { return folder.filePath("Documents"); }
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
    /// The trial that is felt now, as it was planned.
    tp::StudyTrial now() const {
        const auto next = tp::next_trial(experiment, tp::trials_of(experiment, participant, seed), records());
        return *tp::trial_of(experiment, next->planned);
    }
    std::vector<tp::TrialRecord> records() const {
        const auto study = tp::read_study(study_folder());
        std::vector<tp::TrialRecord> own;
        if (study)
            for (const tp::TrialRecord& record : study->records)
                if (record.participant == participant)
                    own.push_back(record);
        return own;
    }
    std::filesystem::path study_folder() const { return (documents() + '/').toStdString() + experiment.name; }
    std::vector<tp::FingerSample> path_of(int trial) const {
        const auto path =
            tp::read_path(study_folder() / tp::study_paths_folder / tp::path_file_name(participant, trial));
        return path ? *path : std::vector<tp::FingerSample>();
    }

    /// The hand goes to a place, 100 mm a second; until the trial ends.
    void go(tp::Vec2 to) {
        while (run().state() == State::Feeling && length(to - hand) > 1e-6) {
            tp::Vec2 way = to - hand;
            if (length(way) > 0.5)
                way *= 0.5 / length(way);
            hand += way;
            session->moveBy(way.x, -way.y);
            session->advance(0.005);
        }
    }
    /// Starts the trial that is ready.
    tp::StudyTrial start() {
        tp::StudyTrial trial = now();
        hand = trial.start;
        run().goOn();
        session->advance(0.005);
        return trial;
    }
    /// Follows the line once from its start to its end, `share` of it.
    void follow(double share = 1.0) {
        const tp::StudyTrial trial = start();
        const double all = tp::length_of(trial.path);
        for (double arc = 0.0; arc < share * all && run().state() == State::Feeling; arc += 2.0)
            go(tp::point_along(trial.path, arc));
        if (share >= 1.0) {
            go(trial.path.closed ? trial.path.points.front() : trial.path.points.back());
            for (int i = 0; i < 400 && run().state() == State::Feeling; ++i)
                session->advance(0.005); // the finger comes behind the hand
        }
    }
    /// What was done is on the disk.
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(run().state() != State::Keeping, 60000); }

    using State = tp::StudyRun::State;
    tp::StudyRun& run() { return *session->run(); }
    QString said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
    bool has_said(const QString& part) const { return !voice.said().filter(part).isEmpty(); }

    QTemporaryDir folder;
    tp::VirtualClock time;
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::testing::FakeLoudspeaker earcon_speaker, guide_speaker;
    tp::EarconPlayer earcons{earcon_speaker};
    tp::SonifiedGuide guide{guide_speaker};
    tp::Preferences preferences;
    tp::Experiment experiment; ///< that was set up
    int participant = 1;
    tp::Vec2 hand{0.0}; ///< mm
    std::unique_ptr<tp::StudySession> session;
};
