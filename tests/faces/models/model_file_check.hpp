// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes taken as a model file of a user: refused in a sentence, or a model that finds
/// nothing but finite places in two small pictures, or throws a std::exception, which the extractor tells.
/// Empty where that holds, else what does not. The fuzzers' and the hostile test's entries.
std::string complaint_about_onnx_file(std::string_view bytes); ///< as a face mesh and as a YuNet
std::string complaint_about_haar_file(std::string_view bytes);
/// Of a facemark these bytes are the beginning: the tables of points 1 to 67 and the weights of one stage of
/// one tree of depth 2 follow them, 70 kilobytes that no search would change for the better.
std::string complaint_about_lbf_file(std::string_view begin);

/// Whether the bytes were taken by the last call of one of these on this thread.
bool last_was_taken();

} // namespace tp::test
