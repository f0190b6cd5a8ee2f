// SPDX-License-Identifier: Apache-2.0
#include "uhid_port.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <span>
#include <string>
#include <unistd.h>

namespace tp::vm {

namespace {

bool tell(int file, const uhid_event& event) {
    if (::write(file, &event, sizeof event) == static_cast<ssize_t>(sizeof event))
        return true;
    std::perror("/dev/uhid");
    return false;
}

template <std::size_t size>
void put(const std::string& text, __u8 (&place)[size]) {
    std::memcpy(place, text.data(), std::min(text.size(), size - 1));
}

} // namespace

bool UhidPort::plug_in() {
    const HidModel::Identity identity = model_.identity();
    uhid_event event{};
    event.type = UHID_CREATE2;
    uhid_create2_req& create = event.u.create2;
    put(identity.name, create.name);
    put(identity.serial_number, create.uniq);
    create.bus = identity.bus;
    create.vendor = identity.vendor;
    create.product = identity.product;
    create.rd_size = static_cast<__u16>(identity.report_descriptor.size());
    std::memcpy(create.rd_data, identity.report_descriptor.data(), identity.report_descriptor.size());
    file_ = ::open("/dev/uhid", O_RDWR | O_CLOEXEC);
    if (file_ < 0)
        std::perror("/dev/uhid");
    return file_ >= 0 && tell(file_, event);
}

void UhidPort::unplug() {
    if (file_ < 0)
        return;
    uhid_event event{};
    event.type = UHID_DESTROY;
    tell(file_, event);
    ::close(file_);
    file_ = -1;
}

bool UhidPort::take_in() {
    uhid_event event{};
    if (::read(file_, &event, sizeof event) <= 0)
        return errno == EINTR;
    if (event.type == UHID_OUTPUT) {
        model_.output(std::span(event.u.output.data, event.u.output.size));
        return true;
    }
    uhid_event reply{};
    if (event.type == UHID_GET_REPORT) {
        const uhid_get_report_req& asked = event.u.get_report;
        const auto report = asked.rtype == UHID_FEATURE_REPORT ? model_.feature(asked.rnum)
                            : asked.rtype == UHID_INPUT_REPORT ? model_.input_now(asked.rnum)
                                                               : std::nullopt;
        reply.type = UHID_GET_REPORT_REPLY;
        reply.u.get_report_reply.id = asked.id;
        reply.u.get_report_reply.err = report ? 0 : EIO;
        if (report) {
            reply.u.get_report_reply.size = static_cast<__u16>(report->size());
            std::copy(report->begin(), report->end(), reply.u.get_report_reply.data);
        }
        return tell(file_, reply);
    }
    if (event.type == UHID_SET_REPORT) {
        const std::span report(event.u.set_report.data, event.u.set_report.size);
        bool taken = event.u.set_report.rtype == UHID_OUTPUT_REPORT;
        if (taken)
            model_.output(report);
        else
            taken = event.u.set_report.rtype == UHID_FEATURE_REPORT && model_.set_feature(report);
        reply.type = UHID_SET_REPORT_REPLY;
        reply.u.set_report_reply.id = event.u.set_report.id;
        reply.u.set_report_reply.err = taken ? 0 : EIO;
        return tell(file_, reply);
    }
    return true; // started, opened, closed: nothing to do
}

bool UhidPort::pass_on() {
    HidModel::Bytes report;
    while (model_.input(report)) {
        uhid_event event{};
        event.type = UHID_INPUT2;
        event.u.input2.size = static_cast<__u16>(report.size());
        std::copy(report.begin(), report.end(), event.u.input2.data);
        if (!tell(file_, event))
            return false;
    }
    return true;
}

} // namespace tp::vm
