// SPDX-License-Identifier: Apache-2.0
#include "app/parts/work/newest_work.hpp"

#include <QMetaObject>

#include <exception>
#include <utility>

namespace tp {

NewestWork::NewestWork() { pool_.setMaxThreadCount(1); }

NewestWork::~NewestWork() {
    cancel();
    pool_.waitForDone();
}

void NewestWork::cancel() {
    ++newest_;
    busy_ = false;
    stop_.request_stop();
    pool_.clear();
}

void NewestWork::ask(Work work) {
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
