// SPDX-License-Identifier: Apache-2.0
#include "faces/exiv2/prepare_exiv2.hpp"

#include <exiv2/exiv2.hpp>

#include <mutex>

namespace tp {

void prepare_exiv2() {
    // Exiv2 keeps its log level and its XMP parser in globals that are not safe to set up from two threads; the
    // parser of XMP needs a lock from us to be used from two.
    static std::once_flag once;
    static std::mutex xmp;
    std::call_once(once, [] {
        Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute);
#if !EXIV2_TEST_VERSION(0, 28, 0) // later ones open HEIC unasked
        Exiv2::enableBMFF();
#endif
        Exiv2::XmpParser::initialize(
            [](void* mutex, bool lock) {
                lock ? static_cast<std::mutex*>(mutex)->lock() : static_cast<std::mutex*>(mutex)->unlock();
            },
            &xmp);
    });
}

} // namespace tp
