// What a sweep's points are judged by, taken out of it and put into another that is to be reported.
#include "measure/trade_sweep.hpp"

#include <utility>

namespace drapeau {

TradeBasis TradeSweep::basis() const {
    const Stretch& stretch = grounds_.front().stretch;
    TradeBasis basis{stretch.time, stretch.batches, is_shortened_, growth_, reference_tip_, {}};
    for (const Ground& ground : grounds_) {
        const ReferenceFlight& r = ground.reference;
        basis.references.push_back({r.rk4_steps, r.leapfrog_steps, r.rk4_error, r.leapfrog_error, r.methods_apart});
    }
    return basis;
}

void TradeSweep::restore(const TradeBasis& basis) {
    request_.batches = basis.batches;
    is_shortened_ = basis.is_shortened;
    growth_ = basis.growth;
    reference_tip_ = basis.tip;
    grounds_.clear();
    for (std::size_t n = 0; n < variants_.size(); ++n) {
        Ground ground{variants_[n], models_[n], {State<double>(1, 1), basis.time, basis.batches, 1}, {}, nullptr};
        const TradeBasis::Reference& r = basis.references.at(n);
        ground.reference.rk4_steps = r.rk4_steps, ground.reference.leapfrog_steps = r.leapfrog_steps;
        ground.reference.rk4_error = r.rk4_error, ground.reference.leapfrog_error = r.leapfrog_error;
        ground.reference.methods_apart = r.methods_apart;
        grounds_.push_back(std::move(ground));
    }
    list_affordable();
}

}  // namespace drapeau
