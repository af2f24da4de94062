// RunMessages: what the window says of the run (message.hpp). A cause is told once, when it appears: closing its
// message closes it, and a later message takes its place. A cause that comes again is told again, one that is gone
// takes its message along. A lowered step is told once a scene.
#pragma once

#include "app_state.hpp"
#include "simulation_thread.hpp"

namespace drapeau {

class RunMessages {
public:
    /// What became of the scene that the window gave last, the first time it is known.
    enum class Answer { none, taken, refused };

    /// Takes in a moment of the run; `wanted` is the revision of the scene given last.
    Answer hear(const Moment& moment, long long wanted, Message& message);

private:
    void hear_standstill(const Moment& moment, Message& message);
    void hear_lowered(const Moment& moment, Message& message);

    long long taken_ = 0, refused_ = -1;  // revisions, the last of each
    long long stands_ = -1;               // revision of a run that stands
    std::string told_;                    // why
    long long lowered_ = -1;              // revision of the scene whose lowered step was told
};

}  // namespace drapeau
