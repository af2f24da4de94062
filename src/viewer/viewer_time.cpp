// The viewer's way through time: how much of it to ask for, and the kept moments that are looked at instead.
#include "viewer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drapeau {

namespace {

constexpr double a_frame = batch_seconds;  // s
constexpr double same_time = 1e-6;         // s

}  // namespace

/// The time (s) of what is looked at, whether kept or newest.
double Viewer::shown_time() const {
    return app_.playback.shown.value_or(newest_.snapshot.time);
}

/// Looks at a kept moment; the run waits meanwhile.
void Viewer::look_at(const KeptMomentPtr& kept) {
    if (!kept) return;
    app_.paused = true;
    app_.playback.shown = kept->time();
    if (std::exchange(looked_at_, kept) != kept) {
        moment_ = *kept->moment;
        kept->run->snapshot(moment_.snapshot);
        moment_.snapshot.velocity = {};
        take_settings_of(moment_);
        picture_changed_ = true;
    }
}

/// Back to the newest moment there is.
void Viewer::look_at_newest() {
    app_.playback.backwards = false;
    if (!std::exchange(app_.playback.shown, std::nullopt)) return;
    looked_at_.reset();
    moment_ = newest_;
    take_settings_of(moment_);
    picture_changed_ = true;
}

/// The panel shows the settings of the moment that is looked at.
void Viewer::take_settings_of(const Moment& moment) {
    if (physics_of(moment.scene) == physics_of(app_.scene)) return;
    Scene kept = moment.scene;
    kept.view = app_.scene.view;
    kept.name = app_.scene.name;
    kept.flag.texture = app_.scene.flag.texture;
    // A size from before another image came stays: the flag is not shaped like that one.
    app_.scene.flag.width = kept.flag.width, app_.scene.flag.height = kept.flag.height;
    keep_proportions();
    if (app_.scene.flag.width != kept.flag.width) kept.view.texture_proportions = false;
    app_.scene = sent_ = kept;
}

/// What the moment looked at becomes: the present, with the settings that the panel shows.
void Viewer::go_on_from_shown() {
    if (!looked_at_) return;
    simulation_.go_on_from(looked_at_, app_.scene, ++revision_);
    sent_ = app_.scene;
    awaited_ = revision_;
    reference_ = {};  // begins anew
    app_.playback.shown.reset();
    app_.playback.backwards = false;
    looked_at_.reset();
}

/// To a time (s) that is kept, or beyond by so many frames more.
void Viewer::step_to(double time) {
    const double now = shown_time();
    KeptMomentPtr kept = simulation_.kept([&](const Timeline& t) { return t.nearest(time); });
    if (kept && time < now && kept->time() > now - same_time)
        kept = simulation_.kept([&](const Timeline& t) { return t.before(now); });
    if (time < now) return look_at(kept);
    app_.paused = true;
    const double newest = newest_.snapshot.time;
    if (kept && kept->time() < now + same_time)
        kept = simulation_.kept([&](const Timeline& t) { return t.after(now); });
    const bool within = time < newest - 0.5 * a_frame;
    if (within && kept && kept->time() < newest - same_time) return look_at(kept);
    look_at_newest();
    if (within) return;
    const auto frames = std::lround((time - newest) / a_frame);
    if (frames > 0 && !app_.status.stands()) simulation_.ask_batches(int(frames));
}

void Viewer::play_backwards(double seconds) {
    Playback& play = app_.playback;
    const double time = std::max(play.from, shown_time() - seconds * play.speed().factor);
    const auto [early, late] =
        simulation_.kept([&](const Timeline& t) { return std::pair(t.at_or_before(time), t.after(time)); });
    if (!early || time <= play.from) {
        play.backwards = false;
        return look_at(simulation_.kept([&](const Timeline& t) { return t.nearest(play.from); }));
    }
    look_at(early);
    play.shown = time;
    if (!late) return;
    Snapshot from, to;
    early->run->snapshot(from);
    late->run->snapshot(to);
    if (wants_velocities()) early->run->velocity(from), late->run->velocity(to);
    interpolate(from, to, (time - from.time) / (to.time - from.time), moment_.snapshot);
    picture_changed_ = true;
}

