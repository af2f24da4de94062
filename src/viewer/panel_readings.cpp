// What the run does, in numbers with units. Readings of the wall clock show a dash where pictures must repeat.
#include "panels.hpp"

#include "io/text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace drapeau {

namespace {

constexpr const char* none = "\xe2\x80\x93";

std::string pace_of(const AppState& app) {
    const Status& s = app.status;
    if (s.stands()) return "stopped";
    if (app.playback.backwards) return "backwards";
    if (app.playback.shown) return "looking back";
    if (app.paused) return "paused";
    if (!s.clock || s.real_time_factor <= 0.0) return none;
    return fmt::format("real time × {:.2f}", s.real_time_factor);
}

std::string joules(double energy) {
    return std::abs(energy) < 100.0 ? fmt::format("{:.3f} J", energy) : quantity(energy, "J");
}

std::string per_cent(double share, int decimals) {
    return share < 100.0 ? fmt::format("{:.{}f} %", 100.0 * share, decimals) : fmt::format("{:.3g} times", share);
}

/// What a person should know besides the numbers.
struct Remark {
    const char* label;
    std::string text;
    const char* tip;
};

std::vector<Remark> remarks_on(const AppState& app) {
    const Status& s = app.status;
    std::vector<Remark> remarks;
    if (s.stands()) return remarks;
    if (!s.limit_remark.empty())
        remarks.push_back(
            {"Past the limit", as_sentence(s.limit_remark),
             "The fastest motion that these springs have here and now is found by power iteration, once a "
             "frame. A larger step than it allows makes it grow, at first too small to be seen."});
    if (!s.method_remark.empty())
        remarks.push_back({"Method remark", as_sentence(s.method_remark),
                           "What the method does to the motion by nature. It is less at smaller steps, and none of it "
                           "is in semi-implicit-euler, leapfrog or rk4."});
    if (!s.lowered_because.empty())
        remarks.push_back({"Lowered step", as_sentence(s.lowered_because),
                           "The automatic step is smaller than usual for as long as the method would create energy "
                           "with a larger one. Smaller steps take more time."});
    if (!s.precision_remark.empty())
        remarks.push_back({"Precision remark", as_sentence(s.precision_remark),
                           "A float holds about seven digits of a position. A step so small that a mass moves by less "
                           "than the last of them loses the motion."});
    if (!s.start_remark.empty())
        remarks.push_back({"Start remark", as_sentence(s.start_remark),
                           "A flat flag needs a disturbance to leave its plane in still air. A flag that starts "
                           "hanging settles first, within one to three seconds of work; a coarser grid or softer "
                           "springs need less."});
    constexpr double slow = 3.0;
    if (s.clock && s.times_slower() > slow) {
        const bool forward = s.method == method_id<ForwardEuler>;
        remarks.push_back({"Slow",
                           quantity(s.dt, "s") + " steps: " + rounded(s.times_slower(), 2) +
                               " times slower than real time. " +
                               (forward ? "Semi-implicit-euler takes far larger ones."
                                        : "A coarser grid, softer springs or more mass allow larger steps."),
                           "Every step is computed; simulated time passes more slowly than the clock."});
    }
    return remarks;
}

// The step against the closed bound, coloured by what the method does to the energy too.
void show_stability(const Status& s, Widgets& widgets) {
    constexpr double close_to_limit = 0.92, much_created = 0.1;
    constexpr const char* tip =
        "The step as a share of the largest that is stable for the springs as they are here and now, found once a "
        "frame "
        "by power iteration, within some per cent; and of the bound that holds however the flag is folded, with these "
        "springs "
        "and "
        "this damping. Past the limit noise grows; past the bound it may. \"energy +12 %\": the method created that "
        "share of the energy there is; a smaller step creates less.";
    using enum Widgets::Mood;
    const double created = s.readings.created_share.value_or(0.0);
    Widgets::Mood mood = created > Ledger::broken_share ? bad : created > much_created ? close : calm;
    const std::string energy = mood == calm ? "" : fmt::format(",  energy +{:.0f} %", 100.0 * created);
    if (s.stability_limit.is_finite()) {
        const double of_bound = s.dt / s.stability_limit.seconds();
        const bool has_live = s.live_limit && s.live_limit->is_finite();
        const double share = has_live ? s.dt / s.live_limit->seconds() : of_bound;
        if (share > 1.0)
            mood = bad;
        else if (share > close_to_limit && mood == calm)
            mood = close;
        const auto percent = [](double part) {
            return part < 10.0 ? fmt::format("{:.0f} %", 100.0 * part) : fmt::format("{:.3g} times", part);
        };
        const std::string text =
            has_live ? percent(share) + " of limit, bound " + percent(of_bound) : percent(share) + " of the bound";
        widgets.gauge("Stability", share, mood, energy.empty() ? text : percent(share) + energy, tip);
    } else if (s.stability_limit.is_none()) {
        widgets.reading("Stability", "no stable step",
                        "With these settings this method gains energy at any step. More drag, friction or "
                        "damping, or another method, helps.",
                        mood == calm ? close : mood);
    } else {
        widgets.reading("Stability", "no limit" + energy, tip, mood);
    }
}

/// Why the step is what it is.
void show_step_limit(const Status& s, Widgets& widgets) {
    constexpr std::string_view limit = "limit: ";
    const bool limited = s.step_reason.starts_with(limit);
    widgets.reading(
        "Step limit", limited ? s.step_reason.substr(limit.size()) : "none: the step is given",
        "What keeps the automatic step from being larger: stability, for which springs, dampers or drag ask; "
        "the tolerance, against the error measured; energy that a larger step would create; or 1/60 s.");
}

void show_error(const Status& s, Widgets& widgets) {
    std::string tip =
        "How far the masses stray from the exact motion in a second of simulated time (root mean square). Measured "
        "every "
        "second on a spare thread: a tenth of a second is run again with half the step and with a quarter, and the "
        "differences must shrink as the method's order says.";
    const auto best = s.error ? s.error->best_float_step() : std::nullopt;
    if (best && s.stability_limit.allows(*best))
        tip += "\nIn float, steps of about " + quantity(*best, "s", 2) +
               " are the most accurate: smaller ones lose more to rounding than they gain.";
    if (!s.error || s.stands()) return widgets.reading("Error", none, tip.c_str());
    if (s.error->resolved()) return widgets.reading("Error", rounded(1e3 * s.error->rate, 3) + " mm/s", tip.c_str());
    tip = "Not resolvable: " + s.error->explanation() + ".\n" + tip;
    widgets.reading("Error", "unknown: " + s.error->reason(), tip.c_str(), Widgets::Mood::close);
}

std::string millimetres(double metres) {
    constexpr double least = 1e-6;  // m, about what the picture's floats resolve
    return metres < least ? "< 0.001" : rounded(1e3 * metres, 3);
}

/// How far the flag has gone from its reference, which may be behind it in time.
void show_reference(const Status& s, Widgets& widgets) {
    std::string tip = "Distance of the masses from the reference at equal times, root mean square.";
    if (!s.reference) return widgets.reading("Reference", "begins", tip.c_str());
    const ReferenceGap& gap = *s.reference;
    if (!gap.trouble.empty()) {
        tip = "There is no reference: " + gap.trouble + ".";
        return widgets.reading("Reference", "none", tip.c_str(), Widgets::Mood::close);
    }
    const double passed = gap.time - gap.since, behind = s.time - gap.time;
    tip += fmt::format(
        "\nThe mass furthest from it is {} mm away. The reference is computed by rk4 in double at steps of {}, on a "
        "spare thread, from t = {:.2f} s on. It is at t = {:.2f} s, and so is its wireframe, faint while that is "
        "behind.",
        millimetres(gap.greatest), quantity(gap.dt, "s"), gap.since, gap.time);
    widgets.reading(
        "Reference",
        millimetres(gap.rms) + " mm " +
            (gap.lags(s.time) ? fmt::format("({:.1f} s behind)", behind) : fmt::format("after {:.1f} s", passed)),
        tip.c_str());
}

/// The energy there is, and what of it the method made or lost.
/// Readings of a moment that is looked back at may be a few frames older, which is said.
std::string when_read(const Status& s) {
    constexpr double same_time = 1e-6;  // s
    return s.shows_kept && s.readings.time < s.time - same_time ? fmt::format(" at {:.2f} s", s.readings.time) : "";
}

void show_energy(const Readings& r, const std::string& when, Widgets& widgets) {
    const double total = r.kinetic_energy + r.spring_energy + r.gravity_energy;
    const std::string tip =
        "Kinetic " + joules(r.kinetic_energy) + ", elastic " + joules(r.spring_energy) + ", of height " +
        joules(r.gravity_energy) +
        " (zero at the flag's top).\nCreated or lost by the method: the energy of motion and springs now, less what "
        "there "
        "was and the work of all forces since the settings last changed, as a share of what there was and came in. An "
        "exact method creates none; at 30 % the run is taken for broken. XPBD does not know what its forces did: of it "
        "nothing is said.";
    widgets.reading("Energy",
                    when.empty() && r.created_share
                        ? fmt::format("{},  {:.2g} % {}", joules(total), 100.0 * std::abs(*r.created_share),
                                      *r.created_share < 0.0 ? "lost" : "created")
                        : joules(total) + when,
                    tip.c_str());
}

void show_limit(const PassReport& did, double limit, Widgets& widgets) {
    constexpr const char* tip =
        "The longest spring after the stretch limit was applied, against the limit, and how often all springs were "
        "gone through in the last frame. Attachments that are too far apart can make the limit impossible to meet.";
    const std::string found =
        fmt::format("{:.1f} % of {:.1f} %", 100.0 * std::max(0.0, did.max_stretch), 100.0 * limit);
    if (did.max_stretch <= -1.0)
        widgets.reading("Limit", none, tip);
    else if (!did.met)
        widgets.reading("Limit", found + ", not met", tip, Widgets::Mood::close);
    else if (did.sweeps < 10000)
        widgets.reading("Limit", found + fmt::format(", {} sweeps", did.sweeps), tip);
    else
        widgets.reading("Limit", found + fmt::format(", {}k sweeps", did.sweeps / 1000), tip);
}

}  // namespace

