// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/click_stream.hpp"
#include "audio/sound/sound_output.hpp"

#include <QObject>

#include <functional>
#include <memory>

namespace tp {

/// Lets clicks be heard while they are wanted: the loudspeaker runs from `begin` to `end`. Without one nothing is heard and
/// nothing goes wrong; when there is one again it goes on. Lives on the page's thread.
class ClickSound final : public QObject {
    Q_OBJECT
public:
    /// The output must outlive this, which has it to itself. `now`: the clock of the clicks, s; any thread.
    ClickSound(SoundOutput& output, std::function<double()> now, QObject* parent = nullptr);

    /// Where clicks are put, by one thread at a time.
    const std::shared_ptr<ClickList>& list() const { return list_; }
    void begin();
    void end();

private:
    void play();

    SoundOutput& output_;
    std::function<double()> now_;
    std::shared_ptr<ClickList> list_ = std::make_shared<ClickList>();
    quint64 run_ = 0;
    bool wanted_ = false;
};

} // namespace tp