/// What was asked of time since the last frame. A moment that is looked at is left by going on, by a step of the
/// method, by a setting or by a restart.
void Viewer::travel(double passed) {
    Playback& play = app_.playback;
    const Travel asked = std::exchange(app_.commands.travel, {});
    if (app_.commands.load_scene || opening_) return look_at_newest();
    if (app_.commands.restart) {
        play.shown.reset(), play.backwards = false;
        looked_at_.reset();
        return;
    }
    const auto stop = [&] {
        app_.paused = true;
        play.backwards = false;
        look_at(simulation_.kept([&](const Timeline& t) { return t.nearest(shown_time()); }));
    };
    if (play.backwards && (!app_.paused || asked.backwards))
        stop();
    else if (asked.backwards)
        app_.paused = play.backwards = true;
    if (asked.to || asked.frames || asked.seconds || app_.commands.step) play.backwards = false;
    if (asked.to && *asked.to > play.to - same_time)
        app_.paused = true, look_at_newest();
    else if (asked.to)
        look_at(simulation_.kept([&](const Timeline& t) { return t.nearest(*asked.to); }));
    if (asked.frames || asked.seconds) step_to(shown_time() + asked.frames * a_frame + asked.seconds);
    if (play.backwards) play_backwards(passed);
    if (play.shown && (!app_.paused || app_.commands.step)) go_on_from_shown();
}

/// Asks for as much simulated time as the speed makes of what passed.
void Viewer::ask_for_time(double passed) {
    const double speed = app_.playback.speed().factor, simulated = passed * speed;
    if (repeatable()) return simulation_.ask_batches(1);
    if (!is_slow()) return simulation_.ask_batches(pacer_.batches(simulated, simulation_.backlog(), speed));
    if (slow_.empty()) slow_.add(newest_.snapshot);
    slow_.pass(simulated);
    // As many steps as a picture takes of simulated time, or one that several pictures share.
    const double picture = std::max(simulated, a_frame * speed), dt = std::max(newest_.dt, 1e-9);
    const long long steps = std::max(1LL, std::llround(picture / dt)), batch = std::max(1LL, newest_.steps_per_batch);
    if (!slow_.wants(double(steps) * dt + simulated) || simulation_.backlog() > 0) return;
    if (steps < batch)
        simulation_.ask_part(steps);
    else
        simulation_.ask_batches(int((steps + batch - 1) / batch));
}

bool Viewer::is_slow() const {
    return app_.playback.speed().factor < 1.0 && !repeatable() && runs();
}

/// Takes the newest moment of the run, and shows it unless another is looked at.
void Viewer::receive_moment() {
    const bool fresh = simulation_.take(newest_);
    if (fresh) hear_of_run();
    const bool comes = awaited_ > std::max(newest_.revision, newest_.refused_revision) && newest_.failure.empty();
    if (!app_.playback.shown && !comes) {
        if (fresh && is_slow()) slow_.add(newest_.snapshot);
        const bool ends = !is_slow() && !slow_.empty();
        if (ends) slow_.forget();
        if (fresh || ends) moment_ = newest_;
        if (is_slow() && !slow_.empty()) slow_.show(moment_.snapshot);
        picture_changed_ = picture_changed_ || fresh || ends || is_slow();
    }
    // Where time stands still readings are those of the moment.
    const double now = newest_.snapshot.time;
    if (!runs() && simulation_.idle() && newest_.readings.time != now && std::exchange(read_at_, now) != now)
        simulation_.ask_now();
    const bool other_view = std::exchange(seen_view_, app_.scene.view) != app_.scene.view;
    if (wants_velocities() && looked_at_ && moment_.snapshot.velocity.columns() == 0)
        looked_at_->run->velocity(moment_.snapshot);
    if (std::exchange(picture_changed_, false) || other_view) show_moment();
    receive_history();
}

void Viewer::receive_history() {
    constexpr double plotted = 10.0, margin = 1.0;  // s
    Playback& play = app_.playback;
    const auto history = simulation_.history();
    play.from = history.from, play.to = history.to;
    play.moments = history.moments, play.bytes = history.bytes;
    if (!play.plots) return play.samples.clear();
    const double end = std::max(play.from + plotted, std::min(play.to, shown_time() + plotted - margin));
    play.samples = simulation_.kept([&](const Timeline& t) { return t.samples(end - plotted); });
    std::erase_if(play.samples, [&](const Sample& sample) { return sample.time > end + same_time; });
}

}  // namespace drapeau
