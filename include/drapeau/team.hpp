// Team: threads that run one region of work together: its members meet at a barrier within it and sleep between.
#pragma once

#include "drapeau/isa.hpp"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// A barrier for threads that arrive within microseconds of each other: spins, and gives its core away if that lasts.
class SpinBarrier {
public:
    explicit SpinBarrier(int threads) : threads_(threads), missing_(threads) {}

    void wait() {
        const int turn = turn_.load(std::memory_order_relaxed);
        if (missing_.fetch_sub(1, std::memory_order_acq_rel) == 1) {
            missing_.store(threads_, std::memory_order_relaxed);
            turn_.store(turn + 1, std::memory_order_release);
            return;
        }
        constexpr int patience = 200;  // looks, some ten microseconds
        for (int looks = 0; turn_.load(std::memory_order_acquire) == turn; ++looks) {
            if (looks < patience) {
#if defined(__x86_64__) || defined(__i386__)
                __builtin_ia32_pause();
#endif
            } else {
                std::this_thread::yield();
            }
        }
    }

private:
    int threads_;
    alignas(64) std::atomic<int> missing_;
    alignas(64) std::atomic<int> turn_{0};
};

/// Members that sleep until there is a region to run and then all run it; the calling thread is member 0.
class Team {
public:
    /// Throws std::system_error where the system gives no more threads; those it gave are ended first.
    explicit Team(int members) : barrier_(members) {
        try {
            for (int n = 1; n < members; ++n) threads_.emplace_back([this, n] { serve(n); });
        } catch (...) {
            end();
            throw;
        }
    }
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    ~Team() { end(); }

    int members() const { return static_cast<int>(threads_.size()) + 1; }
    /// Within a region: returns when every member has come here.
    void meet() { barrier_.wait(); }

    /// Runs region(n) on every member n and returns when all are done.
    void run(const std::function<void(int)>& region) {
        {
            const std::lock_guard lock(mutex_);
            region_ = &region;
            busy_ = static_cast<int>(threads_.size());
            ++regions_;
        }
        wake_.notify_all();
        region(0);
        std::unique_lock lock(mutex_);
        done_.wait(lock, [this] { return busy_ == 0; });
    }

private:
    void end() {
        {
            const std::lock_guard lock(mutex_);
            stop_ = true;
        }
        wake_.notify_all();
        for (auto& thread : threads_) thread.join();
        threads_.clear();
    }

    void serve(int n) {
        for (long long seen = 0;;) {
            const std::function<void(int)>* region;
            {
                std::unique_lock lock(mutex_);
                wake_.wait(lock, [&] { return stop_ || regions_ != seen; });
                if (stop_) return;
                seen = regions_;
                region = region_;
            }
            (*region)(n);
            const std::lock_guard lock(mutex_);
            if (--busy_ == 0) done_.notify_one();
        }
    }

    SpinBarrier barrier_;
    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable wake_, done_;
    const std::function<void(int)>* region_ = nullptr;
    long long regions_ = 0;
    int busy_ = 0;
    bool stop_ = false;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
