// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_teller.hpp"

#include <utility>

namespace tp {

void CaptureTeller::tell(const QString& sentence, std::function<void()> then) {
    if (const auto before = std::exchange(then_, std::move(then)))
        before();
    telling_ = true;
    narrator_.tell_then(sentence, [this] { said(); });
}

void CaptureTeller::did(Earcon earcon, const QString& sentence) {
    sound(earcon);
    tell(sentence);
}

void CaptureTeller::silence() {
    narrator_.stop();
    if (telling_)
        said();
}

void CaptureTeller::said() {
    telling_ = false;
    if (const auto then = std::exchange(then_, nullptr))
        then();
    emit fell_silent();
}

} // namespace tp
