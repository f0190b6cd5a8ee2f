// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/listening.hpp"
#include "app/pages/care/take.hpp"

#include <QObject>

#include <functional>
#include <vector>

namespace tp {

/// What must not happen under a recording that is being made: it waits until that lies on the disk, or is refused.
class RecordingWait final : public QObject {
    Q_OBJECT
public:
    /// All must outlive it.
    RecordingWait(Take& take, Listening& listening, CareTeller& teller);

    /// Ends what sounds; a recording that is being made is ended and kept. False: there was nothing.
    bool stop();
    /// Ends what sounds and does this: once a recording that was being made has asked for its place in the album, in the
    /// order of the calls; at once where there was none.
    void after(std::function<void()> step);
    /// True, and said, while a recording is being made: what it belongs to must stay where it is.
    bool refused();

private:
    void go_on();

    Take& take_;
    Listening& listening_;
    CareTeller& teller_;
    std::vector<std::function<void()>> waiting_;
};

} // namespace tp
