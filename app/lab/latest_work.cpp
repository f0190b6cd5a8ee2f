// SPDX-License-Identifier: Apache-2.0
#include "app/lab/latest_work.hpp"

#include <QMetaObject>

#include <utility>

namespace tp {

LatestWork::LatestWork() { pool_.setMaxThreadCount(1); }

LatestWork::~LatestWork() {
    cancel();
    pool_.waitForDone();
}

void LatestWork::cancel() {
    ++newest_;
    busy_ = false;
    stop_.request_stop();
    pool_.clear();
}

void LatestWork::ask(Work work) {
    cancel();
    busy_ = true;
    stop_ = std::stop_source();
    pool_.start([this, request = newest_.load(), work = std::move(work), stop = stop_.get_token()] {
        if (request != newest_)
            return;
        Done done = work(stop);
        QMetaObject::invokeMethod(this, [this, request, done = std::move(done)] {
            if (request != newest_)
                return;
            busy_ = false;
            done();
        });
    });
}

} // namespace tp
