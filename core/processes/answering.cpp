// SPDX-License-Identifier: Apache-2.0
#include "core/processes/answering.hpp"

#include "core/processes/channel.hpp"

#include <chrono>
#include <utility>
#include <variant>

namespace tp {
namespace {

constexpr int asked_on = 3; ///< the descriptor that ChildProcess gives first
constexpr std::chrono::milliseconds for_ever{-1};

} // namespace

void answer_messages(const Limits& limits, int seconds,
                     const std::function<std::optional<Message>(Message& question)>& answer) {
    Channel channel{given_descriptor(asked_on)};
    Confinement confinement = confine(limits);
    MessageWriter ready;
    ready.add(confinement.problem);
    if (confinement.problem.empty() && confinement.leash.ok())
        ready.hand_over(std::move(confinement.leash));
    if (!channel.send(ready.take()) || !confinement.problem.empty())
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
