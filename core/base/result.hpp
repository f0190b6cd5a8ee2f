// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace tp {

/// Why something could not be done: one sentence that a person can act on.
struct Error {
    std::string sentence;
};

/// A value, or the sentence that says why there is none. What crosses a room's border instead of an
/// exception.
template <typename T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }

    /// The value; only where ok().
    T& value() & { return std::get<T>(content_); }
    const T& value() const& { return std::get<T>(content_); }
    T&& value() && { return std::get<T>(std::move(content_)); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    /// The sentence; empty where ok().
    std::string error() const { return ok() ? std::string{} : std::get<Error>(content_).sentence; }

private:
    std::variant<T, Error> content_;
};

} // namespace tp
