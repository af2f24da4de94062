// Recording: a film under way. The flight gives the masses of its frames, whoever draws takes one, draws it and hands
// the picture back, the writer encodes it: three threads that wait for each other only where a queue is full.
#pragma once

#include "film_flight.hpp"
#include "film_writer.hpp"

#include <optional>
#include <string>

namespace drapeau {

class Recording {
public:
    /// Throws InputError if the film cannot be made. `asked_by`: "--record", or nothing.
    Recording(const FilmPlan& plan, const Scene& scene, std::optional<Fork> start, const std::string& asked_by)
        : plan_(plan), writer_(plan, asked_by), flight_(plan, scene, std::move(start)) {}

    const FilmPlan& plan() const { return plan_; }

    /// The next frame to draw, if it has flown and there is room for its picture.
    std::optional<FilmFrame> take() { return writer_.has_room() ? flight_.take() : std::nullopt; }
    void add(Image picture) { writer_.add(std::move(picture)); }

    /// Until there may be something to do; at most so many seconds.
    void wait(double seconds) {
        if (writer_.has_room())
            flight_.wait(seconds);
        else
            writer_.wait(seconds);
    }
    void wait_for_writer(double seconds) { writer_.wait(seconds); }

    double share() const { return double(writer_.written()) / double(plan_.frames()); }
    long long written() const { return writer_.written(); }
    bool done() const { return writer_.done(); }
    /// Why the film cannot be made; empty while it can.
    std::string trouble() const {
        const std::string writing = writer_.trouble();
        return writing.empty() ? flight_.trouble() : writing;
    }
    bool diverged() const { return flight_.diverged(); }

private:
    FilmPlan plan_;
    FilmWriter writer_;  // before the flight: what cannot be written need not fly
    FilmFlight flight_;
};

}  // namespace drapeau
