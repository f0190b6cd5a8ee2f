// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/touch_connector.hpp"

#include "app/parts/devices/giving_back.hpp"
#include "audio/sentences/sentences.hpp"

#include <QMetaObject>

#include <utility>

namespace tp {

TouchConnector::TouchConnector(TouchAccess access)
    : access_(std::move(access)), plugs_(pool_, look(), access_.look_every_ms, access_.on_plug) {
    pool_.setMaxThreadCount(1);
}

TouchConnector::~TouchConnector() { pool_.waitForDone(); }

PlugLook::Look TouchConnector::look() {
    if (!access_.list)
        return {};
    return [this, list = access_.list]() -> std::function<void()> {
        return [this, found = list()] {
            there_ = found;
            emit looked();
        };
    };
}

void TouchConnector::open(const ListedTouchOutput& listed) {
    opening_ = true;
    pool_.start([this, wish = ++wish_, listed, make = access_.make, before = GivingBack::here().begun()] {
        GivingBack::here().wait_for(before);
        auto open = std::make_shared<OpenTouch>();
        open->listed = listed;
        QString problem;
        if (Result<std::unique_ptr<TouchOutput>> made = make(listed.name); !made) {
            problem = in_persons_language(made.error());
        } else {
            open->output = std::move(made).value();
            if (Result<TouchCapabilities> can = open->output->open())
                open->can = std::move(can).value();
            else
                problem = in_persons_language(can.error());
        }
        QMetaObject::invokeMethod(this, [this, wish, problem, open] {
            if (wish != wish_)
                return release(std::move(open->output));
            opening_ = false;
            if (problem.isEmpty())
                emit opened(open);
            else
                emit refused(problem);
        });
    });
}

void TouchConnector::cancel() {
    ++wish_;
    opening_ = false;
}

void TouchConnector::release(std::unique_ptr<TouchDrive> drive) {
    if (drive)
        give_back(
            [held = std::make_shared<std::unique_ptr<TouchDrive>>(std::move(drive))] { held->reset(); });
}

void TouchConnector::release(std::unique_ptr<TouchOutput> output) {
    if (output)
        give_back(
            [held = std::make_shared<std::unique_ptr<TouchOutput>>(std::move(output))] { held->reset(); });
}

/// It may wait.
void TouchConnector::give_back(std::function<void()> let_go) {
    pool_.start([number = GivingBack::here().begin(), let_go = std::move(let_go)] {
        let_go();
        GivingBack::here().ended(number);
    });
}

} // namespace tp
