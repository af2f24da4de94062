#include "run_messages.hpp"

namespace drapeau {

using Cause = Message::Cause;

RunMessages::Answer RunMessages::hear(const Moment& moment, long long wanted, Message& message) {
    hear_standstill(moment, message);
    hear_lowered(moment, message);
    if (moment.refused_revision > refused_) {
        refused_ = moment.refused_revision;
        if (refused_ != wanted) return Answer::none;
        message = {.text = moment.refusal, .cause = Cause::refusal};
        return Answer::refused;
    }
    if (moment.revision > taken_) {
        taken_ = moment.revision;
        if (taken_ != wanted) return Answer::none;
        close_if(message, Cause::refusal);
        return Answer::taken;
    }
    return Answer::none;
}

void RunMessages::hear_standstill(const Moment& moment, Message& message) {
    if (!moment.stands()) {
        if (stands_ >= 0) close_if(message, Cause::standstill);
        stands_ = -1;
        return;
    }
    const std::string& why = moment.divergence ? moment.divergence->message : moment.failure;
    const long long revision = moment.divergence ? moment.revision : moment.failed_revision;
    if (stands_ == revision && told_ == why) return;
    stands_ = revision;
    told_ = why;
    message = {.text = why, .cause = Cause::standstill};
}

// Once a scene, and not in the place of another message: the panel goes on showing it.
void RunMessages::hear_lowered(const Moment& moment, Message& message) {
    if (moment.lowered_because.empty() || moment.stands() || moment.revision == lowered_ || !message.text.empty())
        return;
    lowered_ = moment.revision;
    message = {
        .text = as_sentence(moment.lowered_because), .trouble = false, .seconds_left = 10.0, .cause = Cause::lowered};
}

}  // namespace drapeau
