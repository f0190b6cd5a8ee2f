// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../hid_node.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tp::mock {

/// A HID device made by umockdev whose feature reports and input reports are the test's.
class HidBed final : public HidNode {
public:
    using Bytes = std::vector<std::uint8_t>;
    struct Answers {
        std::function<bool(std::span<const std::uint8_t>)> set_feature = [](auto) { return false; };
        std::function<Bytes(std::uint8_t)> get_feature = [](auto) { return Bytes{}; }; ///< empty: refused
    };

    HidBed(const HidrawDevice& shown, Answers answers)
        : HidNode(shown, [this, told = std::move(answers)](gulong request, std::span<std::uint8_t> data) {
              return answer(told, request, data);
          }) {}

    void unplug() { vanish(); }
    /// An input report.
    bool say(std::span<const std::uint8_t> report) const {
        return ::write(file(), report.data(), report.size()) == static_cast<ssize_t>(report.size());
    }
    /// Waits for so many bytes of output reports.
    Bytes hear(std::size_t count) const {
        Bytes heard(count);
        for (std::size_t at = 0; at < count;) {
            const ssize_t got = ::read(file(), heard.data() + at, count - at);
            if (got < 0)
                return {};
            at += static_cast<std::size_t>(got);
        }
        return heard;
    }

private:
    int answer(const Answers& answers, gulong request, std::span<std::uint8_t> data) const {
        constexpr unsigned set_feature = 0x06;
        constexpr unsigned get_feature = 0x07;
        if (_IOC_NR(request) == set_feature)
            return answers.set_feature(data) ? static_cast<int>(data.size()) : -1;
        if (_IOC_NR(request) != get_feature)
            return usual_answer(request, data);
        const Bytes told = answers.get_feature(data[0]);
        const std::size_t count = std::min(told.size(), data.size());
        std::copy_n(told.begin(), count, data.begin());
        return count > 0 ? static_cast<int>(count) : -1;
    }
};

} // namespace tp::mock
