// What a kept moment says of itself.
#include "run/simulation_run.hpp"

#include <utility>

namespace drapeau {

namespace {

constexpr std::size_t besides_masses = 6000;  // bytes, of the scene, the watch and its ledgers, about

}  // namespace

KeptRun::KeptRun(std::unique_ptr<const Parts> parts) : parts_(std::move(parts)) {}
KeptRun::~KeptRun() = default;

double KeptRun::time() const {
    return parts_->run.now.time();
}

const Scene& KeptRun::scene() const {
    return parts_->run.scene;
}

void KeptRun::snapshot(Snapshot& into) const {
    parts_->masses->snapshot(into.position);
    into.time = time();
    into.steps = parts_->run.now.steps;
}

void KeptRun::velocity(Snapshot& into) const {
    parts_->masses->velocity(into.velocity);
}

void KeptRun::each_part(const std::function<void(const void*, std::size_t)>& visit) const {
    visit(this, besides_masses + parts_->masses->bytes());
    for (const auto& good : parts_->good)
        if (good) visit(good.get(), good->bytes());
    if (parts_->errors.question) visit(parts_->errors.question.get(), parts_->errors.question->bytes());
}

}  // namespace drapeau
