// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_ear.hpp"
#include "app/pages/study/study_finger.hpp"
#include "app/pages/study/study_keeping.hpp"
#include "app/pages/study/study_plan.hpp"
#include "app/pages/study/study_run.hpp"
#include "app/pages/study/study_teller.hpp"
#include "study_ground.hpp"

#include <QTest>

#include <memory>
#include <utility>

/// A sitting with the parts that it needs, without set-up, overview and session.
struct StudyParts : StudyGround {
    explicit StudyParts(tp::DeviceAccess devices = {}) : settings(settings_with(std::move(devices))) {
        teller.set_here(true);
    }

    tp::StudyRun& run() override { return *sitting; }
    void pass(double seconds) override {
        for (double left = seconds; left > 0.0025; left -= 0.005) {
            finger.pass(0.005);
            sitting->poll();
        }
    }
    tp::StudyPlan plan(const char* text) {
        experiment = *tp::read_experiment(text);
        tp::StudyPlan plan;
        plan.experiment = experiment;
        plan.folder = study_folder();
        plan.participant = participant;
        plan.device = device;
        return plan;
    }
    /// The participant agrees.
    void begin(const char* text) {
        sitting->begin(plan(text));
        sitting->agree();
        opened();
    }
    void opened() { QTRY_VERIFY_WITH_TIMEOUT(sitting->state() != State::Opening, 60000); }

    tp::StudySettings settings;
    bool device = false; ///< one moves the finger
    tp::StudyTeller teller{narrator, earcons};
    tp::StudyEar ear{guide};
    tp::StudyFinger finger{settings, preferences};
    std::unique_ptr<tp::StudyKeeping> keeping = std::make_unique<tp::StudyKeeping>();
    std::unique_ptr<tp::StudyRun> sitting =
        std::make_unique<tp::StudyRun>(settings, finger, *keeping, ear, teller);
};
