// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/quiet_opencv.hpp"

#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>

#include <cstdlib>
#include <iostream>
#include <mutex>

namespace tp {

namespace {

alignas(64) thread_local bool hushed = false; // why aligned: cmake/Compiler.cmake, mold

/// Passes on what goes to std::cerr, except from threads that are hushed.
class Hush final : public std::streambuf {
public:
    explicit Hush(std::streambuf* below) : below_(below) {}
    std::streambuf* below() const { return below_; }

protected:
    int_type overflow(int_type c) override {
        return hushed || traits_type::eq_int_type(c, traits_type::eof())
                   ? traits_type::not_eof(c)
                   : below_->sputc(traits_type::to_char_type(c));
    }
    std::streamsize xsputn(const char* text, std::streamsize size) override {
        return hushed ? size : below_->sputn(text, size);
    }
    int sync() override { return hushed ? 0 : below_->pubsync(); }

private:
    std::streambuf* below_;
};

} // namespace

void quiet_opencv() {
    static std::once_flag once;
    std::call_once(once, [] {
        cv::setNumThreads(1);
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
        static Hush hush(std::cerr.rdbuf());
        std::cerr.rdbuf(&hush);
        std::atexit([] { std::cerr.rdbuf(hush.below()); });
    });
}

HushedThread::HushedThread() : before_(hushed) { hushed = true; }
HushedThread::~HushedThread() { hushed = before_; }

} // namespace tp
