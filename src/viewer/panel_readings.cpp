// What the run does, in numbers with units. Readings of the wall clock show a dash where pictures must repeat.
#include "panels.hpp"

#include <cstdarg>
#include <cstdio>

namespace drapeau {

namespace {

constexpr const char* none = "\xe2\x80\x93";

[[gnu::format(printf, 1, 2)]] std::string written(const char* format, ...) {
    char text[160];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

std::string share_of_limit(double share) {
    return share < 10.0 ? written("%.0f %% of the limit", 100.0 * share) : written("%.3g times the limit", share);
}

std::string pace_of(const Session& session) {
    const Status& s = session.status;
    if (s.stands()) return "stopped";
    if (session.paused) return "paused";
    if (!s.clock || s.real_time_factor <= 0.0) return none;
    return written("real time \xc3\x97 %.2f", s.real_time_factor);
}

}  // namespace

void draw_readings(const Session& session, Widgets& widgets) {
    const Status& s = session.status;
    widgets.reading("Time", written("%.2f s   ", s.time) + pace_of(session),
                    "Simulated time, and how fast it passes against the clock on the wall. Below 1 the machine cannot "
                    "keep up, and the flag slows down rather than skip.");
    widgets.reading("Step", s.dt > 0.0 ? written("%.4g ms,  %d per frame", 1000.0 * s.dt, s.steps_per_batch) : none,
                    "The step in use; frames are 1/60 s of simulated time.");
    if (s.stability_limit > 0.0)
        widgets.gauge(
            "Stability", s.dt / s.stability_limit, share_of_limit(s.dt / s.stability_limit),
            "The step against the largest one that is safe for these springs. Past 100 % the run may come apart.");
    else
        widgets.reading("Stability", "no stable step",
                        "This method with these settings gains energy whatever the step.");
    widgets.reading("Work",
                    s.clock ? written("%.3g ms a step", 1000.0 * s.step_seconds) : std::string(none) + " ms a step",
                    "Wall-clock time of one step.");
    widgets.reading("Frame", s.clock ? written("%.1f ms", 1000.0 * s.frame_seconds) : std::string(none) + " ms",
                    "Wall-clock time from picture to picture.");
    const Readings& r = s.readings;
    const double total = r.kinetic_energy + r.spring_energy + r.gravity_energy;
    widgets.reading("Energy", written("%.3f J,  motion %.3f J", total, r.kinetic_energy),
                    "All of it: of motion, of springs, and of height (0 at the flag's top); and that of motion alone.");
    widgets.reading("Stretch",
                    written("%.1f %% most,  %.2f %% mean", 100.0 * r.greatest_stretch, 100.0 * r.mean_stretch),
                    "Of the springs against their rest length.");
}

}  // namespace drapeau
