// SPDX-License-Identifier: Apache-2.0
#include "core/processes/helper.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace tp {
namespace {

using std::chrono::milliseconds;

/// Memory for pictures in pages of 2 MB: a picture of 12 megapixel takes 20 000 usual ones, and each is a
/// fault of its own (glibc's manual, Memory Allocation Tunables). Another C library does not heed it.
const std::vector<std::string> large_pages{"GLIBC_TUNABLES=glibc.malloc.hugetlb=1"};

/// How often it is looked whether a helper still computes.
milliseconds look_every(milliseconds still) {
    return std::clamp(still / 8, milliseconds(1), milliseconds(250));
}

Error cannot_start(const std::filesystem::path& program) {
    return {"The program " + program.filename().string() +
            ", which decodes such files, cannot be started: install TouchPhoto again."};
}

} // namespace

Result<std::unique_ptr<Helper>> Helper::start(const std::filesystem::path& program,
                                              const std::vector<std::string>& words,
                                              HelperPatience patience) {
    auto ends = Channel::pair();
    if (!ends)
        return cannot_start(program);
    const std::array given{ends->second.descriptor()};
    auto process = ChildProcess::start(program, words, given, Streams::none, large_pages);
    {
        const Channel theirs = std::move(ends->second); // its alone: where it ends, this end hears of it
    }
    if (!process)
        return cannot_start(program);
    std::unique_ptr<Helper> helper(new Helper(std::move(ends->first), *std::move(process), patience));
    if (!helper->channel_.other_end_is(helper->process_))
        return cannot_start(program);
    auto said = helper->channel_.receive(patience.start);
    Message* const first = std::get_if<Message>(&said);
    if (first == nullptr)
        return cannot_start(program);
    MessageReader ready(*first);
    if (const std::string problem = ready.text(); !problem.empty())
        return Error{"Such files are decoded in a process that can do nothing else, and this system does not "
                     "allow that (" +
                     problem + "): save the picture as JPEG."};
    if (ready.has_descriptor())
        helper->leash_ = ready.descriptor();
    return helper;
}

Helper::~Helper() { process_.kill(); }

std::variant<Message, NoAnswer> Helper::end(NoAnswer reason) {
    process_.kill();
    ended_ = true;
    return reason;
}

std::variant<Message, NoAnswer> Helper::ask(const Message& question) {
    const auto begun = process_.computed();
    if (ended_ || !begun || !channel_.send(question))
        return end(NoAnswer::gone);
    const milliseconds step = look_every(patience_.still);
    auto before = *begun;
    milliseconds still{0};
    while (true) {
        auto said = channel_.receive(step);
        if (Message* const answer = std::get_if<Message>(&said))
            return std::move(*answer);
        if (std::get<Channel::Silence>(said) == Channel::Silence::gone)
            return end(NoAnswer::gone);
        const auto now = process_.computed().value_or(before);
        still = now == before ? still + step : milliseconds(0);
        before = now;
        if (now - *begun > patience_.computed || still >= patience_.still)
            return end(NoAnswer::too_long);
    }
}

bool Helper::alive() {
    if (ended_ || !process_.computed())
        return false;
    const auto said = channel_.receive(milliseconds(0)); // unasked it says nothing
    const auto* const silence = std::get_if<Channel::Silence>(&said);
    return silence != nullptr && *silence == Channel::Silence::not_yet;
}

HelperLease::~HelperLease() {
    if (helper_)
        pool_->give_back(std::move(helper_));
}

HelperPool::HelperPool(std::filesystem::path program, std::vector<std::string> words, HelperPatience patience)
    : program_(std::move(program)), words_(std::move(words)), patience_(patience),
      most_idle_(std::max(1U, std::thread::hardware_concurrency())) {}

Result<HelperLease> HelperPool::lease() {
    while (true) {
        std::unique_ptr<Helper> helper;
        {
            const std::lock_guard lock(mutex_);
            if (idle_.empty())
                break;
            helper = std::move(idle_.back());
            idle_.pop_back();
        }
        if (helper->alive()) // the system may have ended it meanwhile
            return HelperLease(std::move(helper), *this);
    }
    auto helper = Helper::start(program_, words_, patience_);
    return helper ? Result<HelperLease>(HelperLease(std::move(helper).value(), *this))
                  : Error{helper.error()};
}

void HelperPool::give_back(std::unique_ptr<Helper> helper) {
    if (!helper->alive())
        return;
    const std::lock_guard lock(mutex_);
    if (idle_.size() < most_idle_)
        idle_.push_back(std::move(helper));
}

} // namespace tp
