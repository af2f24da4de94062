// ThreadChoice: how many of the threads allowed share a step. More of them are faster only while each has a processor
// to itself: where other programs take some, all wait in every step for whichever the system has put aside. Which
// number is fastest is found by trying others now and then: half as many, one alone, twice as many. The flag is the
// same with any.
#pragma once

#include <algorithm>
#include <limits>

namespace drapeau {

class ThreadChoice {
public:
    /// At most so many; the most are tried first.
    explicit ThreadChoice(int most) : most_(std::max(1, most)), best_(most_), now_(most_) {}

    /// For the batch to come.
    int threads() const { return now_; }

    /// What batches take has changed: another flag.
    void forget() {
        now_ = best_;
        batches_ = slow_ = 0;
    }
    /// That batch took so long (s a step).
    void took(double seconds) {
        if (most_ == 1) return;
        if (now_ != best_) {
            judge(seconds);
        } else {
            // What the machine has left for it changes: the newest batches count, and others are tried at once where
            // several in a row are far slower.
            constexpr double remembered = 0.9, far_slower = 1.5;
            constexpr int several = 3;
            slow_ = batches_ > 0 && seconds > far_slower * usual_ ? slow_ + 1 : 0;
            if (slow_ == several) patience_ = first_patience;
            usual_ = batches_ == 0 ? seconds : std::min(seconds, remembered * usual_ + (1.0 - remembered) * seconds);
            if (++batches_ >= patience_) now_ = another();
        }
    }

private:
    /// A trial: the new number stays if it is clearly faster, or else is not tried again for twice as long.
    void judge(double seconds) {
        constexpr double clearly = 0.85;
        constexpr int longest_patience = 1024;  // batches
        batches_ = slow_ = 0;
        if (seconds < clearly * usual_) {
            best_ = now_;
            usual_ = seconds;
            patience_ = first_patience;
            return;
        }
        patience_ = std::min(2 * patience_, longest_patience);
        now_ = best_;
    }
    /// The next of the others in turn.
    int another() {
        for (;;) {
            const int others[] = {best_ / 2, 1, std::min(2 * best_, most_)};
            const int next = others[turn_++ % 3];
            if (next >= 1 && next != best_) return next;
        }
    }

    static constexpr int first_patience = 2;  // batches

    int most_, best_, now_;
    unsigned turn_ = 0;
    int batches_ = 0, patience_ = 8, slow_ = 0;
    double usual_ = std::numeric_limits<double>::infinity();  // s a step, with the best number
};

}  // namespace drapeau
