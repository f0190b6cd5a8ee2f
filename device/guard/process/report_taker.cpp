// SPDX-License-Identifier: Apache-2.0
#include "device/guard/process/ends.hpp"
#include "device/guard/process/force_taker.hpp"

#include <utility>

namespace tp::guard {

namespace {

constexpr int report_tries = 3; ///< of a report that breaks on the way

void write_reports(const std::vector<Bytes>& reports) {
    for (const Bytes& report : reports)
        for (int i = 0; i < report_tries && !write_all(End::device, report); ++i) {
        }
}

class ReportTaker final : public ForceTaker {
public:
    ReportTaker(std::vector<Bytes> no_force, std::vector<Bytes> at_the_end)
        : no_force_(std::move(no_force)), at_the_end_(std::move(at_the_end)) {}
    bool let_go() override {
        write_reports(no_force_);
        return true;
    }
    void leave(bool may_pull) override {
        if (!may_pull)
            return;
        write_reports(no_force_);
        write_reports(at_the_end_);
    }

private:
    std::vector<Bytes> no_force_;
    std::vector<Bytes> at_the_end_;
};

} // namespace

std::unique_ptr<ForceTaker> report_taker(std::vector<Bytes> no_force, std::vector<Bytes> at_the_end) {
    return std::make_unique<ReportTaker>(std::move(no_force), std::move(at_the_end));
}

} // namespace tp::guard
