// SPDX-License-Identifier: Apache-2.0
#include "app/parts/work/latest_task.hpp"

#include <QMetaObject>

#include <exception>
#include <utility>

namespace tp {

LatestTask::LatestTask() { pool_.setMaxThreadCount(1); }

LatestTask::~LatestTask() {
    cancel();
    pool_.waitForDone();
}

void LatestTask::cancel() {
    ++newest_;
    busy_ = false;
    stop_.request_stop();
    pool_.clear();
}

void LatestTask::ask(Work work) {
    cancel();
    busy_ = true;
    stop_ = std::stop_source();
    pool_.start([this, wish = newest_, work = std::move(work), stop = stop_.get_token()] {
        Answer answer;
        try {
            answer = work(stop);
        } catch (const std::exception&) { // out of memory, mostly: there is nothing to show
        }
        QMetaObject::invokeMethod(this, [this, wish, answer = std::move(answer)] {
            if (wish != newest_)
                return;
            busy_ = false;
            if (answer)
                answer();
        });
    });
}

} // namespace tp
