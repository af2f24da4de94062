// Team: threads that advance one cloth by blocks of rows, with the same bits for any number of them.
//
// Between two blocks lies a seam. Each side keeps a copy of its row at the seam as it was before the step; the springs
// across are evaluated by both sides, from the same numbers in the same order, so nothing is exchanged within a step
// and one barrier a step is enough: copies for step n+1 are written while those of step n are read.
#pragma once

#include "drapeau/state.hpp"
#include "drapeau/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace drapeau {

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

/// Workers that sleep until there is a job and then all do it; the calling thread is one of them, number 0.
class Workers {
public:
    explicit Workers(int threads) {
        for (int n = 1; n < threads; ++n) threads_.emplace_back([this, n] { serve(n); });
    }
    Workers(const Workers&) = delete;
    ~Workers() {
        {
            const std::lock_guard lock(mutex_);
            stop_ = true;
        }
        wake_.notify_all();
        for (auto& thread : threads_) thread.join();
    }

    int count() const { return static_cast<int>(threads_.size()) + 1; }

    /// Runs job(n) on every worker n and returns when all are done.
    void run(const std::function<void(int)>& job) {
        {
            const std::lock_guard lock(mutex_);
            job_ = &job;
            busy_ = static_cast<int>(threads_.size());
            ++jobs_;
        }
        wake_.notify_all();
        job(0);
        std::unique_lock lock(mutex_);
        done_.wait(lock, [this] { return busy_ == 0; });
    }

private:
    void serve(int n) {
        for (long long seen = 0;;) {
            const std::function<void(int)>* job;
            {
                std::unique_lock lock(mutex_);
                wake_.wait(lock, [&] { return stop_ || jobs_ != seen; });
                if (stop_) return;
                seen = jobs_;
                job = job_;
            }
            (*job)(n);
            const std::lock_guard lock(mutex_);
            if (--busy_ == 0) done_.notify_one();
        }
    }

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable wake_, done_;
    const std::function<void(int)>* job_ = nullptr;
    long long jobs_ = 0;
    int busy_ = 0;
    bool stop_ = false;
};

template <class Real>
class Team {
public:
    /// `threads` blocks of a cloth of this shape; fewer if there are not two rows for each.
    Team(int threads, const Cloth<Real>& cloth)
        : workers_(std::clamp(cloth.grid().rows / 2, 1, threads)), barrier_(workers_.count()) {
        const Grid seam_grid{cloth.grid().columns, 2, 1.0, 1.0};
        for (int n = 0; n <= workers_.count(); ++n) {
            starts_.push_back(static_cast<int>(static_cast<long long>(cloth.grid().rows) * n / workers_.count()));
            for (auto& side : seams_) side.emplace_back(seam_grid);
            buffers_.emplace_back(cloth.width());
        }
    }

    int threads() const { return workers_.count(); }

    /// Advances `steps` steps. move(first, last, above, below, step, buffers) advances rows first <= j < last by one
    /// step, given copies of the rows beyond its block as they were before it (null at the cloth's border), which it
    /// may overwrite.
    template <class Move>
    void advance(const Rows<Real>& rows, int steps, const Move& move) {
        for (int n = 0; n < threads(); ++n) copy_out(rows, n, seams_[0]);
        workers_.run([&](int n) {
            for (int step = 0; step < steps; ++step) {
                auto& now = seams_[step % 2];
                const auto above = now[n].view()[0], below = now[n + 1].view()[1];
                move(starts_[n], starts_[n + 1], n > 0 ? &above : nullptr, n + 1 < threads() ? &below : nullptr, step,
                     buffers_[n]);
                copy_out(rows, n, seams_[1 - step % 2]);
                barrier_.wait();
            }
        });
    }

private:
    /// Seam n lies above block n: its row 0 is a copy of the last row above it, its row 1 of the first row below it.
    void copy_out(const Rows<Real>& rows, int block, std::vector<Cloth<Real>>& seams) {
        copy(rows[starts_[block]], seams[block].view()[1], seams[block].width());
        copy(rows[starts_[block + 1] - 1], seams[block + 1].view()[0], seams[block].width());
    }
    static void copy(const Row<Real>& from, const Row<Real>& to, int width) {
        const Real* const source[] = {from.x, from.y, from.z, from.vx, from.vy, from.vz};
        Real* const target[] = {to.x, to.y, to.z, to.vx, to.vy, to.vz};
        for (int c = 0; c < 6; ++c) std::copy_n(source[c], width, target[c]);
    }

    Workers workers_;
    SpinBarrier barrier_;
    std::vector<int> starts_;
    std::vector<Cloth<Real>> seams_[2];
    std::vector<SweepBuffers<Real>> buffers_;
};

}  // namespace drapeau
