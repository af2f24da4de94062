// Messages of the run: each cause is told once, when it appears, and its message can be closed.
#include "catch.hpp"

#include "viewer/run_messages.hpp"

using namespace drapeau;

namespace {

using Answer = RunMessages::Answer;

Moment running(long long revision) {
    Moment moment;
    moment.revision = revision;
    return moment;
}
Moment refused(long long revision, long long by_revision, const std::string& why) {
    Moment moment = running(revision);
    moment.refused_revision = by_revision;
    moment.refusal = why;
    return moment;
}
Moment diverged(long long revision, const std::string& why) {
    Moment moment = running(revision);
    moment.divergence = Divergence{};
    moment.divergence->message = why;
    return moment;
}
Moment failed(long long revision, const std::string& why) {
    Moment moment = running(0);
    moment.failure = why;
    moment.failed_revision = revision;
    return moment;
}

Moment lowered(long long revision, const std::string& why) {
    Moment moment = running(revision);
    moment.lowered_because = why;
    return moment;
}

struct Window {
    AppState app;
    RunMessages messages;

    Answer hear(const Moment& moment, long long wanted) { return messages.hear(moment, wanted, app.message); }
    const std::string& shown() const { return app.message.text; }
    void close() { app.message.text.clear(); }
};

}  // namespace

TEST_CASE("a refusal is told once while the run goes on, and closing it closes it") {
    Window window;
    CHECK(window.hear(refused(0, 1, "too large"), 1) == Answer::refused);
    CHECK(window.shown() == "too large");
    CHECK(window.app.message.trouble);
    CHECK(window.app.message.seconds_left == 0.0);
    window.close();
    for (int frame = 0; frame < 100; ++frame) {
        CHECK(window.hear(refused(0, 1, "too large"), 1) == Answer::none);
        CHECK(window.shown().empty());
    }
}

TEST_CASE("the next refusal is told again, in the same words too") {
    Window window;
    window.hear(refused(0, 1, "too large"), 1);
    window.close();
    CHECK(window.hear(refused(0, 2, "too large"), 2) == Answer::refused);
    CHECK(window.shown() == "too large");
}

TEST_CASE("a later message takes a refusal's place and stays") {
    Window window;
    window.hear(refused(0, 1, "too large"), 1);
    say(window.app, Message::Cause::save, "Saved it", false);
    window.hear(refused(0, 1, "too large"), 1);
    CHECK(window.shown() == "Saved it");
    // That the refused scene gave way to a good one is no reason to take it away.
    CHECK(window.hear(running(2), 2) == Answer::taken);
    CHECK(window.shown() == "Saved it");
}

TEST_CASE("a scene that is taken closes the refusal of the one before, and is answered once") {
    Window window;
    window.hear(refused(0, 1, "too large"), 1);
    CHECK(window.hear(running(2), 2) == Answer::taken);
    CHECK(window.shown().empty());
    CHECK(window.hear(running(2), 2) == Answer::none);
}

TEST_CASE("the answer to a scene that is no longer wanted is not told") {
    Window window;
    CHECK(window.hear(refused(0, 1, "too large"), 2) == Answer::none);
    CHECK(window.shown().empty());
    CHECK(window.hear(running(2), 3) == Answer::none);
}

TEST_CASE("a standstill is told once, can be closed, and its message goes when the run goes on") {
    for (const auto& stands : {diverged, failed}) {
        Window window;
        window.hear(stands(0, "it stands"), 0);
        CHECK(window.shown() == "it stands");
        window.close();
        window.hear(stands(0, "it stands"), 0);
        CHECK(window.shown().empty());

        // Again after a change, though no moment between was seen.
        window.hear(stands(1, "it stands"), 1);
        CHECK(window.shown() == "it stands");
        window.hear(running(2), 2);
        CHECK(window.shown().empty());
        window.hear(stands(2, "it stands"), 2);
        CHECK(window.shown() == "it stands");
    }
}

TEST_CASE("a run that goes on leaves other messages alone") {
    Window window;
    window.hear(diverged(0, "it stands"), 0);
    say(window.app, Message::Cause::save, "Saved it", false);
    window.hear(running(1), 1);
    CHECK(window.shown() == "Saved it");
}

TEST_CASE("a refusal while the run stands is told, and the standstill not again") {
    Window window;
    window.hear(diverged(0, "it stands"), 0);
    Moment moment = diverged(0, "it stands");
    moment.refused_revision = 1;
    moment.refusal = "too large";
    CHECK(window.hear(moment, 1) == Answer::refused);
    CHECK(window.shown() == "too large");
    window.hear(moment, 1);
    CHECK(window.shown() == "too large");
}

TEST_CASE("a lowered step is told once a scene, as a sentence that goes by itself") {
    Window window;
    window.hear(lowered(0, "it creates energy"), 0);
    CHECK(window.shown() == "It creates energy.");
    CHECK(!window.app.message.trouble);
    CHECK(window.app.message.seconds_left > 0.0);
    window.close();
    for (const std::string why : {"it creates energy", "", "it creates more energy"}) {
        window.hear(lowered(0, why), 0);
        CHECK(window.shown().empty());
    }
    window.hear(lowered(1, "it creates energy"), 1);
    CHECK(window.shown() == "It creates energy.");
}

TEST_CASE("a lowered step takes no other message's place, and is told once that is closed") {
    Window window;
    window.hear(refused(0, 1, "too large"), 1);
    window.hear(lowered(0, "it creates energy"), 1);
    CHECK(window.shown() == "too large");
    window.close();
    window.hear(lowered(0, "it creates energy"), 1);
    CHECK(window.shown() == "It creates energy.");
}

TEST_CASE("of a run that stands only that is told") {
    Window window;
    Moment moment = diverged(0, "it stands");
    moment.lowered_because = "it creates energy";
    window.hear(moment, 0);
    window.close();
    window.hear(moment, 0);
    CHECK(window.shown().empty());
}

TEST_CASE("what ends a cause closes its message and no other") {
    using Cause = Message::Cause;
    const Cause causes[] = {Cause::image,   Cause::scene,      Cause::save,   Cause::screenshot,
                            Cause::refusal, Cause::standstill, Cause::lowered};
    for (const Cause told : causes)
        for (const Cause ended : causes) {
            AppState app;
            say(app, told, "no such image", true);
            close_if(app.message, ended);
            CHECK(app.message.text == (told == ended ? "" : "no such image"));
        }
}

TEST_CASE("why a run stands can be told again after its message was closed, and goes when the run goes on") {
    Window window;
    window.hear(diverged(0, "it stands"), 0);
    window.app.status.divergence = diverged(0, "it stands").divergence;
    window.close();
    say_why_it_stands(window.app);
    CHECK(window.shown() == "it stands");
    window.hear(diverged(0, "it stands"), 0);
    CHECK(window.shown() == "it stands");
    window.hear(running(1), 1);
    CHECK(window.shown().empty());
}

TEST_CASE("the message box shows what its text holds, also what cannot be seen") {
    AppState app;
    say(app, Message::Cause::save, "Saved /home/a\n\x1b[2J\xFF", false);
    CHECK(app.message.shown() == "Saved /home/a\\n\\x1b[2J\\xff");
}
