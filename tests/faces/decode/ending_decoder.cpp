// SPDX-License-Identifier: Apache-2.0
// A decoder that ends in the middle of whatever it is asked, as one does whose library was brought down by a
// file.
#include "core/processes/answering.hpp"

#include <cstdint>
#include <cstdlib>

int main() {
    tp::answer_messages({std::uint64_t{1} << 30, 16}, 10,
                        [](tp::Message&) -> std::optional<tp::Message> { std::abort(); });
}