float readings_height(const AppState& app) {
    float lines = 9.6f;
    if (app.status.limit) lines += 1.0f;
    if (app.scene.view.reference) lines += 1.0f;
    float height = lines * ImGui::GetTextLineHeightWithSpacing();
    for (const Remark& remark : remarks_on(app))
        height += ImGui::CalcTextSize(remark.text.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y +
                  ImGui::GetStyle().ItemSpacing.y;
    return height;
}

void draw_readings(const AppState& app, Widgets& widgets) {
    const Status& s = app.status;
    widgets.reading("Time", fmt::format("{:.2f} s   ", s.time) + pace_of(app),
                    "Simulated time, and how fast it passes against the wall clock. Below 1 the computer cannot keep "
                    "up: the flag moves slower, but no step is skipped.");
    widgets.reading("Step", s.dt > 0.0 ? quantity(s.dt, "s") + fmt::format(",  {} per frame", s.steps_per_batch) : none,
                    "The step in use. A frame is 1/60 s of simulated time.");
    show_step_limit(s, widgets);
    show_stability(s, widgets);
    show_error(s, widgets);
    if (app.scene.view.reference) show_reference(s, widgets);
    for (const Remark& remark : remarks_on(app)) widgets.remark(remark.label, remark.text, remark.tip);
    widgets.reading("Work", (s.clock ? quantity(s.step_seconds, "s") : std::string(none)) + " a step",
                    "Wall-clock time of one step.");
    widgets.reading(
        "Frame",
        s.clock ? quantity(s.frame_seconds, "s") + fmt::format(",  own {:.2f} ms", 1e3 * s.own_seconds)
                : std::string(none),
        "Wall-clock time from picture to picture. Own: the processor time of it that the window itself takes, for "
        "input, panels and what the picture is made from, without the graphics driver and the simulation.");
    const Readings& r = s.readings;
    const std::string when = when_read(s);
    show_energy(r, when, widgets);
    widgets.reading(
        "Stretch",
        "max " + per_cent(r.max_stretch, 1) + (when.empty() ? ",  mean " + per_cent(r.mean_stretch, 2) : when),
        "How much longer the longest spring is than at rest, and the mean change of length of all springs.");
    if (s.limit) show_limit(r.limit, s.limit->stretch, widgets);
}

}  // namespace drapeau
