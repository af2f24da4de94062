#include "film_flight.hpp"

#include "batch_track.hpp"
#include "force_scale.hpp"
#include "io/error.hpp"
#include "run/settle.hpp"
#include "run/step_aside.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <utility>
#include <vector>

namespace drapeau {

namespace {

constexpr std::size_t most_ready = 4;  // frames that nobody has drawn yet

struct Diverged {
    std::string message;
};

/// The frames of one flight, in any order that time does not go back in.
class Frames {
public:
    Frames(const FilmPlan& plan, Simulation& run, const std::atomic<bool>& ending)
        : plan_(plan), run_(run), ending_(ending), start_(run.time()), track_(run) {}

    FilmFrame at(long long number) {
        FilmFrame frame;
        const auto divergence = track_.follow(start_ + plan_.time_of(number), frame.snapshot, ending_);
        if (divergence) throw Diverged{divergence->message};
        scale_.follow(run_.recent_readings().rms_spring_force);
        frame.force_scale = scale_.newtons();
        return frame;
    }

private:
    const FilmPlan& plan_;
    Simulation& run_;
    const std::atomic<bool>& ending_;
    double start_;  // s, of the run
    BatchTrack track_;
    ForceScale scale_;
};

}  // namespace

void blend(FieldBuffer<float>& position, const FieldBuffer<float>& other, double share) {
    for (int row = 0; row < position.rows(); ++row)
        for (int column = 0; column < position.columns(); ++column)
            position.set(column, row, (1.0 - share) * position.at(column, row) + share * other.at(column, row));
}

FilmFlight::FilmFlight(const FilmPlan& plan, const Scene& scene, std::optional<Fork> start)
    : plan_(plan), thread_([this, scene, start = std::move(start)]() mutable { work(scene, std::move(start)); }) {}

FilmFlight::~FilmFlight() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wanted_.notify_one();
    thread_.join();
}

std::optional<FilmFrame> FilmFlight::take() {
    std::optional<FilmFrame> next;
    {
        const std::lock_guard lock(mutex_);
        if (ready_.empty()) return next;
        next = std::move(ready_.front());
        ready_.pop_front();
    }
    wanted_.notify_one();
    return next;
}

void FilmFlight::wait(double seconds) {
    std::unique_lock lock(mutex_);
    given_.wait_for(lock, std::chrono::duration<double>(seconds),
                    [this] { return !ready_.empty() || !trouble_.empty(); });
}

std::string FilmFlight::trouble() const {
    const std::lock_guard lock(mutex_);
    return ready_.empty() ? trouble_ : "";
}

bool FilmFlight::diverged() const {
    const std::lock_guard lock(mutex_);
    return diverged_;
}

void FilmFlight::give(FilmFrame frame) {
    std::unique_lock lock(mutex_);
    wanted_.wait(lock, [this] { return ending_ || ready_.size() < most_ready; });
    ready_.push_back(std::move(frame));
    given_.notify_all();
}

void FilmFlight::fly(const Scene& scene, std::optional<Fork> start) {
    Scene begun = scene;
    if (start) begun.flag.start = Start::flat;  // it is not used
    Simulation run(begun, &ending_);
    if (start) run.put(start->state, start->time);
    Frames frames(plan_, run, ending_);
    // What came before the first frame is what a film that loops ends in.
    const long long blended = plan_.blended(), count = plan_.frames();
    std::vector<FilmFrame> beginning;
    for (long long k = 1 - blended; k < 0 && !ending_; ++k) beginning.push_back(frames.at(k));
    for (long long k = 0; k < count && !ending_; ++k) {
        FilmFrame frame = frames.at(k);
        if (const double share = plan_.share_of_beginning(k); share > 0.0)
            blend(frame.snapshot.position, beginning[std::size_t(k - (count - blended) - 1)].snapshot.position, share);
        if (!ending_) give(std::move(frame));
    }
}

// The last word of a flight that cannot go on is why.
void FilmFlight::work(const Scene& scene, std::optional<Fork> start) {
    step_aside();
    std::string trouble;
    bool diverged = false;
    try {
        fly(scene, std::move(start));
    } catch (const Diverged& end) {
        trouble = end.message;
        diverged = true;
    } catch (const SettlingAbandoned&) {
    } catch (const std::bad_alloc&) {
        trouble = "there is not enough memory for the film";
    } catch (const std::exception& failure) {
        trouble = failure.what();
    }
    const std::lock_guard lock(mutex_);
    trouble_ = trouble;
    diverged_ = diverged;
    given_.notify_all();
}

}  // namespace drapeau
