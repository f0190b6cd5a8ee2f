// SPDX-License-Identifier: Apache-2.0
#include "core/processes/answering_linux.hpp"

#include "core/processes/channel_linux.hpp"

#include <chrono>
#include <string>
#include <utility>
#include <variant>

namespace tp {
namespace {

constexpr int asked_on = 3; ///< the descriptor that ChildProcess gives first
constexpr std::chrono::milliseconds for_ever{-1};

} // namespace

void answer_messages(const Limits& limits, int seconds,
                     const std::function<std::optional<Message>(Message& question)>& answer) {
    Channel channel{Descriptor(asked_on)};
    const std::string problem = confine(limits);
    if (!channel.send(MessageWriter().add(problem).take()) || !problem.empty())
        return;
    while (true) {
        auto said = channel.receive(for_ever);
        Message* const question = std::get_if<Message>(&said);
        if (question == nullptr)
            return;
        compute_no_longer_than(seconds);
        const std::optional<Message> answered = answer(*question);
        if (answered && !channel.send(*answered))
            return;
    }
}

} // namespace tp
