// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_archive.hpp"
#include "app/pages/lab/lab_replayer.hpp"
#include "app/pages/lab/lab_run.hpp"
#include "core/servo/clock.hpp"
#include "lab_parts.hpp"

#include <QDir>
#include <QTemporaryDir>

#include <filesystem>

/// The lab's parts in virtual time, with a folder that is not there yet.
struct LabFolder : LabParts {
    QTemporaryDir around;
    std::filesystem::path place = std::filesystem::path(around.path().toStdString()) / "lab";
    tp::VirtualClock time;
    tp::LabRun run{tp::LabRun::Around{activity, tuning, scene, devices, hand, measurements, teller,
                                      preferences, time, true}};
    tp::LabArchive archive{place, activity, run, measurements, teller};
    tp::LabReplayer replayer{archive, activity, hand, measurements, time, teller};

    LabFolder() {
        QObject::connect(&activity, &tp::LabActivity::stopAsked, [this] {
            replayer.end();
            const bool whole = run.end();
            if (activity.recording())
                teller.say(archive.finish(whole));
            activity.become(tp::LabActivity::Stopped);
        });
    }
    void advance(double seconds) {
        if (!run.run_for(seconds))
            time.sleep_until(time.now() + seconds);
        run.poll();
        replayer.poll();
    }
    /// Records that long.
    void record(double seconds) {
        archive.toggleRecording();
        advance(seconds);
        archive.toggleRecording();
    }
    QStringList files(const char* pattern) const {
        return QDir(QString::fromStdString(place.string())).entryList({pattern}, QDir::Files, QDir::Name);
    }
};
