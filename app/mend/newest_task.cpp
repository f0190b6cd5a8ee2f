// SPDX-License-Identifier: Apache-2.0
#include "app/mend/newest_task.hpp"

#include <exception>
#include <utility>

namespace tp {

NewestTask::NewestTask(const QString& thread_name) : worker_(new QObject) {
    thread_.setObjectName(thread_name);
    worker_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, worker_, &QObject::deleteLater);
    thread_.start();
}

NewestTask::~NewestTask() {
    cancel();
    thread_.quit();
    thread_.wait();
}

void NewestTask::start(Work work) {
    cancel();
    stop_ = std::stop_source();
    busy_ = true;
    QMetaObject::invokeMethod(
        worker_, [this, request = newest_.load(), work = std::move(work), stop = stop_.get_token()] {
            if (request != newest_)
                return;
            std::function<void()> answer;
            try {
                answer = work(stop);
            } catch (const std::exception&) { // out of memory: nothing to show
            }
            QMetaObject::invokeMethod(this, [this, request, answer = std::move(answer)] {
                if (request != newest_)
                    return;
                busy_ = false;
                if (answer)
                    answer();
            });
        });
}

void NewestTask::cancel() {
    ++newest_;
    stop_.request_stop();
    busy_ = false;
}

} // namespace tp
