#include "film_writer.hpp"

#include "io/error.hpp"
#include "io/output_file.hpp"
#include "numbered_name.hpp"
#include "run/step_aside.hpp"

#include <chrono>
#include <exception>
#include <new>
#include <system_error>
#include <utility>

namespace drapeau {

namespace {

constexpr std::size_t most_waiting = 3;  // frames not encoded yet: they are large

/// Where a picture is until all are there: older ones of its name stay until then.
std::filesystem::path unfinished(const std::filesystem::path& picture) {
    return picture.string() + ".part";
}

}  // namespace

FilmWriter::FilmWriter(const FilmPlan& plan, const std::string& asked_by) : plan_(plan) {
    check_film(plan);
    if (means_sequence(plan.file))
        check_writable(numbered(plan.file, 0).string());
    else
        film_.emplace(FilmSettings{.file = plan.file,
                                   .width = plan.width,
                                   .height = plan.height,
                                   .rate = plan.rate,
                                   .transparent = plan.transparent,
                                   .asked_by = asked_by});
    thread_ = std::thread([this] { work(); });
}

FilmWriter::~FilmWriter() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        if (film_ && !done_) film_->give_up();
    }
    wanted_.notify_one();
    thread_.join();
    if (!done_) remove_pictures();
}

bool FilmWriter::has_room() const {
    const std::lock_guard lock(mutex_);
    return waiting_.size() < most_waiting;
}

void FilmWriter::add(Image frame) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(frame));
    }
    wanted_.notify_one();
}

long long FilmWriter::written() const {
    const std::lock_guard lock(mutex_);
    return written_;
}

bool FilmWriter::done() const {
    const std::lock_guard lock(mutex_);
    return done_;
}

std::string FilmWriter::trouble() const {
    const std::lock_guard lock(mutex_);
    return trouble_;
}

void FilmWriter::wait(double seconds) {
    std::unique_lock lock(mutex_);
    const long long before = written_;
    finished_.wait_for(lock, std::chrono::duration<double>(seconds),
                       [&] { return written_ != before || done_ || !trouble_.empty(); });
}

void FilmWriter::write(const Image& frame, long long number) {
    if (film_) return film_->add(frame);
    const auto file = numbered(plan_.file, number);
    pictures_.push_back(file);
    write_png(unfinished(file), frame);
}

void FilmWriter::name_pictures() {
    for (const auto& file : pictures_) std::filesystem::rename(unfinished(file), file);
}

void FilmWriter::remove_pictures() {
    std::error_code ignored;
    for (const auto& file : pictures_) std::filesystem::remove(unfinished(file), ignored);
}

void FilmWriter::work() {
    step_aside(5);
    std::string trouble;
    std::unique_lock lock(mutex_);
    try {
        while (written_ < plan_.frames()) {
            wanted_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            if (ending_) return;
            const Image frame = std::move(waiting_.front());
            waiting_.pop_front();
            const long long number = written_;
            lock.unlock();
            write(frame, number);
            lock.lock();
            ++written_;
            finished_.notify_all();
        }
        lock.unlock();
        film_ ? film_->finish() : name_pictures();
    } catch (const std::bad_alloc&) {
        trouble = "there is not enough memory for the film";
    } catch (const std::exception& failure) {
        trouble = failure.what();
    }
    if (!lock.owns_lock()) lock.lock();
    trouble_ = trouble;
    done_ = trouble.empty();
    finished_.notify_all();
}

}  // namespace drapeau
