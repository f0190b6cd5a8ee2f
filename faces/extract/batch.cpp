// SPDX-License-Identifier: Apache-2.0
#include "faces/extract/batch.hpp"

#include <condition_variable>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>

namespace tp {
namespace {

constexpr std::size_t ahead_per_thread = 8; ///< results that may wait for a slower predecessor

/// What the threads of a batch share.
class Batch {
public:
    Batch(const std::vector<std::filesystem::path>& photos, std::size_t threads,
          const std::atomic<bool>& stop)
        : photos_(photos), ahead_(ahead_per_thread * threads), stop_(stop), working_(threads) {}

    /// Extracts one photograph after the other until there is none left to begin.
    void work(FaceExtractor& extractor) {
        std::unique_lock lock(mutex_);
        for (;;) {
            room_.wait(lock, [&] { return ended() || begun_ < taken_ + ahead_; });
            if (ended())
                break;
            const std::size_t index = begun_++;
            lock.unlock();
            Extraction found = extractor.extract(photos_[index]);
            lock.lock();
            waiting_.emplace(index, std::move(found));
            news_.notify_one();
        }
        --working_;
        news_.notify_one();
    }

    /// For a thread that could not be started.
    void count_out(std::size_t threads) {
        const std::lock_guard lock(mutex_);
        working_ -= threads;
    }

    /// Hands over what is finished, in order, until nothing more will come; how many that were.
    std::size_t hand_over(const TakeExtraction& take) {
        std::unique_lock lock(mutex_);
        for (;;) {
            news_.wait(lock, [&] { return waiting_.contains(taken_) || working_ == 0; });
            const auto next = waiting_.find(taken_);
            if (next == waiting_.end() || refused_)
                break;
            const Extraction found = std::move(next->second);
            waiting_.erase(next);
            lock.unlock();
            const bool wanted = take(taken_, found);
            lock.lock();
            refused_ = !wanted;
            ++taken_;
            room_.notify_all();
        }
        return taken_;
    }

private:
    bool ended() const { return refused_ || begun_ == photos_.size() || stop_.load(); }

    const std::vector<std::filesystem::path>& photos_;
    const std::size_t ahead_;
    const std::atomic<bool>& stop_;

    std::mutex mutex_; ///< guards all below
    std::condition_variable room_, news_;
    std::size_t begun_ = 0;
    std::size_t taken_ = 0; ///< changed by the calling thread only
    std::size_t working_;
    bool refused_ = false;
    std::map<std::size_t, Extraction> waiting_;
};

} // namespace

Result<std::size_t> extract_batch(std::vector<FaceExtractor> extractors,
                                  const std::vector<std::filesystem::path>& photos,
                                  const TakeExtraction& take, const std::atomic<bool>& stop) {
    Batch batch(photos, extractors.size(), stop);
    std::vector<std::jthread> threads; // joined before anything they use is gone
    for (FaceExtractor& extractor : extractors) {
        try {
            threads.emplace_back([&batch, &extractor] { batch.work(extractor); });
        } catch (const std::system_error&) {
            break;
        }
    }
    if (threads.empty())
        return Error{"The system gives this program no thread to work on; close other programs."};
    batch.count_out(extractors.size() - threads.size());
    return batch.hand_over(take);
}

} // namespace tp
