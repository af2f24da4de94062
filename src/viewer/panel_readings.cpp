// What the run does, in numbers with units. Readings of the wall clock show a dash where pictures must repeat.
#include "panels.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
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

std::string pace_of(const Session& session) {
    const Status& s = session.status;
    if (s.stands()) return "stopped";
    if (session.paused) return "paused";
    if (!s.clock || s.real_time_factor <= 0.0) return none;
    return written("real time \xc3\x97 %.2f", s.real_time_factor);
}

std::string joules(double energy) {
    return std::abs(energy) < 100.0 ? written("%.3f J", energy) : written("%.4g J", energy);
}

bool tells_lowered(const Status& s) {
    return !s.lowered_because.empty() && !s.stands();
}

// The step against the closed bound, coloured by what the method does to the energy too.
void show_stability(const Status& s, Widgets& widgets) {
    constexpr double close_to_limit = 0.92, much_created = 0.1;
    constexpr const char* tip =
        "The step as a share of the largest that is stable for these springs and this damping. Past it the run "
        "diverges. \"energy +12 %\": the method created that share of the energy there is; a smaller step creates "
        "less.";
    using enum Widgets::Mood;
    const double created = s.readings.created_share;
    Widgets::Mood mood = created > Ledger::broken_share ? bad : created > much_created ? close : calm;
    const std::string energy = mood == calm ? "" : written(",  energy +%.0f %%", 100.0 * created);
    if (s.stability_limit.is_finite()) {
        const double share = s.dt / s.stability_limit.seconds();
        if (share > 1.0)
            mood = bad;
        else if (share > close_to_limit && mood == calm)
            mood = close;
        const std::string text =
            share < 10.0 ? written("%.0f %% of the limit", 100.0 * share) : written("%.3g times the limit", share);
        widgets.gauge("Stability", share, mood, energy.empty() ? text : written("%.0f %%", 100.0 * share) + energy,
                      tip);
    } else if (s.stability_limit.is_none()) {
        widgets.reading("Stability", "no stable step",
                        "With these settings this method gains energy whatever the step. More drag, friction or "
                        "damping, or another method, helps.",
                        mood == calm ? close : mood);
    } else {
        widgets.reading("Stability", "any step is stable" + energy, tip, mood);
    }
    if (tells_lowered(s))
        widgets.remark("Lowered step", as_sentence(s.lowered_because),
                       "The automatic step is smaller than usual for as long as the method would create energy with a "
                       "larger one. Smaller steps take more time.");
}

void show_limit(const PassReport& did, double limit, Widgets& widgets) {
    constexpr const char* tip =
        "The longest spring after the stretch limit was applied, against the limit, and how often all springs were "
        "gone through in the last frame. Attachments that are too far apart can make the limit impossible to meet.";
    const std::string found = written("%.1f %% of %.1f %%", 100.0 * std::max(0.0, did.max_stretch), 100.0 * limit);
    if (did.max_stretch <= -1.0)
        widgets.reading("Limit", none, tip);
    else if (!did.met)
        widgets.reading("Limit", found + ", not met", tip, Widgets::Mood::close);
    else if (did.sweeps < 10000)
        widgets.reading("Limit", found + written(", %lld sweeps", did.sweeps), tip);
    else
        widgets.reading("Limit", found + written(", %lldk sweeps", did.sweeps / 1000), tip);
}

}  // namespace

float readings_height(const Session& session) {
    float lines = 7.6f;
    if (session.status.limit) lines += 1.0f;
    float height = lines * ImGui::GetTextLineHeightWithSpacing();
    if (tells_lowered(session.status)) {
        const std::string remark = as_sentence(session.status.lowered_because);
        height += ImGui::CalcTextSize(remark.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y +
                  ImGui::GetStyle().ItemSpacing.y;
    }
    return height;
}

void draw_readings(const Session& session, Widgets& widgets) {
    const Status& s = session.status;
    widgets.reading("Time", written("%.2f s   ", s.time) + pace_of(session),
                    "Simulated time, and how fast it passes against the wall clock. Below 1 the computer cannot keep "
                    "up: the flag moves slower, but no step is skipped.");
    widgets.reading("Step", s.dt > 0.0 ? written("%.4g ms,  %lld per frame", 1000.0 * s.dt, s.steps_per_batch) : none,
                    "The step in use. A frame is 1/60 s of simulated time.");
    show_stability(s, widgets);
    widgets.reading("Work",
                    s.clock ? written("%.3g ms a step", 1000.0 * s.step_seconds) : std::string(none) + " ms a step",
                    "Wall-clock time of one step.");
    widgets.reading("Frame", s.clock ? written("%.1f ms", 1000.0 * s.frame_seconds) : std::string(none) + " ms",
                    "Wall-clock time from picture to picture.");
    const Readings& r = s.readings;
    const double total = r.kinetic_energy + r.spring_energy + r.gravity_energy;
    widgets.reading(
        "Energy", joules(total) + ",  kinetic " + joules(r.kinetic_energy),
        "Total energy: kinetic, elastic, gravitational (zero at the flag's top); and kinetic energy alone.");
    widgets.reading(
        "Stretch", written("max %.1f %%,  mean %.2f %%", 100.0 * r.max_stretch, 100.0 * r.mean_stretch),
        "How much longer the longest spring is than at rest, and the mean change of length of all springs.");
    if (s.limit) show_limit(r.limit, s.limit->stretch, widgets);
}

}  // namespace drapeau
