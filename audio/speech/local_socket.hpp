// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tp {

/// A connection with a server of this machine, by the name of its socket. It closes itself; no program that is started
/// meanwhile has it.
class LocalSocket {
public:
    LocalSocket() = default;
    /// Not `ok` where nothing listens there.
    static LocalSocket to(const std::string& path);
    LocalSocket(LocalSocket&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    LocalSocket& operator=(LocalSocket&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~LocalSocket();

    bool ok() const { return number_ >= 0; }
    /// To be watched.
    int number() const { return number_; }
    /// False where it is not `ok`, or the server has gone.
    bool send(std::string_view bytes);
    /// What has come, without waiting: how many bytes; 0 where the server has gone, none where nothing has come.
    std::optional<std::size_t> receive(std::span<char> into);

private:
    int number_ = -1;
};

} // namespace tp
