// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/processes/channel.hpp"
#include "core/processes/child_process.hpp"
#include "core/processes/message.hpp"
#include "core/processes/shared_memory.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tp {

/// How long a helper is waited for.
struct HelperPatience {
    std::chrono::milliseconds start{20'000}; ///< until it is ready
    std::chrono::milliseconds computed{
        120'000}; ///< of its processor time for one answer: a busy machine takes none away
    std::chrono::milliseconds still{30'000}; ///< in which it computed nothing at all
};

/// Why there is no answer.
enum class NoAnswer : std::uint8_t {
    gone,    ///< it has ended: what it was handed was too much for it
    too_long ///< it was ended after it had taken longer than the patience
};

/// A process of ours that answers messages, one after the other; answering.hpp has the other end.
class Helper {
public:
    /// Waits until it is ready. An error says why it is not: it is not there, or the system does not confine
    /// it.
    static Result<std::unique_ptr<Helper>> start(const std::filesystem::path& program,
                                                 const std::vector<std::string>& words,
                                                 HelperPatience patience);
    Helper(const Helper&) = delete;
    Helper& operator=(const Helper&) = delete;
    ~Helper();

    /// After no answer there never is one.
    std::variant<Message, NoAnswer> ask(const Message& question);
    /// Something that is not answered.
    void tell(const Message& message) { channel_.send(message); }
    /// Whether it can be asked.
    bool alive();
    /// Memory that it has handed over and in which it goes on handing over, for whoever reads its answers.
    std::optional<Mapping>& tray() { return tray_; }

private:
    Helper(Channel channel, ChildProcess process, HelperPatience patience)
        : channel_(std::move(channel)), process_(std::move(process)), patience_(patience) {}
    std::variant<Message, NoAnswer> end(NoAnswer reason);

    Channel channel_;
    ChildProcess process_;
    HelperPatience patience_;
    Descriptor leash_; ///< while that is held it lives; answering.hpp
    std::optional<Mapping> tray_;
    bool ended_ = false;
};

class HelperPool;

/// A helper that nobody else asks meanwhile. Given back when this ends, if it still lives.
class HelperLease {
public:
    HelperLease(std::unique_ptr<Helper> helper, HelperPool& pool)
        : helper_(std::move(helper)), pool_(&pool) {}
    HelperLease(HelperLease&&) noexcept = default;
    HelperLease& operator=(HelperLease&&) = delete;
    ~HelperLease();

    Helper* operator->() const { return helper_.get(); }

private:
    std::unique_ptr<Helper> helper_;
    HelperPool* pool_;
};

/// Helpers, one for each thread that asks at the same time. The first is started when it is first needed.
/// Then it stays, warm. One that ends takes nobody else's work along. It must outlive its leases. For several
/// threads.
class HelperPool {
public:
    /// Each is `program`, started with these words.
    explicit HelperPool(std::filesystem::path program, std::vector<std::string> words = {},
                        HelperPatience patience = {});

    Result<HelperLease> lease();

private:
    friend class HelperLease;
    void give_back(std::unique_ptr<Helper> helper);

    const std::filesystem::path program_;
    const std::vector<std::string> words_;
    const HelperPatience patience_;
    const std::size_t most_idle_; ///< as many as this computer has cores
    std::mutex mutex_;
    std::vector<std::unique_ptr<Helper>> idle_;
};

} // namespace tp
