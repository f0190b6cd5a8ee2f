// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_run.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/earcons.hpp"
#include "audio/speech/recording_voice.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/geometry/polyline.hpp"
#include "core/study_folder/path_file.hpp"
#include "core/study_folder/study_folder.hpp"
#include "fake_loudspeaker.hpp"
#include "heard_earcon.hpp"

#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

/// What stands below a sitting: a folder of its own, a test's own time, voice and loudspeakers; and a participant's hand.
struct StudyGround {
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
    using State = tp::StudyRun::State;

    virtual ~StudyGround() = default;
    virtual tp::StudyRun& run() = 0;
    /// So much of the test's time passes.
    virtual void pass(double seconds) = 0;

    QString documents() const { return folder.filePath("Documents"); }
    tp::StudySettings settings_with(tp::DeviceAccess devices) {
        tp::StudySettings settings;
        settings.folder = documents().toStdString();
        settings.devices = std::move(devices);
        settings.version = "touchphoto test";
        settings.new_seed = [] { return seed; };
        settings.time = &time;
        return settings;
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
            run().move_by(way);
            pass(0.005);
        }
    }
    /// Starts the trial that is ready.
    tp::StudyTrial start() {
        tp::StudyTrial trial = now();
        hand = trial.start;
        run().goOn();
        pass(0.005);
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
                pass(0.005); // the finger comes behind the hand
        }
    }
    /// Starts the trial that is ready, and gives this answer to it.
    void name(int answer) {
        start();
        run().answer(answer);
        settle();
    }
    /// What was done is on the disk.
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(run().state() != State::Keeping, 60000); }

    QString said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
    bool has_said(const QString& part) const { return !voice.said().filter(part).isEmpty(); }

    /// Of the sounds that were begun since the last call, whether this one is among them; all of them are forgotten.
    bool sounded(tp::Earcon earcon) { return tp::testing::heard_earcon(earcon_speaker, earcon); }

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
};
