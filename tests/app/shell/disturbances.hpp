// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device_socket.hpp"
#include "places.hpp"
#include "whole_program.hpp"

#include <QMetaObject>
#include <QProcess>
#include <QString>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

/// What happens around a program that is used all day, one thing at random each time; the same for the same seed.
class Disturbances {
public:
    Disturbances(WholeProgram& whole, tp::testing::DeviceSocket& device, unsigned seed)
        : whole_(whole), device_(device), random_(seed) {}

    void let_something_happen() {
        switch (below(10)) {
        case 0: return device_comes_or_goes();
        case 1: return hand_moves();
        case 2: return voice_comes_or_goes();
        case 3: return loudspeakers_come_or_go();
        case 4: return microphone_comes_or_goes();
        case 5: return photograph_comes();
        case 6: return photograph_goes();
        case 7: return photograph_is_moved();
        case 8: return sidecar_is_changed();
        default: return below(20) == 0 ? computer_sleeps() : hand_moves();
        }
    }
    const char* last() const { return last_; }

    /// What sounds goes on sounding, and a microphone that is on hears. Nobody remembers what was heard.
    void let_sound_pass(double seconds) {
        for (tp::testing::FakeLoudspeaker* one : whole_.loudspeakers) {
            one->play(seconds);
            one->heard.clear();
            one->runs.clear();
        }
        whole_.voice.clear();
        with_microphone([seconds](tp::testing::FakeMicrophone& microphone) { microphone.hear_nothing(seconds); });
    }

private:
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    std::filesystem::path album() const { return whole_.file("Family"); }
    std::filesystem::path spare(int number) const { return album() / ("spare " + std::to_string(number) + ".jpg"); }

    void device_comes_or_goes() {
        last_ = "device";
        (plugged_ = !plugged_) ? device_.plug_in() : device_.unplug();
    }
    void hand_moves() {
        last_ = "hand";
        device_.hold_at({below(200) - 100.0, below(150) + 25.0});
    }
    void voice_comes_or_goes() {
        last_ = "voice";
        using State = tp::Voice::State;
        whole_.voice.set_state(whole_.voice.state() == State::ready ? State::missing : State::ready);
    }
    void loudspeakers_come_or_go() {
        last_ = "loudspeakers";
        for (tp::testing::FakeLoudspeaker* one : whole_.loudspeakers)
            one->there ? one->vanish() : one->come();
    }
    void microphone_comes_or_goes() {
        last_ = "microphone";
        with_microphone([](tp::testing::FakeMicrophone& microphone) { microphone.there ? microphone.vanish() : microphone.come(); });
    }
    template <typename Deed>
    void with_microphone(Deed deed) {
        if (tp::testing::FakeMicrophone* const microphone = whole_.microphone)
            QMetaObject::invokeMethod(microphone, [microphone, deed] { deed(*microphone); });
    }

    void photograph_comes() {
        last_ = "a new photograph";
        copy(tp::test::in_source("resources/samples/clara_sad.jpg"), spare(below(spares)));
    }
    /// A spare one, or one that was taken or imported: else the album would grow, and with it what is held of it.
    void photograph_goes() {
        last_ = "a lost photograph";
        std::filesystem::remove(spare(below(spares)), ignored_);
        std::vector<std::filesystem::path> others;
        for (const auto& one : std::filesystem::recursive_directory_iterator(album(), ignored_))
            if (one.path().extension() == ".jpg" && !whole_.came_with(one.path().filename().string()))
                others.push_back(one.path());
        std::ranges::sort(others); // the order of a folder is the disk's
        if (others.size() > spares)
            std::filesystem::remove(others[static_cast<std::size_t>(below(static_cast<int>(others.size())))],
                                    ignored_);
    }
    void photograph_is_moved() {
        last_ = "a moved photograph";
        std::filesystem::rename(spare(below(spares)), spare(below(spares)), ignored_);
    }
    /// By another program, which writes what it likes.
    void sidecar_is_changed() {
        last_ = "a sidecar of another program";
        std::ofstream(spare(below(spares)).string() + ".xmp")
            << (below(4) == 0 ? "<broken"
                              : "<x:xmpmeta xmlns:x='adobe:ns:meta/'><rdf:RDF "
                                "xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'><rdf:Description "
                                "xmlns:dc='http://purl.org/dc/elements/1.1/'><dc:description><rdf:Alt><rdf:li "
                                "xml:lang='x-default'>By the lake</rdf:li></rdf:Alt></dc:description></rdf:Description>"
                                "</rdf:RDF></x:xmpmeta>");
    }
    void copy(const std::filesystem::path& from, const std::filesystem::path& to) {
        std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing, ignored_);
    }

    /// To the program the clocks jump, as they do while a computer sleeps.
    void computer_sleeps() {
        last_ = "sleep";
        QProcess::startDetached("sh", {"-c", "sleep 0.3; kill -CONT " + QString::number(::getpid())});
        ::raise(SIGSTOP);
    }

    static constexpr int spares = 6; ///< photographs that come and go
    WholeProgram& whole_;
    tp::testing::DeviceSocket& device_;
    std::mt19937 random_;
    std::error_code ignored_; ///< what is not there cannot go
    bool plugged_ = false;
    const char* last_ = "";
};
