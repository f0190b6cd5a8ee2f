// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/seen/seen_photo.hpp"

#include <string>
#include <vector>

namespace tp {

/// Why nobody guesses from a face who it is (faces/identity/unfit.hpp).
enum class NoGuess {
    none, ///< it may be guessed
    no_contours,
    too_small,
    cut_off,
    in_profile,
    covered,
    blurred,
    no_numbers ///< the net gave none
};

/// By what a face is known again.
struct FaceMark {
    NoGuess why = NoGuess::none;
    std::string numbers; ///< as bytes (faces/identity/descriptor.hpp); empty where nobody guesses

    bool operator==(const FaceMark&) const = default;
};

/// What a look at a photograph found.
struct Looked {
    SeenPhoto seen;
    std::vector<FaceMark>
        marks; ///< one for each of the faces that were seen; none where they were not asked for
};

} // namespace tp
